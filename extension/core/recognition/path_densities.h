#pragma once

#include "base/parameters.h"

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

/// Log of the density of bows, exp(-(bow / width)^4), relative to a uniform one up to LARGEST_BOW. bow:
/// distance of the path from its chord, in lengths of the chord. At least that of a uniform density at 0.
[[nodiscard]] inline double log_bow_ratio(double bow, double width) {
	constexpr double GAMMA_FIVE_QUARTERS = 0.9064024770554771; // gamma(5/4)
	const double square = bow * bow / (width * width);
	return std::max(std::log(parameters::sessions::LARGEST_BOW / (width * GAMMA_FIVE_QUARTERS)), 0.0) -
			square * square;
}

} // namespace steadyhand
