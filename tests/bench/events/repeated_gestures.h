#pragma once

#include "draws.h"
#include "hand_plan.h"
#include "movements.h"
#include "performance.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>

namespace steadyhand::bench {

// Hands that repeat gestures.

inline Performance &make_strokes(Performance &hand, std::size_t count, double out_s, double end_rest_s,
		double back_s, double start_rest_s, const Leeway &leeway = {}) {
	for (std::size_t i = 0; i < count; ++i) {
		hand.make_gesture(out_s, leeway).rest(end_rest_s).go_to(0.0, back_s).rest(start_rest_s);
	}
	return hand;
}

inline void tap_ten_times(Performance &hand, Draws &draws) {
	const double taps_per_s = draws.between(1.0, 3.0);
	const double out_s = std::min(0.3, draws.between(0.3, 0.45) / taps_per_s);
	const double back_s = std::min(0.4, draws.between(0.35, 0.45) / taps_per_s);
	const double rest_s = 1.0 / taps_per_s - out_s - back_s;
	const double end_rest_s = rest_s * draws.between(0.0, 0.6);
	make_strokes(hand, 10, out_s, end_rest_s, back_s, rest_s - end_rest_s, { .late_s = 0.3 }).rest(1.2);
}

inline void zoom_in_strokes(Performance &hand, Draws &draws) {
	const std::size_t count = 3 + draws.below(3);
	const double end_rest_s = draws.between(0.0, 0.5), start_rest_s = draws.between(0.0, 0.6);
	const double out_s = draws.between(0.4, 0.7), back_s = draws.between(0.8, 1.3);
	make_strokes(hand, count, out_s, end_rest_s, back_s, start_rest_s).rest(1.2);
}

inline void drag_without_rest(Performance &hand, Draws &draws) {
	const double end_rest_s = draws.between(0.0, 0.3), start_rest_s = draws.between(0.0, 0.3);
	const double out_s = draws.between(0.5, 1.0), back_s = draws.between(0.5, 1.0);
	make_strokes(hand, 4, out_s, end_rest_s, back_s, start_rest_s).rest(1.2);
}

inline void drag_there_and_back(Performance &hand, Draws &draws) {
	const double out_s = draws.between(0.5, 1.0), back_s = draws.between(0.5, 1.0);
	for (int i = 0; i < 4; ++i) {
		hand.make_gesture(out_s).rest(1.6).begin_gesture().go_to(0.0, back_s);
		if (!hand.has_task()) {
			hand.end_gesture();
		}
		hand.rest(1.6);
	}
}

inline void drag_on(Performance &hand, Draws &draws) {
	const PlannedMovement movement = hand.movement();
	const HandPose way = movement.amplitude_m * movement.direction;
	const double out_s = draws.between(0.5, 1.0);
	for (int i = 0; i < 3; ++i) {
		const HandPose end = hand.make_gesture(out_s).rest(draws.between(1.3, 2.5)).start() + way;
		hand.aim(movement, end);
	}
}

inline void make_twelve(Performance &hand, Draws & /*draws*/) {
	const double duration_s = hand.movement().duration_s;
	make_strokes(hand, 12, duration_s, 0.5, duration_s, 1.4);
}

inline void make_five_different(Performance &hand, Draws &draws) {
	HandPose home = hand.start();
	home(3) = 0.016;
	hand.begin_at(home).rest(1.3);
	for (int i = 0; i < 5; ++i) {
		const PlannedMovement drawn = draw_movement(ALL.draw(draws), Context::WITHOUT_TASK, draws);
		const PlannedMovement movement = hand.has_task() ? hand.typical(drawn) : drawn;
		hand.aim(movement, home).make_gesture(movement.duration_s).rest(draws.between(0.3, 0.6));
		hand.go_to(0.0, 1.1 * movement.duration_s).rest(1.5);
	}
}

inline void take_turns(Performance &hand, Draws &draws) {
	const std::array movements{ hand.movement(), hand.draw(BUT_ZOOMS.draw(draws)) };
	std::array starts{ hand.start(), hand.start() };
	const Eigen::Vector3d aside = draw_aside(movements[0].axis(), movements[1].axis(), draws);
	starts[1].head<3>() += draws.between(0.25, 0.5) * aside;
	hand.begin_at(starts[0]).rest(1.2);
	for (std::size_t i = 0; i < 6; ++i) {
		const double duration_s = movements[i % 2].duration_s;
		hand.aim(movements[i % 2], starts[i % 2]);
		if (i > 0) {
			hand.go_to(0.0, draws.between(0.6, 1.2));
		}
		hand.rest(draws.between(0.8, 1.5)).make_gesture(duration_s).rest(draws.between(0.3, 0.6));
		if (i % 3 == 2) {
			hand.go_to(0.0, duration_s).rest(0.8);
		}
	}
}

} // namespace steadyhand::bench
