#include "tracking/replay_ring.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace steadyhand;

namespace {

struct Frame {
	double t_s = 0.0;
	int value = 0;
};

/// A state that depends on each frame and on their order.
struct State {
	unsigned hash = 1;

	void take(const Frame &frame) { hash = hash * 31U + static_cast<unsigned>(frame.value); }
	bool operator==(const State &) const = default;
};

void replay(State &r_state, const Frame &frame) {
	r_state.take(frame);
}

} // namespace

TEST_CASE("frames taken back leave the state as if they had not been") {
	for (int count = 1; count < 60; ++count) {
		for (int taken = 0; taken <= std::min(count, 8); ++taken) {
			ReplayRing<Frame, State, 16> ring;
			State state, expected;
			ring.start(state);
			for (int i = 0; i < count; ++i) {
				const Frame frame{ 0.01 * i, i + 1 };
				ring.push(frame, state);
				state.take(frame);
				if (i < count - taken) {
					expected.take(frame);
				}
			}
			CHECK((ring.retract(0.01 * (count - taken) - 1e-9, state, replay) || taken == 0 ||
					taken == count));
			CHECK(state == expected);
			// And goes on from there.
			const Frame next{ 1.0, 77 };
			ring.push(next, state);
			state.take(next);
			expected.take(next);
			ring.retract(2.0, state, replay);
			CHECK(state == expected);
		}
	}
}

TEST_CASE("of frames older than the ring those that remain are taken back") {
	ReplayRing<Frame, State, 8> ring;
	State state;
	ring.start(state);
	for (int i = 0; i < 100; ++i) {
		ring.push({ 1.0 * i, i }, state);
		state.take({ 1.0 * i, i });
	}
	CHECK_FALSE(ring.retract(10.0, state, replay));
	CHECK(ring.size() == 0);
}
