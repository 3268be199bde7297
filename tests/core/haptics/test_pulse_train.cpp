#include "haptics/pulse_train.h"
#include "near.h"
#include "vibration_rig.h"

#include <doctest/doctest.h>

#include <limits>
#include <utility>
#include <vector>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr double FRAME_S = 1.0 / 90.0;

using Told = std::vector<std::pair<double, Pulse>>;

/// What is told of a movement from -0.2 s on, at 90 frames a second.
Told told_of(const Movement &movement, const EffectSet &effects, PulseTrain &train, double until_s) {
	Told told;
	for (int frame = -18; frame * FRAME_S < until_s; ++frame) {
		LiveMotion motion;
		motion.heard_s = frame * FRAME_S;
		motion.snapshot = movement.snapshot(motion.heard_s);
		if (motion.heard_s >= movement.end_s()) {
			motion.snapshot.arrival = { 1, movement.end_s(), 0.7 };
		}
		if (const auto pulse = train.next(effects, motion)) {
			told.emplace_back(motion.heard_s, *pulse);
		}
	}
	return told;
}

} // namespace

TEST_CASE("a spring is told fifty times a second at most, as the greatest amplitude since the last time") {
	const Movement movement{ 0.8 };
	PulseTrain train;
	const Told told = told_of(movement, set_of(spring_effect()), train, 1.5);
	REQUIRE(told.size() > 20);
	for (std::size_t i = 1; i + 1 < told.size(); ++i) {
		CHECK(told[i].first - told[i - 1].first >= PulseTrain::PERIOD_S);
		// The motion grows: the last instant has the greatest.
		CHECK(told[i].second.amplitude == near(movement.at(told[i].first).position).epsilon(0.02));
		CHECK(told[i].second.frequency_hz == 180.0);
		CHECK(told[i].second.duration_s == PulseTrain::DURATION_S);
	}
	CHECK(told.front().first >= 0.0);
	CHECK(told.back().second.amplitude == 0.0);
	CHECK_FALSE(train.restart());
}

TEST_CASE("an impulse is told in the frame after its contact with its full strength, and over 60 ms later") {
	for (const double duration_s : { 0.6, 0.61, 0.62, 0.63 }) {
		const Movement movement{ duration_s };
		PulseTrain train;
		const Told told = told_of(movement, effects_of_gesture("tap"), train, 1.5);
		REQUIRE(told.size() >= 2);
		CHECK(told.front().first - movement.end_s() <= FRAME_S);
		CHECK(told.front().second.amplitude == near(0.7));
		CHECK(told.front().second.frequency_hz == 300.0);
		CHECK(told.back().second.amplitude == 0.0);
		CHECK(told.back().first - movement.end_s() < 0.08);
	}
}

TEST_CASE("an arrival does not wait for its turn, and one long past is not told") {
	PulseTrain train;
	const EffectSet effects = effects_of_gesture("tap");
	LiveMotion motion;
	motion.snapshot = still(0.0, 1.0);
	motion.heard_s = 0.1;
	motion.snapshot.arrival = { 1, 0.1, 0.5 };
	CHECK(train.next(effects, motion)->amplitude == near(0.5));
	motion.heard_s = 0.105;
	CHECK_FALSE(train.next(effects, motion).has_value());
	motion.heard_s = 0.11;
	motion.snapshot.arrival = { 2, 0.108, 0.9 };
	CHECK(train.next(effects, motion)->amplitude == near(0.9));
	CHECK(train.restart());
	motion.heard_s = 0.12;
	CHECK(train.next(effects, motion)->amplitude < 0.1); // the rest of it, and not all of it again
	motion.heard_s = 0.3;
	CHECK(train.next(effects, motion)->amplitude == 0.0);
	motion.heard_s = 0.32;
	CHECK_FALSE(train.next(effects, motion).has_value());
}

TEST_CASE("an arrival that is expected is told at its time") {
	PulseTrain train;
	const EffectSet effects = effects_of_gesture("tap");
	LiveMotion motion;
	motion.snapshot = still(0.0, 1.0);
	motion.snapshot.expected = { 1, 0.05, 0.5 };
	motion.heard_s = 0.04;
	CHECK_FALSE(train.next(effects, motion).has_value());
	motion.heard_s = 0.051;
	CHECK(train.next(effects, motion)->amplitude == near(0.5));
	motion.snapshot.arrival = std::exchange(motion.snapshot.expected, {});
	motion.heard_s = 0.2;
	CHECK(train.next(effects, motion)->amplitude == 0.0);
}

TEST_CASE("motion that is no number is silence, and time may leap") {
	PulseTrain train;
	const EffectSet effects = set_of(spring_effect());
	LiveMotion motion;
	motion.snapshot = still(0.0, 0.5);
	motion.heard_s = std::numeric_limits<double>::quiet_NaN();
	CHECK_FALSE(train.next(effects, motion).has_value());
	for (const double heard_s : { 1.0, -1e9, 1e9, 0.0 }) {
		motion.snapshot.time_s = heard_s;
		motion.heard_s = heard_s;
		CHECK(train.next(effects, motion)->amplitude == 0.5);
	}
	motion.heard_s = 0.03;
	motion.snapshot.knots[0].position = std::numeric_limits<double>::quiet_NaN();
	CHECK(train.next(effects, motion)->amplitude == 0.0);
}

TEST_CASE("a motor is told fifty times a second, however many frames there are") {
	const EffectSet effects = set_of(spring_effect());
	PulseTrain train;
	int told = 0;
	for (int ms = 0; ms < 1000; ++ms) {
		LiveMotion motion;
		motion.heard_s = 0.001 * ms;
		motion.snapshot = still(motion.heard_s, 0.5);
		told += train.next(effects, motion).has_value() ? 1 : 0;
	}
	CHECK(told > 40);
	CHECK(told < 60);
}

TEST_CASE(
		"a motor goes on between the frames of a slow game, and stops soon after a game that stands still") {
	LiveMotion motion;
	motion.snapshot = still(0.0, 0.5);
	PulseTrain train;
	const double duration_s = train.next(set_of(spring_effect()), motion)->duration_s;
	CHECK(duration_s > 1.0 / 15.0);
	CHECK(duration_s < 0.15);
}

TEST_CASE("an arrival is told though it was noticed late, and not any more once that would be felt") {
	const EffectSet effects = effects_of_gesture("tap");
	for (const double late_s : { 0.01, 0.03, 0.07, 0.09 }) {
		CAPTURE(late_s);
		PulseTrain train;
		LiveMotion motion;
		motion.snapshot = still(0.0, 1.0);
		for (motion.heard_s = 0.45; motion.heard_s < 0.5 + late_s; motion.heard_s += 0.01) {
			CHECK_FALSE(train.next(effects, motion).has_value());
		}
		motion.heard_s = 0.5 + late_s;
		motion.snapshot.arrival = { 1, 0.5, 0.5 };
		const double told = train.next(effects, motion).value_or(Pulse{}).amplitude;
		if (late_s < 0.05) {
			CHECK(told == near(0.5));
		} else {
			CHECK(told < 0.15); // what is left of it
		}
	}
}

TEST_CASE("what was strongest between two frames is told, unless the game stood still in between") {
	const EffectSet effects = set_of(spring_effect());
	for (const double frame_s : { 0.07, 0.09, 0.15, 0.3 }) {
		CAPTURE(frame_s);
		PulseTrain train;
		LiveMotion motion;
		motion.snapshot.time_s = 0.0;
		motion.snapshot.period_s = 0.5 * frame_s;
		motion.snapshot.count = 3;
		motion.snapshot.amplitude_m = AMPLITUDE_M;
		for (const std::size_t knot : { 0U, 1U, 2U }) {
			motion.snapshot.knots[knot] = { knot == 1 ? 0.8 : 0.2, 0.0, 0.0, true };
		}
		CHECK(train.next(effects, motion)->amplitude == near(0.2));
		motion.heard_s = frame_s;
		CHECK(train.next(effects, motion)->amplitude == near(frame_s < 0.1 ? 0.8 : 0.2).epsilon(0.02));
	}
}
