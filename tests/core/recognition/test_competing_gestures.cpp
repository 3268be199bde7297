// Several gestures or tasks that fit one movement: which of them is shown, independent of their order.

#include "gesture_events.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

using Expected = std::vector<ExpectedGesture>;
using EventNames = std::vector<std::string>;

Eigen::Vector3d turned(double angle_rad) {
	return { std::cos(angle_rad), std::sin(angle_rad), 0.0 };
}

std::vector<Expected> both_orders(const ExpectedGesture &one, const ExpectedGesture &other) {
	return { { one, other }, { other, one } };
}

constexpr double LIFT_M = 0.12; ///< height of a finger above a keypad

/// A key at x_m, whose surface is deeper_m below that of the first key.
ExpectedGesture key(const char *name, double x_m, double deeper_m) {
	return { model(name, -Z, false), Task{ { x_m, 0.0, LIFT_M - deeper_m }, -Z, LIFT_M } };
}

/// A finger presses 3 mm into the surface at beside_m from the first key, and returns. Its onset is at
/// beside_m
/// + onset_m.
Events press(const Expected &keys, double beside_m, double onset_m, double duration_s, double noise_m) {
	const double down_m = LIFT_M + 0.003;
	const std::vector<Drag> strokes{ { 0.8, duration_s, down_m },
		{ 0.8 + duration_s + 0.08, duration_s, -down_m } };
	const TestPath finger = [&](double t_s) {
		const double moved_m = x_m(strokes, t_s);
		return Eigen::Vector3d(beside_m + onset_m * (1.0 - moved_m / down_m), 0.0, LIFT_M - moved_m);
	};
	GestureRecogniser recogniser(keys);
	return watch(recogniser, finger, 3.0, 1e9, 1e9, 90.0, noise_m);
}

} // namespace

TEST_CASE("the likelier of two gestures along nearly equal axes ends") {
	for (const Expected &both : both_orders({ model("level", X, false), std::nullopt },
				 { model("rising", turned(0.35), false), std::nullopt })) {
		for (const double angle_rad : { 0.1, 0.25 }) {
			INFO("first ", both.front().model->gesture, ", angle ", angle_rad);
			GestureRecogniser recogniser(both);
			const Events events = watch(recogniser, along(turned(angle_rad), { DRAG }), 2.5);
			REQUIRE(!events.names.empty());
			CHECK(events.names.back() == (angle_rad < 0.17 ? "ended level" : "ended rising"));
			CHECK(ends(events) == 1);
		}
	}
}

TEST_CASE("a movement that bends onto another gesture's axis changes to it once") {
	GestureRecogniser recogniser({ model("first", X, false), model("second", turned(0.45), false) },
			std::nullopt, MotionMode::PHASE);
	const TestPath path = [](double t_s) {
		const double share = DRAG.x_m(t_s) / DRAG.amplitude_m;
		return Eigen::Vector3d(DRAG.x_m(t_s) * turned(0.42 * std::min(share / 0.7, 1.0)));
	};
	CHECK(watch(recogniser, path, 1.25).names ==
			EventNames{ "started first", "aborted first", "started second" });
}

TEST_CASE("a gesture between two of another kind ends, from the endpoint before") {
	for (const double pause_s : { 0.3, 0.8 }) {
		CAPTURE(pause_s);
		const double each_s = 0.6, period_s = each_s + pause_s;
		const TestPath path = [&](double t_s) {
			const Drag first{ 1.0, each_s, 0.2 }, push{ 1.0 + period_s, each_s, 0.2 },
					last{ 1.0 + 2.0 * period_s, each_s, 0.2 };
			return Eigen::Vector3d((first.x_m(t_s) + last.x_m(t_s)) * X - push.x_m(t_s) * Z);
		};
		EventNames names = watch_without_task(path, 1.0 + 3.0 * period_s + 0.5).names;
		std::erase_if(names, [](const std::string &one) { return !one.starts_with("ended"); });
		CHECK(names == EventNames{ "ended sideways", "ended push", "ended sideways" });
	}
}

TEST_CASE("a hand that stops at the nearer of two targets ends there") {
	for (const double beside_m : { 0.0, 0.02 }) {
		for (const Expected &both : both_orders({ model("near", X, false), Task{ beside_m * Y, X, 0.15 } },
					 { model("far", X, false), Task{ Eigen::Vector3d::Zero(), X, 0.3 } })) {
			for (const double duration_s : { 0.4, 1.2 }) {
				INFO("beside ", beside_m, ", first ", both.front().model->gesture, ", duration ", duration_s);
				GestureRecogniser recogniser(both);
				const Events events = watch(recogniser, along(X, { { 1.0, duration_s, 0.15 } }), 3.0);
				REQUIRE(!events.names.empty());
				CHECK(events.names.back() == "ended near");
				CHECK(ends(events) == 1);
			}
		}
	}
}

TEST_CASE("a likelier gesture without a task beats one with a task") {
	for (const double angle_rad : { 0.6, 0.7 }) {
		const Eigen::Vector3d axis = turned(angle_rad);
		for (const Expected &both :
				both_orders({ model("here", axis, false), Task{ Eigen::Vector3d::Zero(), axis, 0.2 } },
						{ model("anywhere", X, false), std::nullopt })) {
			for (const double duration_s : { 0.5, 1.2 }) {
				INFO("angle ", angle_rad, ", duration ", duration_s);
				GestureRecogniser recogniser(both);
				const Events events = watch(recogniser, along(X, { { 1.0, duration_s, 0.2 } }), 3.0);
				REQUIRE(!events.names.empty());
				CHECK(events.names.back() == "ended anywhere");
			}
		}
	}
}

TEST_CASE("a press ends at its key despite a deeper one beside it" * doctest::test_suite("figures")) {
	for (const double pitch_m : { 0.04, 0.06, 0.1 }) {
		for (const double duration_s : { 0.3, 0.5 }) {
			INFO("pitch ", pitch_m, ", duration ", duration_s);
			for (const double deeper_m : { 0.002, 0.01 }) {
				for (const Expected &keys :
						both_orders(key("this", 0.0, 0.0), key("next", pitch_m, deeper_m))) {
					CHECK(press(keys, 0.01, 0.0, duration_s, 1e-4).names == times(1, "this"));
					CHECK(press(keys, 0.01, 0.0, duration_s, 1e-3).names == times(1, "this"));
				}
			}
			for (const Expected &keys : both_orders(key("this", 0.0, 0.0), key("next", pitch_m, 0.0))) {
				const Events above_next = press(keys, 0.0, std::min(pitch_m, 0.06), duration_s, 1e-4);
				CHECK(count(above_next, "ended this") == 1);
				CHECK(ends(above_next) == 1);
			}
		}
	}
}
