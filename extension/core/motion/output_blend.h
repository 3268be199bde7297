#pragma once

#include <algorithm>
#include <cmath>

namespace steadyhand {

/// Hides a step of an output and of its velocity: what is missing fades out critically damped.
class OutputBlend {
public:
	/// At t_s the output would step by -value, its velocity by -velocity. rate: 1/s, of the fading.
	void start(double t_s, double value, double velocity, double rate_per_s) {
		began_s_ = t_s;
		value_ = value;
		rate_per_s_ = rate_per_s;
		// (v + c s) exp(-k s), c = v' + k v
		growth_ = velocity + rate_per_s * value;
	}

	/// What is to be added at t_s.
	struct Point {
		double value, velocity, acceleration;
	};
	[[nodiscard]] Point at(double t_s) const {
		const double s = std::max(t_s - began_s_, 0.0);
		const double fading = std::exp(-rate_per_s_ * s);
		const double left = value_ + growth_ * s;
		return { left * fading, (growth_ - rate_per_s_ * left) * fading,
			rate_per_s_ * (rate_per_s_ * left - 2.0 * growth_) * fading };
	}

private:
	double began_s_ = 0.0;
	double value_ = 0.0;
	double growth_ = 0.0;
	double rate_per_s_ = 1.0;
};

} // namespace steadyhand
