#pragma once

#include <algorithm>
#include <cmath>

namespace steadyhand {

/// Log of the density of directions near an axis, relative to the uniform density on the sphere. The density
/// is almost constant within `width` of the axis and falls off as exp(-(off / width)^6). off: distance of the
/// two unit vectors, 0..2; a circle of this radius on the sphere has the area pi off^2. About 0 for widths
/// far beyond 2.
[[nodiscard]] inline double log_direction_ratio(double off, double width) {
	constexpr double GAMMA_THIRD = 2.6789385347077476; // gamma(1/3)
	const double cube = off * off * off / (width * width * width);
	return std::max(std::log(12.0 / (width * width * GAMMA_THIRD)), 0.0) - cube * cube;
}

} // namespace steadyhand
