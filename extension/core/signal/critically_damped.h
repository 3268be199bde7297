#pragma once

#include <cmath>

namespace steadyhand {

/// A number that comes back to zero critically damped, x'' = -2 a x' - a^2 x, with its derivatives.
struct CriticallyDamped {
	double value, velocity, acceleration;
};

/// A time of dt_s after it had this value and this velocity; fading: exp(-rate_per_s * dt_s).
[[nodiscard]] inline CriticallyDamped critically_damped(
		double value, double velocity, double rate_per_s, double dt_s, double fading) {
	const double c = velocity + rate_per_s * value;
	const double left = value + c * dt_s;
	return { left * fading, (c - rate_per_s * left) * fading,
		rate_per_s * (rate_per_s * left - 2.0 * c) * fading };
}

/// A time of dt_s >= 0 after it had this value and this velocity: (x + c dt) exp(-a dt), c = v + a x.
[[nodiscard]] inline CriticallyDamped critically_damped(
		double value, double velocity, double rate_per_s, double dt_s) {
	return critically_damped(value, velocity, rate_per_s, dt_s, std::exp(-rate_per_s * dt_s));
}

} // namespace steadyhand
