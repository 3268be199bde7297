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
	hand.make_gesture(4.0).end_plainly();
}

inline void move_quickly(Performance &hand, Draws & /*draws*/) {
	hand.make_gesture(0.15).end_plainly();
}

inline void move_as_far_as_may_be(Performance &hand, Draws &draws) {
	PlannedMovement movement = hand.movement();
	if (hand.is_open()) {
		movement = hand.typical(movement);
		movement.amplitude_m *= draws.between(0.75, 2.2);
	} else {
		movement.amplitude_m = std::exp(draws.between(std::log(0.05), std::log(0.6)));
		movement.duration_s = draws.between(0.5, 1.0) * (0.5 + std::sqrt(movement.amplitude_m));
	}
	hand.begin(movement).make_gesture(movement.duration_s).end_plainly();
}

inline void move_obliquely(Performance &hand, Draws &draws) {
	const double degrees = hand.is_open() ? draws.between(0.0, 18.0) : draws.between(20.0, 180.0);
	hand.begin(tilted(hand.movement(), degrees, draws));
	hand.make_gesture(hand.movement().duration_s).end_plainly();
}

inline void come_from_elsewhere(Performance &hand, Draws &draws) {
	const Eigen::Vector3d axis = hand.movement().axis();
	HandPose elsewhere = hand.start();
	elsewhere.head<3>() += 0.3 * draw_aside(axis, axis, draws);
	hand.begin_at(elsewhere).aim(hand.movement(), hand.start()).rest(1.0).go_to(0.0, 0.8);
	hand.rest(draws.between(0.4, 0.8)).make_gesture(hand.movement().duration_s).end_plainly();
}

inline constexpr std::array GESTURING_HANDS{
	HandKind{ "ten taps in a row", TAPS, tap_ten_times },
	HandKind{ "zooms in three to five strokes", ZOOMS, zoom_in_strokes },
	HandKind{ "four drags, hardly a rest between them", DRAGS, drag_without_rest },
	HandKind{ "four drags and the ways back, 1.6 s apart", DRAGS, drag_there_and_back },
	HandKind{ "three drags on and on, 1.3 to 2.5 s apart", DRAGS, drag_on },
	HandKind{ "twelve equal gestures in a row", ALL, make_twelve },
	HandKind{ "five different ones in a row", ALL, make_five_different },
	HandKind{ "two tasks apart, in turns", BUT_ZOOMS, take_turns },
	HandKind{ "hesitates for 0.2 to 0.9 s", ALL, hesitate },
	HandKind{ "halts for 1 to 10 s and goes on", ALL, halt_and_go_on },
	HandKind{ "halts for 1 to 10 s and goes back", ALL, halt_and_go_back },
	HandKind{ "goes 5 to 35 % too far, and back", ALL, overshoot },
	HandKind{ "stops 5 to 28 % short of the end", ALL, stop_short },
	HandKind{ "turns at 20 to 55 % of the way", ALL, turn_half_way },
	HandKind{ "turns at once at the end", ALL, turn_at_the_end },
	HandKind{ "goes back by 10 to 25 %, and on", ALL, go_back_and_on },
	HandKind{ "leaves the view half-way, goes on from there", ALL, wait_out_of_view },
	HandKind{ "leaves the view half-way, is back at the start", ALL, come_back_at_the_start },
	HandKind{ "leaves the view half-way, is back at the end", ALL, come_back_at_the_end },
	HandKind{ "gestures of 4 s", ALL, move_slowly },
	HandKind{ "gestures of 0.15 s", ALL, move_quickly },
	HandKind{ "gestures of 5 to 60 cm", BUT_ZOOMS, move_as_far_as_may_be },
	HandKind{ "gestures askew", BUT_ZOOMS, move_obliquely },
	HandKind{ "comes from elsewhere, rests for 0.4 to 0.8 s", BUT_ZOOMS, come_from_elsewhere },
};

} // namespace steadyhand::bench
