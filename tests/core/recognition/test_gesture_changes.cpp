#include "gesture_events.h"
#include "recognition/gesture_changes.h"

#include <doctest/doctest.h>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr ShownGesture NOTHING, DRAG_MOVES{ 0, 1, 0, false }, DRAG_NEAR_END{ 0, 1, 3, false },
		DRAG_ENDS{ 0, 1, 3, true }, SECOND_DRAG{ 0, 2, 0, false }, SHORT_DRAG{ 0, 2, 3, true },
		TAP_MOVES{ 1, 1, 0, false };

constexpr GestureChanges STARTS{ .started = true, .state_changed = true },
		STATE_CHANGES{ .state_changed = true }, ABORTS{ .aborted = true, .state_changed = true },
		ENDS{ .ended = true }, IS_REPLACED{ .aborted = true, .started = true, .state_changed = true },
		STARTS_AND_ENDS{ .started = true, .state_changed = true, .ended = true };

} // namespace

TEST_CASE("changes_between() reports starts, state changes, ends and aborts") {
	CHECK(changes_between(NOTHING, NOTHING) == GestureChanges());
	CHECK(changes_between(DRAG_MOVES, DRAG_MOVES) == GestureChanges());
	CHECK(changes_between(NOTHING, DRAG_MOVES) == STARTS);
	CHECK(changes_between(DRAG_MOVES, DRAG_NEAR_END) == STATE_CHANGES);
	CHECK(changes_between(DRAG_NEAR_END, DRAG_ENDS) == ENDS);
	CHECK(changes_between(DRAG_MOVES, NOTHING) == ABORTS);
	CHECK_MESSAGE(changes_between(DRAG_ENDS, NOTHING) == STATE_CHANGES, "an ended gesture does not abort");
}

TEST_CASE("a gesture that replaces an active one aborts that one") {
	CHECK(changes_between(DRAG_MOVES, TAP_MOVES) == IS_REPLACED);
	CHECK_MESSAGE(changes_between(DRAG_ENDS, TAP_MOVES) == STARTS, "after an ended gesture");
	CHECK_MESSAGE(
			changes_between(DRAG_ENDS, SECOND_DRAG) == STARTS, "after an ended gesture of the same model");
	CHECK_MESSAGE(
			changes_between(DRAG_NEAR_END, SECOND_DRAG) == IS_REPLACED, "aborts and starts at one instant");
	CHECK_MESSAGE(
			changes_between(DRAG_ENDS, SHORT_DRAG) == STARTS_AND_ENDS, "starts and ends at one instant");
}

TEST_CASE("shown_gesture() gives idle, active and ended of a drag") {
	GestureRecogniser recogniser({ models()[0] }, Task{}, MotionMode::PHASE);
	CHECK(shown_gesture(recogniser) == NOTHING);
	bool moved = false;
	for (const HandFrame &frame : drag_track(DRAG, 100.0, 2.5).frames) {
		recogniser.push(frame);
		const ShownGesture now = shown_gesture(recogniser);
		moved = moved || (now.gesture == 0 && now.number == 1 && !now.has_ended);
	}
	CHECK(moved);
	CHECK(shown_gesture(recogniser) == DRAG_ENDS);
}
