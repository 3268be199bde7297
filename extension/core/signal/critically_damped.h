#pragma once

#include <cmath>

namespace steadyhand {

/// Critically damped decay to 0, x'' = -2 a x' - a^2 x, with its derivatives.
struct CriticallyDamped {
	double value, velocity, acceleration;
};

/// State dt_s after a state with this value and velocity. fading: exp(-rate_per_s * dt_s).
[[nodiscard]] inline CriticallyDamped critically_damped(
		double value, double velocity, double rate_per_s, double dt_s, double fading) {
	const double c = velocity + rate_per_s * value;
	const double left = value + c * dt_s;
	return { left * fading, (c - rate_per_s * left) * fading,
		rate_per_s * (rate_per_s * left - 2.0 * c) * fading };
}

/// State dt_s >= 0 after a state with this value and velocity: (x + c dt) exp(-a dt), c = v + a x.
[[nodiscard]] inline CriticallyDamped critically_damped(
		double value, double velocity, double rate_per_s, double dt_s) {
	return critically_damped(value, velocity, rate_per_s, dt_s, std::exp(-rate_per_s * dt_s));
}

} // namespace steadyhand
