// Dropouts and freezes before, during and after a movement.

#include "gesture_events.h"
#include "near.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

using EventNames = std::vector<std::string>;
const EventNames ABORTED{ "started sideways", "aborted sideways" };

/// Times at which DRAG is at 0.93 and 0.64 of its amplitude.
constexpr double NEAR_END_S = 0.6 + 0.76, HALF_WAY_S = 0.6 + 0.57;
constexpr double FRAME_S = 1.0 / 110.0; ///< the last frame before a dropout may be this much older
constexpr double NEVER_S = 1e9;

/// Without noise: the tracker repeats its last measurement exactly.
Events frozen(GestureRecogniser recogniser, const Drag &drag, double from_s, double length_s) {
	return watch(
			recogniser, held(along(X, { drag }), from_s, NEVER_S), length_s, NEVER_S, NEVER_S, 110.0, 0.0);
}

GestureRecogniser without_task() {
	return { models(), std::nullopt, MotionMode::PHASE };
}

GestureRecogniser with_task(MotionMode mode = MotionMode::PHASE) {
	return { { models()[0] }, Task{}, mode };
}

/// Events of a hand whose track begins at this fraction of the drag's amplitude.
Events seen_from(double share, double duration_s, bool has_task, const Eigen::Vector3d &axis = X,
		const Eigen::Vector3d &start_m = Eigen::Vector3d::Zero()) {
	const Drag drag{ .onset_s = 0.6, .duration_s = duration_s, .amplitude_m = 0.2 };
	const TestPath path = [&](double t_s) { return Eigen::Vector3d(start_m + drag.x_m(t_s) * axis); };
	GestureRecogniser recogniser = has_task ? with_task() : without_task();
	return watch(recogniser, path, 4.0, -1.0, reaches_s(drag, share));
}

} // namespace

TEST_CASE("without a task a dropout near the end still ends the gesture") {
	for (const double back_s : { NEVER_S, 3.5 }) {
		const Events events = watch_without_task(along(X, { DRAG }), 4.0, NEAR_END_S, back_s);
		CHECK(events.names == times(1, "sideways"));
		CHECK(events.last_ended_s > NEAR_END_S + 0.3 - FRAME_S);
		CHECK(events.last_ended_s <= NEAR_END_S + 0.301);
		CHECK(events.largest_step < 1.01 * FASTEST_M_MS);
	}
	for (const double length_s : { NEAR_END_S + 0.98, NEAR_END_S + 1.2 }) { // the value is held for a second
		const Events events = watch_without_task(along(X, { DRAG }), length_s, NEAR_END_S);
		CHECK(events.names == times(1, "sideways"));
		CHECK(std::abs(events.last_value_m - (length_s < NEAR_END_S + 1.0 ? 0.2 : 0.0)) < 0.005);
	}
	const Events events = frozen(without_task(), DRAG, NEAR_END_S, 4.0);
	CHECK(events.names == times(1, "sideways"));
	CHECK(events.last_value_m == near(0.0));
	CHECK(events.last_ended_s <= NEAR_END_S + 0.31); // the freeze may begin with the next frame
}

TEST_CASE("without a task a dropout in mid-gesture aborts after 1 s") {
	for (const Events &events : { watch_without_task(along(X, { DRAG }), 4.0, HALF_WAY_S),
				 frozen(without_task(), DRAG, HALF_WAY_S, 4.0) }) {
		CHECK(events.names == ABORTED);
		CHECK(events.largest_step < 1.01 * FASTEST_M_MS);
	}
	const double just_before_s = HALF_WAY_S + 1.0 - 2.0 * FRAME_S;
	CHECK(watch_without_task(along(X, { DRAG }), just_before_s, HALF_WAY_S).names ==
			EventNames{ "started sideways" });
}

TEST_CASE("with a task a dropout of 1 s resets the motion") {
	const Drag half_way{ .onset_s = 0.6, .duration_s = 1.0, .amplitude_m = 0.1 };
	const double lost_s = 2.5;
	const Events halted = watch_with_task(along(X, { half_way }), 4.0, lost_s);
	CHECK(halted.names == ABORTED);
	CHECK(std::abs(halted.last_value_m) < 1e-9);
	CHECK(halted.largest_step < 1.01 * FASTEST_M_MS);
	for (const double length_s : { lost_s + 0.98, lost_s + 1.2 }) {
		const Events halting = watch_with_task(along(X, { half_way }), length_s, lost_s);
		CHECK(halting.names.size() == (length_s < lost_s + 1.0 ? 1 : 2));
		for (const MotionMode mode : { MotionMode::PHASE, MotionMode::PAPER }) {
			GestureRecogniser recogniser = with_task(mode);
			const Events arrived = watch(recogniser, along(X, { DRAG }), length_s, lost_s);
			CHECK(arrived.names == times(1, "sideways"));
			CHECK(std::abs(arrived.last_value_m - (length_s < lost_s + 1.0 ? 0.2 : 0.0)) < 0.005);
			CHECK((mode == MotionMode::PAPER || arrived.largest_step < 1.01 * FASTEST_M_MS));
		}
	}
}

TEST_CASE("a hand tracked again after 1.5 s is followed without a step") {
	const Drag half_back{ .onset_s = 3.0, .duration_s = 0.5, .amplitude_m = -0.1 };
	for (const auto &[strokes, found_m] :
			{ std::pair{ std::vector{ DRAG }, 0.2 }, std::pair{ std::vector{ DRAG, half_back }, 0.1 } }) {
		const Events events = watch_with_task(along(X, strokes), 5.0, 2.5, 4.0);
		CHECK(events.names == times(1, "sideways"));
		CHECK(events.last_value_m == near(found_m).epsilon(0.01));
		CHECK(events.largest_step < 1.01 * FASTEST_M_MS);
	}
	const std::vector<Drag> again{ DRAG, { 3.0, 0.5, -0.2 }, { 4.6, 1.0, 0.2 } };
	const Events twice = watch_with_task(along(X, again), 7.0, 2.5, 4.0);
	CHECK(twice.names == times(2, "sideways"));
	CHECK(std::abs(twice.last_ended_s - 5.6) < 0.25);
}

TEST_CASE("with a task a freeze after the end keeps the end") {
	const Events events = frozen(with_task(), DRAG, NEVER_S, 6.0);
	CHECK(events.names == times(1, "sideways"));
	CHECK(events.last_value_m == near(0.2).epsilon(0.01));
}

TEST_CASE("a gesture with a dropout half-way ends only after the dropout") {
	const Drag drag{ .onset_s = 0.6, .duration_s = 0.8, .amplitude_m = 0.2 };
	for (const double share : { 0.3, 0.5 }) { // of the time: 16 and 50 % of the amplitude
		CAPTURE(share);
		const double lost_s = drag.onset_s + share * drag.duration_s;
		CHECK(watch_with_task(along(X, { drag }), 4.0, lost_s).names == ABORTED);
		CHECK_MESSAGE(frozen(with_task(), drag, lost_s, 4.0).names == EventNames{ "started sideways" },
				"freeze: the hand may have stopped");
		const Events found = watch_with_task(along(X, { drag }), 4.0, lost_s, lost_s + 0.7);
		CHECK(found.names == times(1, "sideways"));
		CHECK(found.last_ended_s > lost_s + 0.7);
	}
	CHECK_MESSAGE(watch_with_task(along(X, { drag }), 4.0, drag.onset_s + 0.56).names == times(1, "sideways"),
			"later dropout: the end is within the bridged time");
	const Drag half{ .onset_s = 0.6, .duration_s = 0.7, .amplitude_m = 0.12 };
	for (const double found_s : { 1.3, 1.95 }) {
		const Events halted = watch_with_task(along(X, { half }), found_s + 1.0, 1.05, found_s);
		CHECK(has_no_end(halted));
		CHECK(std::abs(halted.last_value_m - half.amplitude_m) < 0.006);
	}
}

TEST_CASE("with a task a dropout at rest starts nothing") {
	constexpr double LOST_S = 3.3, FOUND_S = 5.0;
	for (const double rests_m : { -0.15, -0.03, 0.0, 0.01 }) {
		CAPTURE(rests_m);
		const TestPath path = along(X, { { 1.0, 0.8, rests_m } });
		const Events soon = watch_with_task(path, LOST_S + 0.95, LOST_S);
		CHECK(soon.names.empty());
		// After a dropout at the start the hand may have begun to move.
		CHECK((rests_m >= 0.0 || std::abs(soon.last_value_m - rests_m) < 0.02));
		const Events gone = watch_with_task(path, 6.0, LOST_S);
		CHECK(gone.names.empty());
		CHECK(std::abs(gone.last_value_m) < 0.001);
		CHECK(gone.largest_step < 1.01 * FASTEST_M_MS);
		const Events back = watch_with_task(path, 6.0, LOST_S, FOUND_S);
		CHECK(back.names.empty());
		CHECK(std::abs(back.last_value_m - rests_m) < 0.005);
		CHECK(back.largest_step < 1.01 * FASTEST_M_MS);
	}
}

TEST_CASE("with a task a track that begins early in the movement ends") {
	for (const auto &[duration_s, share] :
			{ std::pair{ 0.4, 0.02 }, { 0.4, 0.3 }, { 0.7, 0.4 }, { 2.0, 0.02 }, { 2.0, 0.4 } }) {
		INFO("duration ", duration_s, ", share ", share);
		const Events events = seen_from(share, duration_s, true);
		CHECK(events.names == times(1, "sideways"));
		CHECK(events.last_value_m == near(0.2).epsilon(0.02));
	}
}

TEST_CASE("with a task a track that begins late or elsewhere ends nothing") {
	for (const double share : { 0.55, 0.9 }) {
		CAPTURE(share);
		CHECK(seen_from(share, 0.7, true).names.empty());
	}
	for (const double share : { 0.05, 0.4 }) {
		CAPTURE(share);
		CHECK_MESSAGE(has_no_end(seen_from(share, 0.7, true, Y)), "upward");
		CHECK_MESSAGE(has_no_end(seen_from(share, 0.7, true, -X)), "opposite direction");
		CHECK_MESSAGE(has_no_end(seen_from(share, 0.7, true, X, 0.12 * Y)), "beside it");
		CHECK_MESSAGE(has_no_end(seen_from(share, 0.7, true, X, { -0.2, 0.0, 0.0 })), "to its start");
	}
}

TEST_CASE("without a task a track that begins after the onset starts nothing") {
	for (const double duration_s : { 0.4, 2.0 }) {
		CAPTURE(duration_s);
		CHECK(seen_from(0.01, duration_s, false).names == times(1, "sideways"));
		for (const double share : { 0.3, 0.7 }) {
			CAPTURE(share);
			CHECK(seen_from(share, duration_s, false).names.empty());
		}
	}
}
