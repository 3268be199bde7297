// Hands that come to the task's start from elsewhere, and hands that rest there before a tracker that repeats
// itself, and then make the gesture.

#include "follow.h"
#include "overlapping_drags.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
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
	double furthest_off = 0.0, begun_where_it_stays = 0.0;
	follow(estimator, until_s, hand, [&](double t_s, double value) {
		furthest_off = std::max(furthest_off, std::abs(value - hand(t_s)));
		if (t_s < stay_s) {
			begun_where_it_stays = std::max(begun_where_it_stays, estimator.at(t_s).moving);
		}
	});
	CHECK(furthest_off < 0.1);
	CHECK(begun_where_it_stays < 0.01);
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

TEST_CASE("a tracker that repeats itself while a hand rests hardly moves the estimate, nor is the gesture "
		  "after it early") {
	// As before trackers that hold their last pose, or round away how the hand trembles.
	const Drag drag{ .onset_s = 2.0, .duration_s = 0.7, .amplitude_m = 1.0 };
	const auto off = [&](double repeats_for_s, std::uint64_t seed) {
		PhaseEstimator estimator(test::drag_model());
		std::mt19937_64 random(seed);
		std::normal_distribution<double> trembling(0.0, 1e-3);
		double shown = 0.0, at_rest = 0.0, ahead = 0.0;
		const auto show = [&](double t_s) {
			const bool repeats = t_s > 1.8 - repeats_for_s && t_s < 1.8;
			shown = repeats ? shown : drag.x_m(t_s) + trembling(random);
			return shown;
		};
		follow(estimator, 2.7, show, [&](double t_s, double value) {
			double &worst = t_s < drag.onset_s ? at_rest : ahead;
			worst = std::max(worst, value - drag.x_m(t_s));
		});
		return std::pair(at_rest, ahead);
	};
	for (const double repeats_for_s : { 0.0, 0.1, 0.2, 0.3 }) {
		for (std::uint64_t seed = 1; seed <= 5; ++seed) {
			CAPTURE(repeats_for_s);
			CAPTURE(seed);
			const auto [at_rest, ahead] = off(repeats_for_s, seed);
			CHECK(at_rest < 0.1);
			CHECK(ahead < 0.02);
		}
	}
}
