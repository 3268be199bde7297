#pragma once

#include "tracking/frame.h"

#include <Eigen/Core>

namespace steadyhand {

/// A pointing right hand, of average size times `scale`. It points along -z; its index tip is at the origin.
[[nodiscard]] HandFrame pointing_hand(double scale);

/// A right hand that faces -z. Thumb, index and middle tips are on a circle of `radius_m` around the origin,
/// in the projection to the xy plane. The rest of the hand is of average size times `scale`.
[[nodiscard]] HandFrame pinching_hand(double scale, double radius_m);

/// Moves all tracked joints.
void shift_hand(HandFrame &r_frame, const Eigen::Vector3d &shift_m);

} // namespace steadyhand
