#include "gesture_events.h"
#include "recognition/gesture_news.h"

#include <doctest/doctest.h>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr GestureShown NOTHING, DRAG_MOVES{ 0, 1, 0, false }, DRAG_NEAR_END{ 0, 1, 3, false },
		DRAG_ENDS{ 0, 1, 3, true }, SECOND_DRAG{ 0, 2, 0, false }, SHORT_DRAG{ 0, 2, 3, true },
		TAP_MOVES{ 1, 1, 0, false };

constexpr GestureNews BEGINS{ .started = true, .state_changed = true },
		STATE_CHANGES{ .state_changed = true }, IS_GIVEN_UP{ .aborted = true, .state_changed = true },
		ENDS{ .ended = true }, GIVES_WAY{ .aborted = true, .started = true, .state_changed = true },
		BEGINS_AND_ENDS{ .started = true, .state_changed = true, .ended = true };

} // namespace

TEST_CASE("what is news of gestures between two instants") {
	CHECK(news(NOTHING, NOTHING) == GestureNews());
	CHECK(news(DRAG_MOVES, DRAG_MOVES) == GestureNews());
	CHECK(news(NOTHING, DRAG_MOVES) == BEGINS);
	CHECK(news(DRAG_MOVES, DRAG_NEAR_END) == STATE_CHANGES);
	CHECK(news(DRAG_NEAR_END, DRAG_ENDS) == ENDS);
	CHECK(news(DRAG_MOVES, NOTHING) == IS_GIVEN_UP);
	CHECK_MESSAGE(news(DRAG_ENDS, NOTHING) == STATE_CHANGES, "what has ended is over, and not given up");
}

TEST_CASE("a gesture that takes another one's place") {
	CHECK(news(DRAG_MOVES, TAP_MOVES) == GIVES_WAY);
	CHECK_MESSAGE(news(DRAG_ENDS, TAP_MOVES) == BEGINS, "after one that has ended");
	CHECK_MESSAGE(news(DRAG_ENDS, SECOND_DRAG) == BEGINS, "after one of the same model");
	CHECK_MESSAGE(
			news(DRAG_NEAR_END, SECOND_DRAG) == GIVES_WAY, "given up and begun again within an instant");
	CHECK_MESSAGE(news(DRAG_ENDS, SHORT_DRAG) == BEGINS_AND_ENDS, "begun and ended within an instant");
}

TEST_CASE("what a recogniser shows of a drag") {
	GestureRecogniser recogniser({ models()[0] }, Task{}, MotionMode::PHASE);
	CHECK(shown_by(recogniser) == NOTHING);
	bool moved = false;
	for (int i = 0; i < 250; ++i) {
		HandFrame frame;
		frame.t_s = i / 100.0;
		frame.set(Joint::INDEX, Eigen::Vector3d(x_m({ DRAG }, frame.t_s), 0.0, 0.0));
		recogniser.push(frame);
		const GestureShown now = shown_by(recogniser);
		moved = moved || (now.gesture == 0 && now.begun == 1 && !now.arrived);
	}
	CHECK(moved);
	CHECK(shown_by(recogniser) == DRAG_ENDS);
}
