#pragma once

#include "signal/polynomial.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {

/// Fraction of a movement's length at the fraction `s` of its duration, and its derivatives with respect to
/// s: 10 s^3 - 15 s^4 + 6 s^5 (Flash and Hogan 1985, doi 10.1523/JNEUROSCI.05-07-01688.1985). 0 before the
/// movement, 1 after it.
[[nodiscard]] inline Polynomial::Point minimum_jerk(double s) {
	s = std::clamp(s, 0.0, 1.0);
	const double left = 1.0 - s;
	return { s * s * s * (10.0 + s * (-15.0 + 6.0 * s)), 30.0 * s * s * left * left,
		60.0 * s * left * (1.0 - 2.0 * s) };
}

/// Inverse of minimum_jerk(): fraction of the duration at a fraction of the length, which is clamped to 0..1.
/// By Newton's method, within 1e-8.
[[nodiscard]] inline double minimum_jerk_share(double length) {
	const double lesser = std::clamp(std::min(length, 1.0 - length), 0.0, 0.5); // the curve is symmetric
	double s = std::cbrt(0.1 * lesser);
	for (int step = 0; step < 3 && s > 0.0; ++step) {
		const Polynomial::Point there = minimum_jerk(s);
		s += (lesser - there.value) / there.first;
	}
	return length < 0.5 ? s : 1.0 - s;
}

} // namespace steadyhand
