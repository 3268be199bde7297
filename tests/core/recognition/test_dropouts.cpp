// Dropouts and freezes before, during and after a movement.

#include "gesture_events.h"
#include "near.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

/// Times at which DRAG is at 0.93 and 0.64 of its amplitude.
constexpr double NEAR_END_S = 0.6 + 0.76, HALF_WAY_S = 0.6 + 0.57;
constexpr double FRAME_S = 1.0 / 110.0; ///< the last frame before a dropout may be this much older
const TestPath REACH = along(X, { DRAG });

/// Without noise: the tracker repeats its last measurement exactly.
Events frozen(GestureRecogniser &&recogniser, const TestPath &path, double from_s, double length_s) {
	return watch(recogniser, held(path, from_s, NEVER_S), length_s, { .noise_m = 0.0 });
}

/// Events of a hand whose track begins at this fraction of the drag's amplitude.
Events seen_from(GestureRecogniser &&recogniser, double share, double duration_s,
		const Eigen::Vector3d &axis = X, const Eigen::Vector3d &start_m = Eigen::Vector3d::Zero()) {
	const Drag drag{ .onset_s = 0.6, .duration_s = duration_s, .amplitude_m = 0.2 };
	double seen_s = drag.onset_s;
	while (drag.x_m(seen_s) < share * drag.amplitude_m) {
		seen_s += 1e-3;
	}
	const TestPath path = [&](double t_s) { return Eigen::Vector3d(start_m + drag.x_m(t_s) * axis); };
	return watch(recogniser, path, 4.0, { .lost_from_s = -1.0, .lost_to_s = seen_s });
}

} // namespace

TEST_CASE("without a task a dropout near the end still ends the gesture") {
	for (const double back_s : { NEVER_S, 3.5 }) {
		const Events events = watch_without_task(REACH, 4.0, { NEAR_END_S, back_s });
		CHECK(events.names == ENDS);
		CHECK(events.last_ended_s > NEAR_END_S + 0.3 - FRAME_S);
		CHECK(events.last_ended_s <= NEAR_END_S + 0.311);
		CHECK(events.largest_step < 1.01 * FASTEST_M_MS);
	}
	const Events holds = watch_without_task(REACH, NEAR_END_S + 0.98, { NEAR_END_S });
	CHECK(std::abs(holds.last_value_m - 0.2) < 0.005);
	const Events returns = watch_without_task(REACH, NEAR_END_S + 1.2, { NEAR_END_S });
	CHECK(std::abs(returns.last_value_m) < 0.005);
	const Events freezes = frozen(without_task(), REACH, NEAR_END_S, 4.0);
	CHECK(freezes.names == ENDS);
	CHECK(freezes.last_value_m > 0.15);               // as of a hand that stays at the end
	CHECK(freezes.last_ended_s <= NEAR_END_S + 0.31); // the freeze may begin with the next frame
}

TEST_CASE("without a task a dropout in mid-gesture aborts after 1 s") {
	for (const Events &events : { watch_without_task(REACH, 4.0, { HALF_WAY_S }),
				 frozen(without_task(), REACH, HALF_WAY_S, 4.0) }) {
		CHECK(events.names == ABORTS);
		CHECK(events.largest_step < 1.01 * FASTEST_M_MS);
	}
	const double just_before_s = HALF_WAY_S + 1.0 - 2.0 * FRAME_S;
	CHECK(watch_without_task(REACH, just_before_s, { HALF_WAY_S }).names == STARTS);
}

TEST_CASE("with a task a dropout of 1 s resets the motion") {
	constexpr double LOST_S = 2.5, BEFORE_S = LOST_S + 0.98, AFTER_S = LOST_S + 1.2;
	const TestPath half_way = along(X, { { 0.6, 1.0, 0.1 } });
	const Events halted = watch_with_task(half_way, 4.0, { LOST_S });
	CHECK(halted.names == ABORTS);
	CHECK(std::abs(halted.last_value_m) < 1e-9);
	CHECK(halted.largest_step < 1.01 * FASTEST_M_MS);
	CHECK(watch_with_task(half_way, BEFORE_S, { LOST_S }).names == STARTS);
	CHECK(watch_with_task(half_way, AFTER_S, { LOST_S }).names == ABORTS);
	for (const MotionMode mode : { MotionMode::PHASE, MotionMode::PAPER }) {
		for (const double length_s : { BEFORE_S, AFTER_S }) {
			GestureRecogniser recogniser({ { models()[0], Task{} } }, { mode });
			const Events arrived = watch(recogniser, REACH, length_s, { LOST_S });
			CHECK(arrived.names == ENDS);
			CHECK(std::abs(arrived.last_value_m - (length_s < LOST_S + 1.0 ? 0.2 : 0.0)) < 0.005);
			CHECK((mode == MotionMode::PAPER || arrived.largest_step < 1.01 * FASTEST_M_MS));
		}
	}
}

TEST_CASE("a hand tracked again after 1.5 s is followed without a step") {
	const Drag half_back{ .onset_s = 3.0, .duration_s = 0.5, .amplitude_m = -0.1 };
	for (const auto &[strokes, found_m] :
			{ std::pair{ std::vector{ DRAG }, 0.2 }, std::pair{ std::vector{ DRAG, half_back }, 0.1 } }) {
		const Events events = watch_with_task(along(X, strokes), 5.0, { 2.5, 4.0 });
		CHECK(events.names == ENDS);
		CHECK(events.last_value_m == near(found_m).epsilon(0.01));
		CHECK(events.largest_step < 1.01 * FASTEST_M_MS);
	}
	const TestPath again = along(X, { DRAG, { 3.0, 0.5, -0.2 }, { 4.6, 1.0, 0.2 } });
	const Events twice = watch_with_task(again, 7.0, { 2.5, 4.0 });
	CHECK(twice.names == times(2, "horizontal_drag"));
	CHECK(std::abs(twice.last_ended_s - 5.6) < 0.25);
}

TEST_CASE("a gesture with a dropout half-way ends only after the dropout") {
	const TestPath reach = along(X, { { 0.6, 0.8, 0.2 } });
	for (const double lost_s : { 0.84, 1.0 }) { // at 16 and 50 % of the amplitude
		CAPTURE(lost_s);
		CHECK(watch_with_task(reach, 4.0, { lost_s }).names == ABORTS);
		CHECK_MESSAGE(frozen(with_task(), reach, lost_s, 4.0).names == STARTS, "the hand may have stopped");
		const Events found = watch_with_task(reach, 4.0, { lost_s, lost_s + 0.7 });
		CHECK(found.names == ENDS);
		CHECK(found.last_ended_s > lost_s + 0.7);
	}
	CHECK_MESSAGE(watch_with_task(reach, 4.0, { 1.16 }).names == ENDS, "the end is within the bridged time");
	for (const double found_s : { 1.3, 1.95 }) {
		const Events halted =
				watch_with_task(along(X, { { 0.6, 0.7, 0.12 } }), found_s + 1.0, { 1.05, found_s });
		CHECK(has_no_end(halted));
		CHECK(std::abs(halted.last_value_m - 0.12) < 0.006);
	}
}

TEST_CASE("with a task a dropout at rest starts nothing") {
	constexpr double LOST_S = 3.3, FOUND_S = 5.0;
	for (const double rests_m : { -0.15, -0.03, 0.0, 0.01 }) {
		CAPTURE(rests_m);
		const TestPath path = along(X, { { 1.0, 0.8, rests_m } });
		const Events soon = watch_with_task(path, LOST_S + 0.95, { LOST_S });
		CHECK(soon.names.empty());
		// After a dropout at the start the hand may have begun to move.
		CHECK((rests_m >= 0.0 || std::abs(soon.last_value_m - rests_m) < 0.02));
		const Events gone = watch_with_task(path, 6.0, { LOST_S });
		CHECK(gone.names.empty());
		CHECK(std::abs(gone.last_value_m) < 0.001);
		CHECK(gone.largest_step < 1.01 * FASTEST_M_MS);
		const Events back = watch_with_task(path, 6.0, { LOST_S, FOUND_S });
		CHECK(back.names.empty());
		CHECK(std::abs(back.last_value_m - rests_m) < 0.005);
		CHECK(back.largest_step < 1.01 * FASTEST_M_MS);
	}
	const Events rests = frozen(with_task(), REACH, NEVER_S, 6.0);
	CHECK(rests.names == ENDS);
	CHECK(rests.last_value_m == near(0.2).epsilon(0.01));
}

TEST_CASE("with a task a track that begins early in the movement ends") {
	for (const auto &[duration_s, share] :
			{ std::pair{ 0.4, 0.02 }, { 0.4, 0.3 }, { 0.7, 0.4 }, { 2.0, 0.02 }, { 2.0, 0.4 } }) {
		INFO("duration ", duration_s, ", share ", share);
		const Events events = seen_from(with_task(), share, duration_s);
		CHECK(events.names == ENDS);
		CHECK(events.last_value_m == near(0.2).epsilon(0.02));
	}
}

TEST_CASE("with a task a track that begins late or elsewhere ends nothing") {
	CHECK(seen_from(with_task(), 0.55, 0.7).names.empty());
	CHECK(seen_from(with_task(), 0.9, 0.7).names.empty());
	for (const double share : { 0.05, 0.4 }) {
		CAPTURE(share);
		CHECK_MESSAGE(has_no_end(seen_from(with_task(), share, 0.7, Y)), "upward");
		CHECK_MESSAGE(has_no_end(seen_from(with_task(), share, 0.7, -X)), "opposite direction");
		CHECK_MESSAGE(has_no_end(seen_from(with_task(), share, 0.7, X, 0.12 * Y)), "beside it");
		CHECK_MESSAGE(has_no_end(seen_from(with_task(), share, 0.7, X, -0.2 * X)), "to its start");
	}
}

TEST_CASE("without a task a track that begins late in the movement ends nothing") {
	for (const double duration_s : { 0.4, 2.0 }) {
		CAPTURE(duration_s);
		CHECK(seen_from(without_task(), 0.01, duration_s).names == ENDS);
		CHECK(has_no_end(seen_from(without_task(), 0.7, duration_s)));
	}
}
