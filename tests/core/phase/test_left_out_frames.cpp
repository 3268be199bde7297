// What single frames that are left out make of the estimate: before trackers that err, and before programs
// that drop frames of trackers that are right.

#include "follow.h"
#include "minimum_jerk_drag.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <random>

using namespace steadyhand;
using test::follow;

namespace {

constexpr double ONSET_S = 1.2;
constexpr double NOTICED_S = 0.015; ///< so early a cue is

/// How far the estimate is ahead of the hand on its way, mean, s; lag_s: of the tracker, at the end of the
/// way.
double mean_lead_s(double duration_s, double lag_s, double left_out, std::uint64_t seed) {
	const test::Drag drag{ .onset_s = ONSET_S, .duration_s = duration_s, .amplitude_m = 1.0 };
	PhaseEstimator estimator(test::drag_model());
	std::mt19937_64 random(seed);
	std::normal_distribution<double> trembling(0.0, 5e-4);
	std::bernoulli_distribution is_left_out(left_out);
	double ahead = 0.0, gone = 0.0;
	follow(
			estimator, ONSET_S + duration_s,
			[&](double t_s) -> std::optional<double> {
				const double x = drag.x_m(t_s - lag_s * drag.x_m(t_s)) + trembling(random);
				return is_left_out(random) ? std::nullopt : std::optional(x);
			},
			[&](double t_s, double value) {
				if (drag.x_m(t_s) > 0.2 && drag.x_m(t_s) < 0.95) {
					ahead += value - drag.x_m(t_s);
					gone += (drag.x_m(t_s + 1e-3) - drag.x_m(t_s - 1e-3)) / 2e-3;
				}
			});
	return ahead / gone;
}

double mean_lead_s(double lag_s, double left_out) {
	double sum = 0.0;
	int count = 0;
	for (const double duration_s : { 0.5, 0.8, 1.2 }) {
		for (std::uint64_t seed = 1; seed <= 20; ++seed) {
			sum += mean_lead_s(duration_s, lag_s, left_out, seed);
			++count;
		}
	}
	return sum / count;
}

} // namespace

TEST_CASE("before a tracker that is late, and leaves out frames, the motion is less late than without that "
		  "sign") {
	constexpr double LAG_S = 0.08;
	const double unsuspected = mean_lead_s(LAG_S, 0.0), suspected = mean_lead_s(LAG_S, 0.05);
	CHECK(unsuspected < -0.02);
	CHECK(suspected > unsuspected + 0.01);
	CHECK(suspected < 0.0);
}

TEST_CASE("a program that drops frames of a tracker that is right gets the motion early by a frame's time at "
		  "most") {
	CHECK(std::abs(mean_lead_s(0.0, 0.0)) < 0.005);
	CHECK(mean_lead_s(0.0, 0.01) < 0.005);
	CHECK(mean_lead_s(0.0, 0.05) < NOTICED_S);
	CHECK(mean_lead_s(0.0, 0.2) < NOTICED_S);
}
