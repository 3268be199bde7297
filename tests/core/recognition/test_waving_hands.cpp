// A hand that waves makes strokes as straight and as long as a drag, one into the next: only that it never
// rests says that they are none. Frames that are missing must not look like rest, nor the turns of a hand
// that wanders slowly.

#include "gesture_events.h"

#include "simulation/oscillation.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr int PHASES = 20;

/// To and fro by 20 cm; from half-way between two turns on.
Eigen::Vector3d waving(double rate_hz, double t_s) {
	return { 0.1 * std::sin(2.0 * std::numbers::pi * rate_hz * t_s), 0.01 * std::sin(2.1 * t_s), 0.0 };
}

} // namespace

TEST_CASE("a hand that waves for longer than what comes of how it began hardly makes a gesture where frames "
		  "are "
		  "missing or frozen" *
		doctest::test_suite("figures")) {
	int runs = 0, alarms = 0;
	for (const double rate_hz : { 0.5, 0.7, 1.0 }) {
		for (const double loss_s : { 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35 }) {
			for (int phase = 0; phase < PHASES; ++phase) {
				const double from_s = 2.0 + phase / (PHASES * rate_hz), to_s = from_s + loss_s;
				const Way way = [&](double t_s) { return waving(rate_hz, t_s); };
				const Way frozen = [&](double t_s) { return way(t_s > from_s && t_s < to_s ? from_s : t_s); };
				GestureRecogniser recogniser(models(), std::nullopt, MotionMode::PHASE);
				alarms += none_ends(in_the_open(way, 6.0, from_s, to_s)) ? 0 : 1;
				alarms += none_ends(watch(recogniser, frozen, 6.0, 1e9, 1e9, 110.0, 0.0)) ? 0 : 1;
				runs += 2;
			}
		}
	}
	CHECK(alarms <= 0.1 * runs);
}

TEST_CASE("a hand that goes on waving begins no gesture, wherever its strokes together have come back to") {
	for (const double rate_hz : { 0.5, 0.7, 0.8, 1.0 }) {
		CAPTURE(rate_hz);
		const Way way = [&](double t_s) { return waving(rate_hz, t_s); };
		CHECK(in_the_open(way, 8.0).said.empty());
	}
}

TEST_CASE("a hand that comes into view waving makes one gesture at most") {
	for (const double rate_hz : { 0.7, 1.0, 1.5 }) {
		for (int phase = 0; phase < PHASES; ++phase) {
			CAPTURE(rate_hz);
			CAPTURE(phase);
			const double into_s = phase / (PHASES * rate_hz);
			const Way way = [&](double t_s) { return waving(rate_hz, t_s + into_s); };
			CHECK(std::ranges::count(in_the_open(way, 6.0).said, "ended sideways") <= 1);
		}
	}
}

TEST_CASE("a hand that waves, is lost for long and waves on makes one gesture at most" *
		doctest::test_suite("figures")) {
	for (const double rate_hz : { 0.7, 1.0, 1.5 }) {
		const Way way = [&](double t_s) { return waving(rate_hz, t_s); };
		for (const double loss_s : { 0.4, 0.5, 0.6, 0.8 }) {
			for (int phase = 0; phase < PHASES; ++phase) {
				CAPTURE(rate_hz);
				CAPTURE(loss_s);
				CAPTURE(phase);
				const double from_s = 2.0 + phase / (PHASES * rate_hz);
				const Events events = in_the_open(way, 7.0, from_s, from_s + loss_s);
				CHECK(std::ranges::count(events.said, "ended sideways") <= 1);
			}
		}
	}
}

TEST_CASE("a hand that wanders slowly makes hardly a gesture" * doctest::test_suite("figures")) {
	constexpr int HANDS = 24;
	constexpr double SECONDS = 30.0;
	for (const double deviation_m : { 0.05, 0.1 }) {
		CAPTURE(deviation_m);
		std::size_t ends = 0;
		for (int hand = 0; hand < HANDS; ++hand) {
			Random random(static_cast<std::uint64_t>(hand));
			const Oscillation wandering(0.1, 0.3, deviation_m, random);
			const Way way = [&](double t_s) -> Eigen::Vector3d { return wandering.at(t_s); };
			for (const std::string &said : in_the_open(way, SECONDS).said) {
				ends += said.starts_with("ended") ? 1 : 0;
			}
		}
		// 0.2 a minute are asked for of motion at random.
		CHECK(static_cast<double>(ends) <= 0.2 * HANDS * SECONDS / 60.0);
	}
}
