#pragma once

#include "draws.h"
#include "hand_plan.h"
#include "performance.h"

namespace steadyhand::bench {

// Hands that pause or turn back before the end, and dropouts.

inline void hesitate(Performance &hand, Draws &draws) {
	const double part = draws.between(0.2, hand.has_task() ? 0.8 : 0.55);
	hand.begin_gesture()
			.go_to(part)
			.rest(draws.between(0.2, 0.9))
			.go_to(1.0)
			.end_gesture()
			.add_plain_gesture();
}

/// Without a task, the movement after a pause of more than a second may be another gesture.
inline void halt_and_go_on(Performance &hand, Draws &draws) {
	const double part = draws.between(0.2, 0.65);
	hand.begin_gesture().go_to(part).rest(draws.between(1.05, 10.0)).go_to(1.0);
	hand.end_gesture({ .is_optional = !hand.has_task() }).add_plain_gesture();
}

inline void halt_and_go_back(Performance &hand, Draws &draws) {
	const double part = draws.between(0.2, 0.6);
	hand.go_to(part).rest(draws.between(1.0, 10.0)).go_to(0.0).rest(1.5).add_plain_gesture();
}

inline void overshoot(Performance &hand, Draws &draws) {
	const double part = draws.between(1.05, 1.35);
	hand.begin_gesture().go_to(part, hand.movement().duration_s).end_gesture();
	hand.rest(draws.between(0.0, 0.2)).go_to(1.0, 0.25).add_plain_gesture();
}

/// Without a task, a fraction of the amplitude is defined only for the model's typical amplitude.
inline void begin_with_known_length(Performance &hand) {
	if (!hand.has_task()) {
		hand.begin(hand.typical(hand.movement()));
	}
}

inline void stop_short(Performance &hand, Draws &draws) {
	begin_with_known_length(hand);
	const double part = draws.between(0.72, 0.95);
	hand.begin_gesture().go_to(part, hand.movement().duration_s).end_gesture().add_plain_gesture();
}

inline void turn_half_way(Performance &hand, Draws &draws) {
	begin_with_known_length(hand);
	hand.go_to(draws.between(0.2, 0.55)).go_to(0.0).rest(1.5).add_plain_gesture();
}

inline void turn_at_the_end(Performance &hand, Draws &draws) {
	const double part = draws.between(0.92, 1.0), duration_s = hand.movement().duration_s;
	hand.begin_gesture()
			.go_to(part, duration_s)
			.end_gesture()
			.go_to(0.0, duration_s)
			.rest(1.5)
			.add_plain_gesture();
}

inline void go_back_and_on(Performance &hand, Draws &draws) {
	const double duration_s = hand.movement().duration_s;
	const double part = draws.between(0.3, hand.has_task() ? 0.75 : 0.55);
	const double turn = part - draws.between(0.1, 0.25);
	hand.begin_gesture().go_to(part).go_to(turn, 0.45 * duration_s);
	hand.go_to(1.0, (1.0 - 0.5 * turn) * duration_s).end_gesture().add_plain_gesture();
}

struct Loss {
	double part, gap_s;
	/// A gesture is aborted after a dropout of a second.
	[[nodiscard]] bool is_long() const { return gap_s > 1.0; }
};

inline Loss draw_loss(Draws &draws) {
	const double part = draws.between(0.1, 0.9);
	return { part, draws.below(2) == 1 ? draws.between(0.2, 0.7) : draws.between(1.2, 5.0) };
}

/// Time from the onset until a minimum-jerk movement reaches `part`, to a hundredth of its duration.
inline double time_of_part_s(double part, double duration_s) {
	int percent = 0;
	while (percent < 100 && minimum_jerk(percent / 100.0) < part) {
		++percent;
	}
	return duration_s * percent / 100.0;
}

inline void wait_out_of_view(Performance &hand, Draws &draws) {
	const Loss loss = draw_loss(draws);
	hand.begin_gesture().go_to(loss.part).rest(loss.gap_s);
	hand.plan().hide(hand.now_s() - loss.gap_s - 0.02, hand.now_s());
	hand.rest(0.05).go_to(1.0).end_gesture({ .is_optional = loss.is_long() || !hand.has_task() });
	hand.add_plain_gesture(0.5, true);
}

inline void come_back_at_the_start(Performance &hand, Draws &draws) {
	const Loss loss = draw_loss(draws);
	const double duration_s = hand.movement().duration_s;
	const double gone_s = hand.now_s() + time_of_part_s(loss.part, duration_s);
	hand.make_gesture(duration_s, { .is_optional = true }).go_to(0.0, 0.15).rest_until(gone_s + loss.gap_s);
	hand.plan().hide(gone_s, hand.now_s());
	hand.rest(1.5).add_plain_gesture();
}

inline void come_back_at_the_end(Performance &hand, Draws &draws) {
	const Loss loss = draw_loss(draws);
	const double duration_s = hand.movement().duration_s;
	const double gone_s = hand.now_s() + time_of_part_s(loss.part, duration_s);
	const bool is_optional = loss.is_long() || (!hand.has_task() && loss.part < 0.72);
	hand.make_gesture(duration_s, { is_optional, loss.gap_s + 1.0 }).rest_until(gone_s + loss.gap_s);
	hand.plan().hide(gone_s, gone_s + loss.gap_s);
	hand.add_plain_gesture(0.6, true);
}

} // namespace steadyhand::bench
