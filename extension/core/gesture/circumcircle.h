#pragma once

#include <Eigen/Core>

#include <optional>

namespace steadyhand {

/// Radius of the circle through three points of a plane: R = a b c / (4 K). a, b, c: sides; K: area. nullopt
/// if errors of the points are amplified by more than ERROR_GAIN_MAX.
///
/// Radial errors e_i of the points change the radius by sum w_i e_i. w: barycentric coordinates of the centre
/// (from |p_i - o| = R by differentiation; sum w_i = 1):
///
///     w_a = a^2 (b^2 + c^2 - a^2) / (16 K^2), and so on
///
/// |w| is 1 / sqrt 3 for an equilateral triangle. It grows without bound if the points approach a line, or
/// two of them coincide. The result is finite for every finite input, and scales with it.
std::optional<double> circumradius(
		const Eigen::Vector2d &p, const Eigen::Vector2d &q, const Eigen::Vector2d &r);

/// Largest |w|: an error of 1 mm at the fingertips is then 1 cm of radius, a third of a whole zoom.
inline constexpr double ERROR_GAIN_MAX = 10.0;

} // namespace steadyhand
