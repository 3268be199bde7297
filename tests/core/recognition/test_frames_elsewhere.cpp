// A hand that rests to the last bit, before a tracker that shows it elsewhere, or holds its pose.

#include "gesture_events.h"

#include <doctest/doctest.h>

using namespace steadyhand;
using namespace steadyhand::test;

TEST_CASE("a hand at rest that a single frame shows at its task's end, or beside it, is at rest") {
	constexpr double REST_S = 1.5, FRAME_S = 1.0, SETTLED_S = 0.1, RATE_HZ = 100.0;
	for (const double tremor_m : { 0.0, 1e-4 }) {
		for (const double part : { 0.8, 0.9, 1.0, 1.1, 1.3 }) {
			CAPTURE(tremor_m);
			CAPTURE(part);
			GestureRecogniser task({ models()[0] }, Task{}, MotionMode::PHASE);
			Tremor tremor(tremor_m, 1);
			for (int i = 0; i < static_cast<int>(REST_S * RATE_HZ); ++i) {
				HandFrame frame;
				frame.t_s = i / RATE_HZ;
				const bool is_paused = i == static_cast<int>(FRAME_S * RATE_HZ);
				frame.set(Joint::INDEX, (is_paused ? part * Task{}.amplitude_m : 0.0) * X + tremor());
				task.push(frame);
				task.advance(frame.t_s + 0.009);
				if (frame.t_s > FRAME_S + SETTLED_S) {
					CHECK(std::abs(task.motion(MotionSource::SYNTHESISED).value_m) < 5e-3);
				}
			}
		}
	}
}

TEST_CASE("a tracker that rounds, and holds its pose as the hand sets out, has shown no step") {
	constexpr double HELD_S = 0.2, GRID_M = 2e-3, TREMOR_M = 3e-4;
	for (const double duration_s : { 0.4, 0.8 }) {
		for (const double share : { 0.1, 0.2, 0.3 }) {
			for (unsigned seed = 0; seed < 10; ++seed) {
				CAPTURE(duration_s);
				CAPTURE(share);
				CAPTURE(seed);
				const Drag drag{ .onset_s = 1.2, .duration_s = duration_s, .amplitude_m = 0.2 };
				const double from_s = drag.onset_s + share * duration_s;
				Tremor tremor(TREMOR_M, seed);
				const Way seen = [&](double t_s) { return rounded(drag.x_m(t_s) * X + tremor(), GRID_M); };
				const Way way = held(seen, from_s, from_s + HELD_S);
				GestureRecogniser open(models(), std::nullopt, MotionMode::PHASE);
				CHECK(watch(open, way, 2.8, 1e9, 1e9, 100.0, 0.0).said == times(1, "sideways"));
			}
		}
	}
}
