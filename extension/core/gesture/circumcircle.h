#pragma once

#include <Eigen/Core>

#include <optional>

namespace steadyhand {

/// Radius of the circle through three points of a plane: R = a b c / (4 K), the sides over the area. Nothing
/// where the points say too little of it.
///
/// Where errors e_i of the points point away from the centre, the radius errs by sum w_i e_i, w being the
/// centre's barycentric coordinates (from |p_i - o| = R by differentiation; sum w_i = 1):
///
///     w_a = a^2 (b^2 + c^2 - a^2) / (16 K^2), and so on
///
/// |w| is 1 / sqrt 3 for an equilateral triangle and grows without bound as the points come into one line or
/// two of them to one place, where no circle or no single one goes through them. Beyond ERROR_GAIN_MAX there
/// is no value: a frame that does not tell is better left to what is known of the gesture than answered with
/// a number that is all error. What comes out is finite for every finite input, and scales with it.
std::optional<double> circumradius(
		const Eigen::Vector2d &p, const Eigen::Vector2d &q, const Eigen::Vector2d &r);

/// 1 mm at the fingertips is then 1 cm of radius: a third of the whole zoom.
inline constexpr double ERROR_GAIN_MAX = 10.0;

} // namespace steadyhand
