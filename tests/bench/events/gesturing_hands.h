#pragma once

#include "draws.h"
#include "hand_plan.h"
#include "interrupted_gestures.h"
#include "movements.h"
#include "performance.h"
#include "repeated_gestures.h"

#include <Eigen/Core>

#include <array>
#include <cmath>

namespace steadyhand::bench {

inline void move_slowly(Performance &hand, Draws & /*draws*/) {
	hand.make_gesture(4.0).add_plain_gesture();
}

inline void move_quickly(Performance &hand, Draws & /*draws*/) {
	hand.make_gesture(0.15).add_plain_gesture();
}

inline void vary_amplitude(Performance &hand, Draws &draws) {
	PlannedMovement movement = hand.movement();
	if (!hand.has_task()) {
		movement = hand.typical(movement);
		movement.amplitude_m *= draws.between(0.75, 2.2);
	} else {
		movement.amplitude_m = std::exp(draws.between(std::log(0.05), std::log(0.6)));
		movement.duration_s = draws.between(0.5, 1.0) * (0.5 + std::sqrt(movement.amplitude_m));
	}
	hand.begin(movement).make_gesture(movement.duration_s).add_plain_gesture();
}

inline void tilt_direction(Performance &hand, Draws &draws) {
	const double degrees = hand.has_task() ? draws.between(20.0, 180.0) : draws.between(0.0, 18.0);
	hand.begin(tilted(hand.movement(), degrees, draws));
	hand.make_gesture(hand.movement().duration_s).add_plain_gesture();
}

inline void come_from_elsewhere(Performance &hand, Draws &draws) {
	const Eigen::Vector3d axis = hand.movement().axis();
	HandPose elsewhere = hand.start();
	elsewhere.head<3>() += 0.3 * draw_aside(axis, axis, draws);
	hand.begin_at(elsewhere).aim(hand.movement(), hand.start()).rest(1.0).go_to(0.0, 0.8);
	hand.rest(draws.between(0.4, 0.8)).make_gesture(hand.movement().duration_s).add_plain_gesture();
}

inline constexpr std::array GESTURING_HANDS{
	HandKind{ "ten taps in a row", TAPS, tap_ten_times },
	HandKind{ "zooms in three to five strokes", ZOOMS, zoom_in_strokes },
	HandKind{ "four drags with short rests", DRAGS, drag_without_rest },
	HandKind{ "four drags and returns, 1.6 s apart", DRAGS, drag_there_and_back },
	HandKind{ "three consecutive drags, 1.3 to 2.5 s apart", DRAGS, drag_on },
	HandKind{ "twelve equal gestures in a row", ALL, make_twelve },
	HandKind{ "five different gestures in a row", ALL, make_five_different },
	HandKind{ "two separate tasks in turns", BUT_ZOOMS, take_turns },
	HandKind{ "pauses for 0.2 to 0.9 s", ALL, hesitate },
	HandKind{ "pauses for 1 to 10 s and continues", ALL, halt_and_go_on },
	HandKind{ "pauses for 1 to 10 s and returns", ALL, halt_and_go_back },
	HandKind{ "overshoots by 5 to 35 %", ALL, overshoot },
	HandKind{ "stops 5 to 28 % short of the end", ALL, stop_short },
	HandKind{ "returns at 20 to 55 % of the amplitude", ALL, turn_half_way },
	HandKind{ "returns at the end without a dwell", ALL, turn_at_the_end },
	HandKind{ "turns back by 10 to 25 % and continues", ALL, go_back_and_on },
	HandKind{ "dropout in the gesture, continues after it", ALL, wait_out_of_view },
	HandKind{ "dropout in the gesture, back at the start", ALL, come_back_at_the_start },
	HandKind{ "dropout in the gesture, back at the end", ALL, come_back_at_the_end },
	HandKind{ "gestures of 4 s", ALL, move_slowly },
	HandKind{ "gestures of 0.15 s", ALL, move_quickly },
	HandKind{ "gestures of 5 to 60 cm", BUT_ZOOMS, vary_amplitude },
	HandKind{ "gestures in a tilted direction", BUT_ZOOMS, tilt_direction },
	HandKind{ "moves to the start, rests for 0.4 to 0.8 s", BUT_ZOOMS, come_from_elsewhere },
};

} // namespace steadyhand::bench
