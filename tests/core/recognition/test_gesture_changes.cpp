#include "recognition/gesture_changes.h"

#include <doctest/doctest.h>

#include <string>

using namespace steadyhand;

namespace {

constexpr ShownGesture NONE, DRAG_MOVES{ 0, 1, 0, false }, DRAG_NEAR_END{ 0, 1, 3, false },
		DRAG_ENDS{ 0, 1, 3, true }, SECOND_DRAG{ 0, 2, 0, false }, SHORT_DRAG{ 0, 2, 3, true },
		TAP_MOVES{ 1, 1, 0, false };

constexpr GestureChanges NO_CHANGE, STARTS{ .started = true, .state_changed = true },
		STATE_CHANGES{ .state_changed = true }, ABORTS{ .aborted = true, .state_changed = true },
		ENDS{ .ended = true }, IS_REPLACED{ .aborted = true, .started = true, .state_changed = true },
		STARTS_AND_ENDS{ .started = true, .state_changed = true, .ended = true };

struct Row {
	std::string what;
	ShownGesture before, now;
	GestureChanges changes;
};

} // namespace

TEST_CASE("changes_between() reports starts, state changes, ends and aborts") {
	for (const auto &[what, before, now, changes] : {
				 Row{ "idle", NONE, NONE, NO_CHANGE },
				 { "the same", DRAG_MOVES, DRAG_MOVES, NO_CHANGE },
				 { "start", NONE, DRAG_MOVES, STARTS },
				 { "later state", DRAG_MOVES, DRAG_NEAR_END, STATE_CHANGES },
				 { "end", DRAG_NEAR_END, DRAG_ENDS, ENDS },
				 { "abort", DRAG_MOVES, NONE, ABORTS },
				 { "an ended gesture does not abort", DRAG_ENDS, NONE, STATE_CHANGES },
				 { "another gesture", DRAG_MOVES, TAP_MOVES, IS_REPLACED },
				 { "another gesture after an end", DRAG_ENDS, TAP_MOVES, STARTS },
				 { "the same gesture after an end", DRAG_ENDS, SECOND_DRAG, STARTS },
				 { "aborts and starts at one instant", DRAG_NEAR_END, SECOND_DRAG, IS_REPLACED },
				 { "starts and ends at one instant", DRAG_ENDS, SHORT_DRAG, STARTS_AND_ENDS },
		 }) {
		INFO(what);
		CHECK(changes_between(before, now) == changes);
	}
}
