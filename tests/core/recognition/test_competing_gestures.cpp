// Several gestures or tasks that fit one movement: which of them is shown, independent of their order.

#include "gesture_events.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

using Expected = std::vector<ExpectedGesture>;

Eigen::Vector3d turned(double angle_rad) {
	return { std::cos(angle_rad), std::sin(angle_rad), 0.0 };
}

ExpectedGesture no_task(const char *name, double angle_rad) {
	return { model(name, turned(angle_rad), false), std::nullopt };
}

ExpectedGesture at(
		const char *name, double angle_rad, double length_m, const Eigen::Vector3d &start_m = 0.0 * X) {
	return { model(name, turned(angle_rad), false), Task{ start_m, turned(angle_rad), length_m } };
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
/// beside_m + onset_m.
Events press(const Expected &keys, double beside_m, double onset_m, double duration_s, double noise_m) {
	const double down_m = LIFT_M + 0.003;
	const std::vector<Drag> strokes{ { 0.8, duration_s, down_m },
		{ 0.8 + duration_s + 0.08, duration_s, -down_m } };
	const TestPath finger = [&](double t_s) {
		const double moved_m = x_m(strokes, t_s);
		return Eigen::Vector3d(beside_m + onset_m * (1.0 - moved_m / down_m), 0.0, LIFT_M - moved_m);
	};
	return watch(GestureRecogniser(keys), finger, 3.0, { .rate_hz = 90.0, .noise_m = noise_m });
}

using Models = std::vector<std::shared_ptr<const GestureModel>>;

// A tap down and a vertical drag have the same path. Pace tells them apart, and what the hand does at its
// end.

/// The hand passes a surface 0.15 m away, at 0.88 of its movement, and comes back.
constexpr double TAP_M = 0.17, CONTACT_M = 0.15, CONTACT_PHASE = 0.7447;

std::shared_ptr<const GestureModel> tap_model() {
	std::vector<TrainingRecording> recordings = drag_recordings();
	for (TrainingRecording &recording : recordings) {
		recording.end_s = 0.5 + CONTACT_PHASE * (recording.end_s - 0.5);
		recording.task.amplitude_m = 0.2 * CONTACT_M / TAP_M;
	}
	GestureModel trained = train("tap", "index_along_axis", recordings, {}).value();
	trained.recorded_hmms.clear(); // the add-on has HMMs of taps
	trained.typical_task.axis = -Z;
	trained.other_axes = { -Y };
	trained.typical_task.amplitude_m = CONTACT_M;
	trained.duration_mean_s = 0.27;
	return std::make_shared<const GestureModel>(std::move(trained));
}

const Models &taps_and_drags() {
	static const Models both{ model("vertical_drag", Y, true), tap_model() };
	return both;
}

TestPath tap(double duration_s) {
	return along(
			-Y, { { 0.6, duration_s, TAP_M }, { 0.6 + 1.02 * duration_s, 1.15 * duration_s, -0.8 * TAP_M } });
}

TestPath drag(double duration_s) {
	return along(-Y, { { 0.6, duration_s, 0.2 } });
}

Events events_of(const Models &models, const TestPath &path, const TestTracker &tracker = {}) {
	return watch(recogniser_of(models, std::nullopt), path, 3.0, tracker);
}

} // namespace

TEST_CASE("of two gestures that fit, the likelier one ends") {
	struct Row {
		std::string likelier;
		ExpectedGesture one, other;
		double angle_rad; ///< of the hand's movement
		Drag drag;
	};
	const Drag quick{ 1.0, 0.4, 0.15 }, slow{ 1.0, 1.2, 0.15 };
	for (const auto &[likelier, one, other, angle_rad, drag] : {
				 // The hand stops at the nearer one of two targets.
				 Row{ "near", at("near", 0.0, 0.15), at("far", 0.0, 0.3), 0.0, quick },
				 { "near", at("near", 0.0, 0.15), at("far", 0.0, 0.3), 0.0, slow },
				 { "near", at("near", 0.0, 0.15, 0.02 * Y), at("far", 0.0, 0.3), 0.0, quick },
				 // A task 34 degrees off is less likely than the gesture without a task.
				 { "horizontal_drag", at("here", 0.6, 0.2), no_task("horizontal_drag", 0.0), 0.0,
						 { 1.0, 0.5, 0.2 } },
				 { "horizontal_drag", at("here", 0.7, 0.2), no_task("horizontal_drag", 0.0), 0.0,
						 { 1.0, 1.2, 0.2 } },
				 // The same gesture with a task is likelier than without one.
				 { "here", at("here", 0.0, 0.2), no_task("horizontal_drag", 0.0), 0.0, { 1.0, 0.8, 0.2 } },
				 { "here", at("here", 0.2, 0.15), no_task("horizontal_drag", 0.0), 0.2, { 1.0, 0.8, 0.15 } },
		 }) {
		for (const Expected &both : both_orders(one, other)) {
			INFO("likelier ", likelier, ", first ", both.front().model->gesture, ", angle ", angle_rad);
			const Events events = watch(GestureRecogniser(both), along(turned(angle_rad), { drag }), 3.0);
			REQUIRE(!events.names.empty());
			CHECK(events.names.back() == "ended " + likelier);
			CHECK(ends(events) == 1);
		}
	}
}

TEST_CASE("a gesture between two of another kind ends, from the endpoint before") {
	for (const double pause_s : { 0.5, 0.8 }) {
		CAPTURE(pause_s);
		const double period_s = 0.6 + pause_s;
		const TestPath path = [&](double t_s) {
			const Drag push{ 1.0 + period_s, 0.6, 0.2 };
			const double right_m = x_m({ { 1.0, 0.6, 0.2 }, { 1.0 + 2.0 * period_s, 0.6, 0.2 } }, t_s);
			return Eigen::Vector3d(right_m * X - push.x_m(t_s) * Z);
		};
		EventNames names = watch_without_task(path, 1.5 + 3.0 * period_s).names;
		std::erase_if(names, [](const std::string &one) { return !one.starts_with("ended"); });
		CHECK(names == EventNames{ "ended horizontal_drag", "ended tap", "ended horizontal_drag" });
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

TEST_CASE("a stroke down that returns fast is a tap, otherwise a drag") {
	for (const auto &[path, end] : { std::pair{ tap(0.2), "ended tap" }, { tap(0.3), "ended tap" },
				 { tap(0.4), "ended tap" }, { tap(0.5), "ended tap" }, { drag(0.35), "ended vertical_drag" },
				 { drag(0.5), "ended vertical_drag" }, { drag(0.7), "ended vertical_drag" } }) {
		const Events events = events_of(taps_and_drags(), path);
		CAPTURE(events.names);
		REQUIRE(!events.names.empty());
		CHECK(events.names.back() == end);
		CHECK(ends(events) == 1);
	}
}

TEST_CASE("slow strokes down and drags up show no tap") {
	const TestPath fast_return = along(Y, { { 0.6, 0.8, 0.2 }, { 1.8, 0.35, -0.2 } });
	for (const TestPath &path : { tap(1.2), drag(1.0), drag(2.0), fast_return }) {
		CHECK(events_of(taps_and_drags(), path).names == times(1, "vertical_drag"));
	}
	const TestPath half_way = along(-Y, { { 0.6, 0.8, 0.1 }, { 2.6, 0.5, -0.1 } });
	CHECK(has_no_end(events_of(taps_and_drags(), half_way)));
}

TEST_CASE("a tap down ends at its contact without the model of a drag") {
	for (const double duration_s : { 0.25, 0.35, 0.5 }) {
		CAPTURE(duration_s);
		const Events events = events_of({ taps_and_drags().back() }, tap(duration_s));
		CHECK(events.names == times(1, "tap"));
		CHECK(std::abs(events.last_ended_s - (0.6 + CONTACT_PHASE * duration_s)) < 0.1);
	}
}

TEST_CASE("a tap that is lost at its end has no second event") {
	const Events events = events_of(taps_and_drags(), tap(0.3), { 0.85, 1.4 });
	CHECK(ends(events) <= 1);
	CHECK(count(events, "started") <= 2);
}
