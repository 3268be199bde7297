#pragma once

#include "base/random.h"
#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace steadyhand::test {

/// A hand that moves to and fro between two positions, with minimum-jerk movements (Flash & Hogan 1985) and
/// rests between them, and a tracker with a constant rate, white noise and rounding.
struct MovingHand {
	double amplitude_m = 0.2;
	double duration_s = 0.6; ///< of one way
	double rest_s = 0.2;
	double rate_hz = 100.0;
	double noise_m = 0.0;
	double rounding_m = 0.0; ///< 0: none

	[[nodiscard]] Eigen::Vector3d at(double t_s) const {
		const double round_s = 2.0 * (duration_s + rest_s);
		const double s = t_s - round_s * std::floor(t_s / round_s);
		const auto way = [this](double since_s) {
			const double p = std::clamp(since_s / duration_s, 0.0, 1.0);
			return p * p * p * (10.0 - 15.0 * p + 6.0 * p * p);
		};
		const double x = amplitude_m * (way(s - rest_s) - way(s - duration_s - 2.0 * rest_s));
		return { 0.1 + 0.8 * x, -0.2 + 0.6 * x, -0.3 };
	}
	[[nodiscard]] Eigen::Vector3d seen(double t_s, Random &r_random) const {
		Eigen::Vector3d place_m = at(t_s);
		for (double &along : place_m) {
			along += noise_m > 0.0 ? noise_m * r_random.normal() : 0.0;
			along = rounding_m > 0.0 ? rounding_m * std::round(along / rounding_m) : along;
		}
		return place_m;
	}
};

} // namespace steadyhand::test
