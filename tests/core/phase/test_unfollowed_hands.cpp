// A hand that is not followed for a while: what the estimator knows of the tracker, and of the hand, when it
// is again.

#include "near.h"
#include "phase/phase_estimator.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr double FRAME_S = 1.0 / 90.0;

/// By how much a value is off at most in the half second after a first frame of x, by clocks that begin at
/// these times.
double apart(double first_s, double second_s, double x) {
	const GestureModel &model = drag_model();
	PhaseEstimator first(model), second(model);
	double most = 0.0;
	for (int frame = 0; frame < 45; ++frame) {
		first.push(first_s + frame * FRAME_S, x);
		second.push(second_s + frame * FRAME_S, x);
		for (const double ahead_s : { 0.0, 0.005 }) {
			const PhaseEstimate one = first.at(first_s + frame * FRAME_S + ahead_s),
								other = second.at(second_s + frame * FRAME_S + ahead_s);
			most = std::max(most, std::abs(one.value - other.value));
		}
	}
	return most;
}

} // namespace

TEST_CASE("at whatever time a clock begins, a first frame says nothing of how fast the hand is") {
	for (const double x : { 0.3, -0.2, 1.0 }) {
		CHECK(apart(0.005, 1000.0, x) < 1e-5);
		CHECK(apart(0.0, -1000.0, x) < 1e-5);
	}
}

TEST_CASE("a hand that is followed again goes on as its last two frames say") {
	for (const double per_s : { 0.0, 2.0, -4.0 }) { // amplitudes
		PhaseEstimator estimator(drag_model());
		double x = 0.5;
		for (int frame = 0; frame < 45; ++frame, x += per_s * FRAME_S) {
			estimator.doze(frame * FRAME_S, x, FeaturePlace::Zero());
		}
		CHECK(estimator.at(0.5).value == 0.0);
		estimator.push(45 * FRAME_S, x);
		const PhaseEstimate now = estimator.at(45 * FRAME_S);
		CHECK(now.value == near(x).epsilon(0.02));
		// It rests as likely as it goes on.
		CHECK(now.velocity == near(0.5 * per_s).epsilon(0.05));
	}
}
