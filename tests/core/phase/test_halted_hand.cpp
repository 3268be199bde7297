// When a hand that stops on its way is said to have halted, by the tracker that shows it.

#include "minimum_jerk_drag.h"
#include "phase/halted_hand.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace steadyhand;

// Values in amplitudes.

namespace {

constexpr double PERIOD_S = 1.0 / 90.0;
constexpr double SLOW_PER_S = 0.25;
constexpr double WATCHED_S = 1.3; ///< while a tracker that jumped has erred of late
constexpr int HANDS = 40;

/// A hand that stops at `share` of the way, and the tracker that shows it.
struct Stop {
	double share = 0.5;
	double duration_s = 0.5;
	double noise = 5e-4;
	bool jumps = false;   ///< away and back, 0.2 s before the hand sets out
	double wanders = 0.0; ///< by so much to either side, four times a second

	static constexpr double ONSET_S = 0.8, JUMPS_S = 0.55, BACK_S = 0.6, JUMP = 0.3, WANDERS_HZ = 4.0;

	[[nodiscard]] test::Drag drag() const { return { ONSET_S, duration_s, share }; }
	[[nodiscard]] double slow_s() const {
		constexpr double STEP_S = 1e-4;
		double t_s = ONSET_S + 0.5 * duration_s;
		while (drag().x_m(t_s + STEP_S) - drag().x_m(t_s) > SLOW_PER_S * STEP_S) {
			t_s += STEP_S;
		}
		return t_s;
	}
	/// How long it was slow when it was first said to have halted; WATCHED_S if it was not by then.
	[[nodiscard]] double halted_after_s(int seed) const {
		std::mt19937_64 random(static_cast<std::uint64_t>(seed));
		std::normal_distribution<double> trembling(0.0, noise);
		TrackingSoundness soundness;
		HaltedHand hand;
		const double slow_from_s = slow_s(), phase = static_cast<double>(seed) / HANDS;
		for (int i = 0; i * PERIOD_S < slow_from_s + WATCHED_S; ++i) {
			const double t_s = i * PERIOD_S;
			const double jump = jumps && t_s > JUMPS_S && t_s < BACK_S ? JUMP : 0.0;
			const double wandering = wanders * std::sin(2.0 * std::numbers::pi * (WANDERS_HZ * t_s + phase));
			const double x = drag().x_m(t_s) + jump + wandering + trembling(random);
			if (i == 0) {
				hand.start(t_s, x);
			}
			soundness.push(t_s, x);
			hand.look(soundness, t_s, x);
			if (t_s > ONSET_S + 0.5 * duration_s && hand.is_halted()) {
				return t_s - slow_from_s;
			}
		}
		return WATCHED_S;
	}
	/// Of many hands.
	[[nodiscard]] double mean_s() const {
		double sum_s = 0.0;
		for (int seed = 0; seed < HANDS; ++seed) {
			sum_s += halted_after_s(seed) / HANDS;
		}
		return sum_s;
	}
};

} // namespace

TEST_CASE("a hand that is slow has halted at once before a tracker that is right, a tenth of a second later "
		  "before one that has jumped or shakes by 1 mm of 20 cm") {
	for (const double share : { 0.3, 0.5, 0.7 }) {
		CAPTURE(share);
		CHECK(Stop{ .share = share }.mean_s() < 0.06);
		CHECK(Stop{ .share = share, .duration_s = 0.6, .noise = 2e-3 }.mean_s() < 0.06);
		CHECK(Stop{ .share = share, .duration_s = 0.6, .noise = 4.5e-3 }.mean_s() > 0.08);
		for (const double duration_s : { 0.3, 0.6 }) {
			CAPTURE(duration_s);
			const double jumped_s = Stop{ .share = share, .duration_s = duration_s, .jumps = true }.mean_s();
			CHECK(jumped_s > 0.08);
			CHECK(jumped_s < 0.15);
		}
	}
}

TEST_CASE("a hand that stays where it is has halted within half a second, however a tracker that has jumped "
		  "wanders, but near its start, where it may not have begun") {
	for (const double share : { 0.3, 0.5, 0.7 }) {
		CAPTURE(share);
		const double stayed_s = Stop{ .share = share, .jumps = true, .wanders = 0.03 }.mean_s();
		CHECK(stayed_s > 0.2);
		CHECK(stayed_s < 0.45);
	}
	for (int seed = 0; seed < HANDS; ++seed) {
		CAPTURE(seed);
		CHECK(Stop{ .share = 0.13, .jumps = true, .wanders = 0.03 }.halted_after_s(seed) == WATCHED_S);
	}
}
