// A hand that leaves, or that the tracker freezes, while its gesture is under way.

#include "gesture_events.h"
#include "near.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

/// Of DRAG: 10 s^3 - 15 s^4 + 6 s^5 is 0.93 at s = 0.76, and 0.64 at s = 0.57.
constexpr double NEAR_END_S = 0.6 + 0.76, HALF_WAY_S = 0.6 + 0.57;
constexpr double AHEAD_S = 1.0 / 110.0; ///< the last frame before is up to so much older

/// The tracker repeats what it saw last, to the last bit.
Events frozen(double from_s, double length_s) {
	GestureRecogniser recogniser(models(), std::nullopt, MotionMode::PHASE);
	const Way way = [=](double t_s) { return Eigen::Vector3d(DRAG.x_m(std::min(t_s, from_s)) * X); };
	return watch(recogniser, way, length_s, 1e9, 1e9, 110.0, 0.0);
}

} // namespace

TEST_CASE("with nothing given a hand that is gone near the end has made the gesture, 0.3 s later") {
	for (const double back_s : { 1e9, 3.5 }) {
		const Events events = in_the_open(along(X, { DRAG }), 4.0, NEAR_END_S, back_s);
		CHECK(events.said == times(1, "sideways"));
		CHECK(events.last_ended_s > NEAR_END_S + 0.3 - AHEAD_S);
		CHECK(events.last_ended_s <= NEAR_END_S + 0.301);
		CHECK(events.largest_step < 1.01 * FASTEST_M_MS);
	}
	for (const double length_s : { NEAR_END_S + 0.98, NEAR_END_S + 1.2 }) { // it is held for a second
		const Events events = in_the_open(along(X, { DRAG }), length_s, NEAR_END_S);
		CHECK(events.said == times(1, "sideways"));
		CHECK(std::abs(events.last_value_m - (length_s < NEAR_END_S + 1.0 ? 0.2 : 0.0)) < 0.005);
	}
	const Events events = frozen(NEAR_END_S, 4.0);
	CHECK(events.said == times(1, "sideways"));
	CHECK(events.last_value_m == near(0.0));
	CHECK(events.last_ended_s <= NEAR_END_S + 0.31); // the frame that freezes may be the next one
}

TEST_CASE("a frame at the very instant at which a hand has been gone for long enough does not hide that") {
	int at_once = 0;
	for (int last = 140; last < 160; ++last) { // of a hundred frames a second
		const double last_s = last / 100.0;
		const Way way = [=](double t_s) { return Eigen::Vector3d(DRAG.x_m(std::min(t_s, last_s)) * X); };
		GestureRecogniser recogniser(models(), std::nullopt, MotionMode::PAPER);
		const Events events = watch(recogniser, way, last_s + 0.4, 1e9, 1e9, 100.0, 0.0);
		CHECK(events.said == times(1, "sideways"));
		CHECK(events.last_ended_s < last_s + 0.302);
		at_once += (last + 30) / 100.0 == last_s + 0.3 ? 1 : 0;
	}
	CHECK(at_once > 0);
}

TEST_CASE("with nothing given fingers that a zoom misses end no drag of the one that is seen") {
	const Drag drag{ .onset_s = 0.6, .duration_s = 2.0, .amplitude_m = 0.2 };
	const double lost_s = drag.onset_s + 1.0; // 0.3 s later the drag is at 0.76 of its way
	GestureRecogniser recogniser({ zoom_model(0.016, 0.03), models()[0] }, std::nullopt, MotionMode::PHASE);
	double ended_s = INFINITY;
	for (int i = 0; i < 300; ++i) {
		HandFrame frame;
		frame.t_s = 0.01 * i;
		frame.set(Joint::INDEX, (drag.x_m(frame.t_s) + 1e-4 * std::sin(3.0 * i)) * X);
		if (frame.t_s < lost_s) {
			frame.set(Joint::THUMB, frame.position(Joint::INDEX) - 0.03 * Y);
			frame.set(Joint::MIDDLE, frame.position(Joint::INDEX) - 0.02 * Y + 0.02 * X);
		}
		recogniser.push(frame);
		if (recogniser.gesture() == 1 && recogniser.session()->stage() == GestureSession::Stage::ENDED) {
			ended_s = std::min(ended_s, frame.t_s);
		}
	}
	CHECK(ended_s > drag.onset_s + 1.6); // 0.94
	CHECK(ended_s < drag.onset_s + 2.0);
}

TEST_CASE("with nothing given a hand that is gone half-way has made none: that is said a second later") {
	for (const Events &events :
			{ in_the_open(along(X, { DRAG }), 4.0, HALF_WAY_S), frozen(HALF_WAY_S, 4.0) }) {
		CHECK(events.said == std::vector<std::string>{ "started sideways", "aborted sideways" });
		CHECK(events.largest_step < 1.01 * FASTEST_M_MS);
	}
	CHECK(none_ends(in_the_open(along(X, { DRAG }), HALF_WAY_S + 1.0 - 2.0 * AHEAD_S, HALF_WAY_S)));
}

TEST_CASE("what was seen of a hand that is gone has made the gesture from 0.7 of the amplitude on") {
	// In `paper` mode: in `phase` mode what goes on unseen may arrive before. Where its stroke was told, the
	// hand had gone 0.04 of the way.
	for (const double share : { 0.71, 0.78 }) {
		double lost_s = DRAG.onset_s;
		while (DRAG.x_m(lost_s) < share * DRAG.amplitude_m) {
			lost_s += 0.001;
		}
		GestureRecogniser recogniser(models(), std::nullopt, MotionMode::PAPER);
		CHECK(none_ends(watch(recogniser, along(X, { DRAG }), 4.0, lost_s, 1e9)) == (share < 0.74));
	}
}

TEST_CASE("with nothing given a gesture goes on after a gap, at the end and half-way") {
	for (const double lost_s : { HALF_WAY_S, NEAR_END_S - 0.1 }) {
		const Events events = in_the_open(along(X, { DRAG }), 3.0, lost_s, lost_s + 0.28);
		CHECK(events.said == times(1, "sideways"));
		CHECK(events.last_ended_s > lost_s + 0.28);
	}
}

TEST_CASE("when a hand is missed does not depend on how often the motion is asked for") {
	for (const double lost_s : { HALF_WAY_S, NEAR_END_S }) {
		GestureRecogniser often(models(), std::nullopt, MotionMode::PHASE),
				seldom(models(), std::nullopt, MotionMode::PHASE);
		for (int frames = 0; frames / 110.0 < lost_s; ++frames) {
			HandFrame frame;
			frame.t_s = frames / 110.0;
			frame.set(Joint::INDEX, DRAG.x_m(frame.t_s) * X);
			often.push(frame);
			seldom.push(frame);
		}
		for (int ms = 0; ms <= 3000; ++ms) {
			often.advance(ms / 1000.0);
		}
		seldom.advance(3.0);
		REQUIRE((often.session() != nullptr) == (seldom.session() != nullptr));
		CHECK(often.motion(MotionSource::SYNTHESISED).value_m ==
				seldom.motion(MotionSource::SYNTHESISED).value_m);
		if (often.session() != nullptr) {
			CHECK(often.session()->stage_began_s() == seldom.session()->stage_began_s());
			CHECK(often.confidence() == seldom.confidence());
		}
	}
}

TEST_CASE(
		"with a task a hand that is gone for a second has given its gesture up, and no end is held for it") {
	const Drag half_way{ .onset_s = 0.6, .duration_s = 1.0, .amplitude_m = 0.1 };
	const double lost_s = 2.5;
	const Events halted = in_a_task(along(X, { half_way }), 4.0, lost_s);
	CHECK(halted.said == std::vector<std::string>{ "started sideways", "aborted sideways" });
	CHECK(std::abs(halted.last_value_m) < 1e-9);
	CHECK(halted.largest_step < 1.01 * FASTEST_M_MS);
	for (const double length_s : { lost_s + 0.98, lost_s + 1.2 }) {
		const Events halting = in_a_task(along(X, { half_way }), length_s, lost_s);
		CHECK(halting.said.size() == (length_s < lost_s + 1.0 ? 1 : 2));
		const Events arrived = in_a_task(along(X, { DRAG }), length_s, lost_s);
		CHECK(arrived.said == times(1, "sideways"));
		CHECK(std::abs(arrived.last_value_m - (length_s < lost_s + 1.0 ? 0.2 : 0.0)) < 0.005);
		CHECK(arrived.largest_step < 1.01 * FASTEST_M_MS);
	}
}

TEST_CASE("with a task a hand that was gone and is back is followed from there, without a step") {
	// At the end, as it was left; at rest half-way; and at the start, for another drag.
	const Events at_end = in_a_task(along(X, { DRAG }), 5.0, 2.5, 4.0);
	CHECK(at_end.said == times(1, "sideways"));
	CHECK(at_end.last_value_m == near(0.2).epsilon(0.01));
	CHECK(at_end.largest_step < 1.01 * FASTEST_M_MS);
	const Drag away{ .onset_s = 3.0, .duration_s = 0.5, .amplitude_m = -0.1 };
	const Events half_way = in_a_task(along(X, { DRAG, away }), 5.0, 2.5, 4.0);
	CHECK(half_way.said == times(1, "sideways"));
	CHECK(half_way.last_value_m == near(0.1).epsilon(0.01));
	CHECK(half_way.largest_step < 1.01 * FASTEST_M_MS);
	const Drag back{ .onset_s = 3.0, .duration_s = 0.5, .amplitude_m = -0.2 };
	const Drag again{ .onset_s = 4.6, .duration_s = 1.0, .amplitude_m = 0.2 };
	const Events twice = in_a_task(along(X, { DRAG, back, again }), 7.0, 2.5, 4.0);
	CHECK(twice.said == times(2, "sideways"));
	CHECK(std::abs(twice.last_ended_s - 5.6) < 0.25);
}

TEST_CASE("as in `paper` mode, where nothing begins before it is back") {
	for (const double length_s : { 3.48, 3.7, 6.0 }) {
		GestureRecogniser recogniser({ models()[0] }, Task{}, MotionMode::PAPER);
		const Events events = watch(recogniser, along(X, { DRAG }), length_s, 2.5);
		CHECK(events.said == times(1, "sideways"));
		CHECK(std::abs(events.last_value_m - (length_s < 3.5 ? 0.2 : 0.0)) < 0.005);
	}
}

TEST_CASE("with a task a hand before a tracker that repeats itself is not gone") {
	GestureRecogniser recogniser({ models()[0] }, Task{}, MotionMode::PHASE);
	const Way way = [](double t_s) { return Eigen::Vector3d(DRAG.x_m(t_s) * X); };
	const Events events = watch(recogniser, way, 6.0, 1e9, 1e9, 110.0, 0.0);
	CHECK(events.said == times(1, "sideways"));
	CHECK(events.last_value_m == near(0.2).epsilon(0.01));
}

TEST_CASE("with the task known the end of a hand that is gone half-way is not said to have come") {
	const Drag drag{ .onset_s = 0.6, .duration_s = 0.8, .amplitude_m = 0.2 };
	for (const double share : { 0.3, 0.4, 0.5 }) { // of the time: 16 to 50 % of the way
		CAPTURE(share);
		const double gone_s = drag.onset_s + share * drag.duration_s;
		CHECK(in_a_task(along(X, { drag }), 4.0, gone_s).said ==
				std::vector<std::string>{ "started sideways", "aborted sideways" });
		// Seen again where it has arrived meanwhile, it has made the gesture.
		const Events found = in_a_task(along(X, { drag }), 4.0, gone_s, gone_s + 0.7);
		CHECK(found.said == times(1, "sideways"));
		CHECK(found.last_ended_s > gone_s + 0.7);
	}
	// What is bridged ends in time.
	CHECK(in_a_task(along(X, { drag }), 4.0, drag.onset_s + 0.56).said == times(1, "sideways"));
}

TEST_CASE("with a task a hand that is seen again half-way, where it stands, has not come to the end "
		  "meanwhile") {
	for (const double halts_m : { 0.09, 0.1, 0.11, 0.12 }) {
		const Drag half{ .onset_s = 0.6, .duration_s = 0.7, .amplitude_m = halts_m };
		for (const double lost_s : { 0.85, 0.95, 1.05, 1.15, 1.3 }) {
			for (const double gap_s : { 0.25, 0.35, 0.5, 0.7, 0.9 }) {
				CAPTURE(halts_m);
				CAPTURE(lost_s);
				CAPTURE(gap_s);
				const Events events =
						in_a_task(along(X, { half }), lost_s + gap_s + 1.0, lost_s, lost_s + gap_s);
				CHECK(none_ends(events));
				CHECK(std::abs(events.last_value_m - halts_m) < 0.006);
			}
		}
	}
}

TEST_CASE("a hand that rests behind its task's start and leaves the view is not led on") {
	for (const double behind_m : { 0.02, 0.03, 0.05, 0.08, 0.15 }) {
		for (const double duration_s : { 0.4, 0.8, 1.2 }) {
			for (const double rests_s : { 0.5, 1.5, 3.0 }) {
				for (const double noise_m : { 0.0, 2e-4 }) {
					CAPTURE(behind_m);
					CAPTURE(duration_s);
					CAPTURE(rests_s);
					CAPTURE(noise_m);
					const Drag away{ 1.0, duration_s, -behind_m };
					const double lost_s = 1.0 + duration_s + rests_s;
					GestureRecogniser recogniser({ { models()[0], Task{} } });
					const Events events =
							watch(recogniser, along(X, { away }), lost_s + 0.95, lost_s, 1e9, 100.0, noise_m);
					CHECK(events.said.empty());
					CHECK(std::abs(events.last_value_m + behind_m) < 0.02);
				}
			}
		}
	}
}

TEST_CASE("with a task nobody's hand is where it starts, wherever one rested that has gone for a second") {
	for (const double rests_m : { -0.15, -0.03, -0.01, 0.0, 0.01 }) {
		CAPTURE(rests_m);
		const Way way = along(X, { { 1.0, 0.8, rests_m } });
		const Events gone = in_a_task(way, 6.0, 3.3);
		CHECK(gone.said.empty());
		CHECK(std::abs(gone.last_value_m) < 0.001);
		CHECK(gone.largest_step < 1.01 * FASTEST_M_MS);
		const Events back = in_a_task(way, 6.0, 3.3, 5.0);
		CHECK(back.said.empty());
		CHECK(std::abs(back.last_value_m - rests_m) < 0.005);
		CHECK(back.largest_step < 1.01 * FASTEST_M_MS);
	}
}
