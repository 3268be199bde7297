#pragma once

#include "signal/polynomial.h"

#include <algorithm>

namespace steadyhand {

/// Way covered at the share `s` of a movement's duration, and its derivatives with respect to s:
/// 10 s^3 - 15 s^4 + 6 s^5 (Flash and Hogan 1985, doi 10.1523/JNEUROSCI.05-07-01688.1985); at rest at 0
/// before it and at 1 after.
[[nodiscard]] inline Polynomial::Point minimum_jerk(double s) {
	s = std::clamp(s, 0.0, 1.0);
	const double left = 1.0 - s;
	return { s * s * s * (10.0 + s * (-15.0 + 6.0 * s)), 30.0 * s * s * left * left,
		60.0 * s * left * (1.0 - 2.0 * s) };
}

/// The share of the duration after which that much of the way is covered, by Newton's method, within 1e-5 of
/// the way; held to 0.05..0.9 of it.
[[nodiscard]] inline double minimum_jerk_share(double way) {
	way = std::clamp(way, 0.05, 0.9);
	double s = 0.5;
	for (int step = 0; step < 4; ++step) {
		const Polynomial::Point there = minimum_jerk(s);
		s = std::clamp(s + (way - there.value) / there.first, 0.05, 0.95);
	}
	return s;
}

} // namespace steadyhand
