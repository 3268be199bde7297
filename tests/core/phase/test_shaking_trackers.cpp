#include "follow.h"
#include "minimum_jerk_drag.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

using namespace steadyhand;

// Values in amplitudes, as the estimator has them.

namespace {

constexpr int SEEDS = 40;
constexpr double SHAKES_FROM_S = 1.0;
constexpr double TREMBLES = 1e-3; ///< while it does not shake

/// The most that the estimate is off a hand, from a time on, whose tracker shakes for a while from frame to
/// frame, white.
template <class Hand>
double furthest_off(double noise, double for_s, unsigned seed, const Hand &hand, double from_s, double to_s) {
	PhaseEstimator estimator(test::drag_model());
	std::mt19937_64 random(seed);
	std::normal_distribution<double> normal;
	double furthest = 0.0;
	const auto show = [&](double t_s) {
		const bool shakes = t_s >= SHAKES_FROM_S && t_s < SHAKES_FROM_S + for_s;
		return hand(t_s) + (shakes ? noise : TREMBLES) * normal(random);
	};
	test::follow(estimator, to_s, show, [&](double t_s, double value) {
		furthest = std::max(furthest, t_s > from_s ? std::abs(value - hand(t_s)) : 0.0);
	});
	return furthest;
}

struct Off {
	double mean = 0.0, greatest = 0.0; ///< over seeds
};
template <class Hand> Off off(double noise, double for_s, const Hand &hand) {
	Off off;
	for (unsigned seed = 1; seed <= SEEDS; ++seed) {
		const double furthest = furthest_off(noise, for_s, seed, hand, -1.0, SHAKES_FROM_S + for_s + 1.0);
		off.mean += furthest / SEEDS;
		off.greatest = std::max(off.greatest, furthest);
	}
	return off;
}

} // namespace

TEST_CASE("a tracker that shakes about a hand at rest is not taken for a gesture") {
	const auto at_rest = [](double) { return 0.0; };
	for (const double for_s : { 0.1, 0.2, 0.3 }) {
		CAPTURE(for_s);
		for (const double noise : { 0.03, 0.06 }) {
			CAPTURE(noise);
			const Off of_rest = off(noise, for_s, at_rest);
			CHECK(of_rest.mean < 0.035);
			CHECK(of_rest.greatest < 0.1);
		}
		CHECK(off(0.1, for_s, at_rest).mean < 0.08); // 3 cm from frame to frame: some are, half-way
	}
}

TEST_CASE("a gesture that begins while the tracker shakes is shown, a little later") {
	for (const auto &[noise, duration_s, mean] : { std::array{ 0.03, 0.4, 0.17 }, { 0.03, 0.8, 0.08 },
				 { 0.06, 0.4, 0.23 }, { 0.06, 0.8, 0.12 } }) {
		CAPTURE(noise);
		CAPTURE(duration_s);
		const test::Drag drag{ .onset_s = 1.1, .duration_s = duration_s, .amplitude_m = 1.0 };
		CHECK(off(noise, 0.3, [&](double t_s) { return drag.x_m(t_s); }).mean < mean);
	}
}

TEST_CASE("once a tracker is calm that shook for long, a hand is followed as one before any that never did") {
	const test::Drag drag{ .onset_s = 4.5, .duration_s = 1.5, .amplitude_m = 1.0 };
	const auto hand = [&](double t_s) { return drag.x_m(t_s); };
	const auto off_drag = [&](double shakes_for_s) {
		return furthest_off(0.06, shakes_for_s, 3, hand, drag.onset_s, 6.5);
	};
	CHECK(off_drag(2.5) < 1.1 * off_drag(0.0));
}
