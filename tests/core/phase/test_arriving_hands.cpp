// Hands that are first seen away from the task's start, come there, rest, and then make the gesture.

#include "follow.h"
#include "overlapping_drags.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace steadyhand;
using test::Drag, test::follow;

namespace {

/// Of a hand that rests `from` amplitudes from the start for stay_s, comes to it, and rests there for rest_s.
void check_followed(double from, double stay_s, double rest_s) {
	CAPTURE(from);
	CAPTURE(stay_s);
	CAPTURE(rest_s);
	constexpr double COMES_FOR_S = 0.5, GESTURE_S = 0.6;
	const double onset_s = stay_s + COMES_FOR_S + rest_s, until_s = onset_s + GESTURE_S + 0.4;
	const std::vector<Drag> strokes{ { stay_s, COMES_FOR_S, -from }, { onset_s, GESTURE_S, 1.0 } };
	const auto hand = [&](double t_s) { return from + test::x_m(strokes, t_s); };
	PhaseEstimator estimator(test::drag_model());
	double furthest_off = 0.0;
	follow(estimator, until_s, hand, [&](double t_s, double value) {
		furthest_off = std::max(furthest_off, std::abs(value - hand(t_s)));
	});
	CHECK(furthest_off < 0.1);
	CHECK(estimator.at(until_s).phase > 0.97); // the gesture's end
}

} // namespace

TEST_CASE("a hand that comes from elsewhere to the start and rests there is followed as one that was there") {
	for (const double from : { -1.2, -0.5, -0.2, 0.3, 0.6, 1.2 }) {
		for (const double stay_s : { 0.1, 0.6, 1.2 }) {
			for (const double rest_s : { 0.1, 0.3, 0.6, 1.0 }) {
				check_followed(from, stay_s, rest_s);
			}
		}
	}
}
