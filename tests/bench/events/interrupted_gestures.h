#pragma once

#include "draws.h"
#include "hand_plan.h"
#include "performance.h"

namespace steadyhand::bench {

// Hands that halt or turn before the end, or leave the view.

inline void hesitate(Performance &hand, Draws &draws) {
	const double part = draws.between(0.2, hand.is_open() ? 0.55 : 0.8);
	hand.set_out().go_to(part).rest(draws.between(0.2, 0.9)).go_to(1.0).arrive().end_plainly();
}

/// Where nothing is given, what comes after a halt of more than a second may be a gesture of its own.
inline void halt_and_go_on(Performance &hand, Draws &draws) {
	const double part = draws.between(0.2, 0.65);
	hand.set_out().go_to(part).rest(draws.between(1.05, 10.0)).go_to(1.0);
	hand.arrive({ .is_optional = hand.is_open() }).end_plainly();
}

inline void halt_and_go_back(Performance &hand, Draws &draws) {
	const double part = draws.between(0.2, 0.6);
	hand.go_to(part).rest(draws.between(1.0, 10.0)).go_to(0.0).rest(1.5).end_plainly();
}

inline void overshoot(Performance &hand, Draws &draws) {
	const double part = draws.between(1.05, 1.35);
	hand.set_out().go_to(part, hand.movement().duration_s).arrive();
	hand.rest(draws.between(0.0, 0.2)).go_to(1.0, 0.25).end_plainly();
}

/// Where nothing is given, a part is one of the length that is usual.
inline void begin_with_known_length(Performance &hand) {
	if (hand.is_open()) {
		hand.begin(hand.typical(hand.movement()));
	}
}

inline void stop_short(Performance &hand, Draws &draws) {
	begin_with_known_length(hand);
	const double part = draws.between(0.72, 0.95);
	hand.set_out().go_to(part, hand.movement().duration_s).arrive().end_plainly();
}

inline void turn_half_way(Performance &hand, Draws &draws) {
	begin_with_known_length(hand);
	hand.go_to(draws.between(0.2, 0.55)).go_to(0.0).rest(1.5).end_plainly();
}

inline void turn_at_the_end(Performance &hand, Draws &draws) {
	const double part = draws.between(0.92, 1.0), duration_s = hand.movement().duration_s;
	hand.set_out().go_to(part, duration_s).arrive().go_to(0.0, duration_s).rest(1.5).end_plainly();
}

inline void go_back_and_on(Performance &hand, Draws &draws) {
	const double duration_s = hand.movement().duration_s;
	const double part = draws.between(0.3, hand.is_open() ? 0.55 : 0.75);
	const double turn = part - draws.between(0.1, 0.25);
	hand.set_out().go_to(part).go_to(turn, 0.45 * duration_s);
	hand.go_to(1.0, (1.0 - 0.5 * turn) * duration_s).arrive().end_plainly();
}

struct Loss {
	double part, gap_s;
	/// A gesture is let go after a second out of view.
	[[nodiscard]] bool is_long() const { return gap_s > 1.0; }
};

inline Loss draw_loss(Draws &draws) {
	const double part = draws.between(0.1, 0.9);
	return { part, draws.below(2) == 1 ? draws.between(0.2, 0.7) : draws.between(1.2, 5.0) };
}

/// When a movement that goes on to its end is there, from when it sets out, to a hundredth of its duration.
inline double time_of_part_s(double part, double duration_s) {
	int percent = 0;
	while (percent < 100 && minimum_jerk(percent / 100.0) < part) {
		++percent;
	}
	return duration_s * percent / 100.0;
}

inline void wait_out_of_view(Performance &hand, Draws &draws) {
	const Loss loss = draw_loss(draws);
	hand.set_out().go_to(loss.part).rest(loss.gap_s);
	hand.plan().hide(hand.now_s() - loss.gap_s - 0.02, hand.now_s());
	hand.rest(0.05).go_to(1.0).arrive({ .is_optional = loss.is_long() || hand.is_open() });
	hand.end_plainly(0.5, true);
}

inline void come_back_at_the_start(Performance &hand, Draws &draws) {
	const Loss loss = draw_loss(draws);
	const double duration_s = hand.movement().duration_s;
	const double gone_s = hand.now_s() + time_of_part_s(loss.part, duration_s);
	hand.make_gesture(duration_s, { .is_optional = true }).go_to(0.0, 0.15).rest_until(gone_s + loss.gap_s);
	hand.plan().hide(gone_s, hand.now_s());
	hand.rest(1.5).end_plainly();
}

inline void come_back_at_the_end(Performance &hand, Draws &draws) {
	const Loss loss = draw_loss(draws);
	const double duration_s = hand.movement().duration_s;
	const double gone_s = hand.now_s() + time_of_part_s(loss.part, duration_s);
	const bool is_optional = loss.is_long() || (hand.is_open() && loss.part < 0.72);
	hand.make_gesture(duration_s, { is_optional, loss.gap_s + 1.0 }).rest_until(gone_s + loss.gap_s);
	hand.plan().hide(gone_s, gone_s + loss.gap_s);
	hand.end_plainly(0.6, true);
}

} // namespace steadyhand::bench
