#pragma once

#include "tracking/frame.h"

#include <Eigen/Core>

namespace steadyhand {

/// A right hand of average size that points along -z, its index tip at the origin, times `scale`.
[[nodiscard]] HandFrame pointing_hand(double scale);

/// A right hand that faces -z with thumb, index and middle tips on a circle of `radius_m` about the origin in
/// the xy plane (their z differ), the rest of the hand times `scale`.
[[nodiscard]] HandFrame pinching_hand(double scale, double radius_m);

/// Moves all tracked joints.
void shift_hand(HandFrame &r_frame, const Eigen::Vector3d &shift_m);

} // namespace steadyhand
