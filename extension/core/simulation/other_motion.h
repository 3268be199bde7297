#pragma once

#include "simulation/true_motion.h"
#include "tracking/trial_set.h"

#include <span>
#include <string_view>

namespace steadyhand {

/// How a hand's place moves when it makes none of the gestures.
using HandWay = std::function<Eigen::Vector3d(double t_s)>;

/// One kind of motion that is no gesture. A new one is a new row.
struct OtherMotion {
	std::string_view name;
	/// Displacement of the hand over 0 .. span_s.
	HandWay (*make)(double span_s, Random &r_random);
	double fingers_m = 0.0; ///< standard deviation of fingertips by themselves, in a hand that is loose
};

/// idle, fidgeting (fingers alone), reaching (aimed, but at least 30 degrees off every axis that a trained
/// gesture runs along), typing, circling, wandering.
[[nodiscard]] std::span<const OtherMotion> other_motions();
/// Null where there is none of that name.
[[nodiscard]] const OtherMotion *find_other_motion(std::string_view name);

/// `span_s` seconds of it; 0 leaves that to chance, 4 to 8 s. start_s .. end_s leaves out half a second at
/// either end.
[[nodiscard]] TrueMotion make_other_motion(const OtherMotion &kind, HandPosition position,
		const Subject &subject, double span_s, Random &r_random);

} // namespace steadyhand
