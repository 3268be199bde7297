#pragma once

#include <algorithm>
#include <cmath>

namespace steadyhand {

/// log of the density over the sphere of directions near an axis, against the even one: almost constant
/// within `width` of the axis, then falling off, exp(-(off / width)^6). off: distance of the two unit
/// vectors, 0..2, in which areas of the sphere are those of the plane. 0 for a width of the whole sphere.
[[nodiscard]] inline double log_direction_ratio(double off, double width) {
	constexpr double GAMMA_THIRD = 2.6789385347077476; // gamma(1/3)
	const double cube = off * off * off / (width * width * width);
	return std::max(std::log(12.0 / (width * width * GAMMA_THIRD)), 0.0) - cube * cube;
}

} // namespace steadyhand
