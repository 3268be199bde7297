#pragma once

#include "simulation/true_motion.h"
#include "tracking/trial_set.h"

#include <span>
#include <string_view>

namespace steadyhand {

/// Displacement of a hand, m, as a function of time.
using HandDisplacement = std::function<Eigen::Vector3d(double t_s)>;

/// One kind of motion that is no gesture. A new one is a row of the table in other_motion.cpp.
struct OtherMotion {
	std::string_view name;
	/// Displacement of the hand from 0 to span_s.
	HandDisplacement (*make)(double span_s, Random &r_random);
	double fingers_m = 0.0; ///< standard deviation of the fingertips relative to the hand; 0: a stiff hand
};

/// idle, fidgeting (only the fingers move), reaching (aimed, at least 30 degrees from the axis of every
/// trained gesture), typing, circling, wandering.
[[nodiscard]] std::span<const OtherMotion> other_motions();
/// Null if no motion has this name.
[[nodiscard]] const OtherMotion *find_other_motion(std::string_view name);

/// span_s seconds of other motion; 0: a random time of 4 to 8 s. start_s and end_s are half a second from the
/// ends.
[[nodiscard]] TrueMotion make_other_motion(const OtherMotion &kind, HandPosition position,
		const Subject &subject, double span_s, Random &r_random);

} // namespace steadyhand
