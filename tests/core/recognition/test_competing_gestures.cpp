// Gestures that one hand seems to make at once: which of them it is, in whatever order they are named.

#include "gesture_events.h"
#include "near.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

Eigen::Vector3d turned(double angle_rad) {
	return { std::cos(angle_rad), std::sin(angle_rad), 0.0 };
}

} // namespace

TEST_CASE("of gestures that end at once it is the likeliest, in whatever order they are named") {
	const ExpectedGesture level{ model("level", X, false), std::nullopt };
	const ExpectedGesture rising{ model("rising", turned(0.35), false), std::nullopt };
	for (const std::vector<ExpectedGesture> &both :
			{ std::vector{ level, rising }, std::vector{ rising, level } }) {
		for (const double angle_rad : { 0.0, 0.1, 0.25, 0.35 }) {
			CAPTURE(both.front().model->gesture);
			CAPTURE(angle_rad);
			GestureRecogniser recogniser(both);
			const Events events = watch(recogniser, along(turned(angle_rad), { DRAG }), 2.5);
			REQUIRE(!events.said.empty());
			CHECK(events.said.back() == (angle_rad < 0.17 ? "ended level" : "ended rising"));
			CHECK(ends(events) == 1);
		}
	}
}

TEST_CASE("a gesture is made between two of another kind, each from where the last one ended") {
	for (const double pause_s : { 0.3, 0.5, 0.8 }) {
		CAPTURE(pause_s);
		const double each_s = 0.6, period_s = each_s + pause_s;
		const Way way = [&](double t_s) {
			const Drag first{ 1.0, each_s, 0.2 }, push{ 1.0 + period_s, each_s, 0.2 },
					last{ 1.0 + 2.0 * period_s, each_s, 0.2 };
			return Eigen::Vector3d((first.x_m(t_s) + last.x_m(t_s)) * X - push.x_m(t_s) * Z);
		};
		std::vector<std::string> said = in_the_open(way, 1.0 + 3.0 * period_s + 0.5).said;
		std::erase_if(said, [](const std::string &one) { return !one.starts_with("ended"); });
		CHECK(said == std::vector<std::string>{ "ended sideways", "ended push", "ended sideways" });
	}
}

TEST_CASE("a hand that stops at the nearer of two tasks on one way begins no other there") {
	for (const double beside_m : { 0.0, 0.02 }) {
		const ExpectedGesture nearer{ model("near", X, false), Task{ beside_m * Y, X, 0.15 } };
		const ExpectedGesture farther{ model("far", X, false), Task{ Eigen::Vector3d::Zero(), X, 0.3 } };
		for (const std::vector<ExpectedGesture> &both :
				{ std::vector{ nearer, farther }, std::vector{ farther, nearer } }) {
			for (const double duration_s : { 0.4, 0.8, 1.2 }) {
				CAPTURE(beside_m);
				CAPTURE(both.front().model->gesture);
				CAPTURE(duration_s);
				GestureRecogniser recogniser(both);
				const Events events = watch(recogniser, along(X, { { 1.0, duration_s, 0.15 } }), 3.0);
				REQUIRE(!events.said.empty());
				CHECK(events.said.back() == "ended near");
				CHECK(ends(events) == 1);
			}
		}
	}
}

TEST_CASE("what is done near a task, but likelier something else, is that") {
	for (const double angle_rad : { 0.6, 0.65, 0.7 }) {
		const ExpectedGesture here{ model("here", turned(angle_rad), false),
			Task{ Eigen::Vector3d::Zero(), turned(angle_rad), 0.2 } };
		const ExpectedGesture anywhere{ model("anywhere", X, false), std::nullopt };
		for (const std::vector<ExpectedGesture> &both :
				{ std::vector{ here, anywhere }, std::vector{ anywhere, here } }) {
			for (const double duration_s : { 0.5, 0.8, 1.2 }) {
				CAPTURE(angle_rad);
				CAPTURE(duration_s);
				GestureRecogniser recogniser(both);
				const Events events = watch(recogniser, along(X, { { 1.0, duration_s, 0.2 } }), 3.0);
				REQUIRE(!events.said.empty());
				CHECK(events.said.back() == "ended anywhere");
			}
		}
	}
}

TEST_CASE("what takes another gesture's lead is as sure as what is shown first") {
	// It bends from the first one's way to between those of the others.
	constexpr double SURE = 0.83, BENDS_UNTIL = 0.7;
	for (const double turn_rad : { 0.6, 0.7, 0.8 }) {
		CAPTURE(turn_rad);
		GestureRecogniser recogniser({ model("first", X, false), model("second", turned(0.6), false),
											 model("third", turned(0.8), false) },
				std::nullopt, MotionMode::PHASE);
		recogniser.set_min_confidence(SURE);
		int last = -1, shown = 0;
		const Way way = [&](double t_s) {
			if (recogniser.gesture() >= 0 && recogniser.gesture() != last) {
				CHECK(recogniser.confidence() >= SURE);
				++shown;
			}
			last = recogniser.gesture();
			const double far_m = DRAG.x_m(t_s), share = far_m / DRAG.amplitude_m;
			return Eigen::Vector3d(far_m * turned(turn_rad * std::min(share / BENDS_UNTIL, 1.0)));
		};
		watch(recogniser, way, 2.5);
		CHECK(shown > 0);
	}
}

TEST_CASE("an end is held while another task's hand comes back to where that began") {
	// Up, to the right, and down: back to where the way up began, but not the way to the right.
	const ExpectedGesture up{ model("up", Y, false), Task{ Eigen::Vector3d::Zero(), Y, 0.2 } };
	const ExpectedGesture right{ model("right", X, false), Task{ 0.2 * Y, X, 0.2 } };
	GestureRecogniser recogniser({ up, right });
	const Way way = [](double t_s) {
		const Drag lift{ 1.0, 0.6, 0.2 }, aside{ 2.2, 0.6, 0.2 }, down{ 3.5, 0.6, -0.2 };
		return Eigen::Vector3d(aside.x_m(t_s) * X + (lift.x_m(t_s) + down.x_m(t_s)) * Y);
	};
	const Events events = watch(recogniser, way, 5.0);
	CHECK(events.last_value_m == near(0.2).epsilon(0.05));
	CHECK(recogniser.gesture() == 1);
}
