// A tap down and a vertical drag have the same path. Pace tells them apart, and what the hand does at its
// end.

#include "gesture_events.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

using Models = std::vector<std::shared_ptr<const GestureModel>>;

/// The hand passes a surface 0.15 m away, at 0.88 of its movement, and comes back.
constexpr double LENGTH_M = 0.17, CONTACT_M = 0.15, CONTACT_PHASE = 0.7447;

std::shared_ptr<const GestureModel> tap_model() {
	std::vector<TrainingRecording> recordings = drag_recordings();
	for (TrainingRecording &recording : recordings) {
		recording.end_s = 0.5 + CONTACT_PHASE * (recording.end_s - 0.5);
		recording.task.amplitude_m = 0.2 * CONTACT_M / LENGTH_M;
	}
	GestureModel trained = train("tap", "index_along_axis", recordings, {}).value();
	trained.typical_task.axis = -Z;
	trained.other_axes = { -Y };
	trained.typical_task.amplitude_m = CONTACT_M;
	trained.duration_mean_s = 0.27;
	return std::make_shared<const GestureModel>(std::move(trained));
}

const Models &taps_and_drags() {
	static const Models both{ model("upright", Y, true), tap_model() };
	return both;
}

TestPath tap(double duration_s) {
	return along(-Y,
			{ { 0.6, duration_s, LENGTH_M },
					{ 0.6 + 1.02 * duration_s, 1.15 * duration_s, -0.8 * LENGTH_M } });
}

TestPath drag(double duration_s) {
	return along(-Y, { { 0.6, duration_s, 0.2 } });
}

Events events_of(const Models &models, const TestPath &path, const TestTracker &tracker = {}) {
	return watch(GestureRecogniser(models, std::nullopt, MotionMode::PHASE), path, 3.0, tracker);
}

} // namespace

TEST_CASE("a fast stroke down that comes back is a tap, one that stays a drag") {
	for (const auto &[path, end] : { std::pair{ tap(0.2), "ended tap" }, { tap(0.3), "ended tap" },
				 { tap(0.4), "ended tap" }, { tap(0.5), "ended tap" }, { drag(0.35), "ended upright" },
				 { drag(0.5), "ended upright" }, { drag(0.7), "ended upright" } }) {
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
		CHECK(events_of(taps_and_drags(), path).names == times(1, "upright"));
	}
	const TestPath half_way = along(-Y, { { 0.6, 0.8, 0.1 }, { 2.6, 0.5, -0.1 } });
	CHECK(has_no_end(events_of(taps_and_drags(), half_way)));
}

TEST_CASE("a drag down of 0.8 s ends no later beside the model of a tap") {
	for (const double duration_s : { 0.8, 1.0, 2.0 }) {
		CAPTURE(duration_s);
		const Events events = events_of(taps_and_drags(), drag(duration_s));
		const Events alone = events_of({ taps_and_drags().front() }, drag(duration_s));
		CHECK(events.last_ended_s - alone.last_ended_s < 0.02);
	}
}

TEST_CASE("a tap down ends at its contact without the model of a drag") {
	for (const double duration_s : { 0.25, 0.35, 0.5 }) {
		CAPTURE(duration_s);
		const Events events = events_of({ taps_and_drags().back() }, tap(duration_s));
		CHECK(events.names == times(1, "tap"));
		CHECK(std::abs(events.last_ended_s - (0.6 + CONTACT_PHASE * duration_s)) < 0.05);
	}
}

TEST_CASE("a tap that is lost at its end has no second event") {
	const Events events = events_of(taps_and_drags(), tap(0.3), { 0.85, 1.4 });
	CHECK(ends(events) <= 1);
	CHECK(count(events, "started") <= 2);
}
