#include "recognition/direction_prior.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace steadyhand {
namespace {

constexpr double STEP_RAD = 0.1;
constexpr double NO_WAY_M = 1e-6;

double radians(double degrees) {
	return degrees * std::numbers::pi / 180.0;
}

/// 1 within the cone.
double fall_off(double angle_rad, double cone_rad, double deviation_rad) {
	const double beyond = std::max(angle_rad - cone_rad, 0.0) / deviation_rad;
	return std::exp(-0.5 * beyond * beyond);
}

/// Mean of fall_off() over the sphere, by the midpoint rule.
double mean_over_sphere(double cone_rad, double deviation_rad) {
	constexpr int STEPS = 2000;
	double sum = 0.0;
	for (int i = 0; i < STEPS; ++i) {
		const double angle_rad = (i + 0.5) * std::numbers::pi / STEPS;
		sum += 0.5 * std::sin(angle_rad) * fall_off(angle_rad, cone_rad, deviation_rad);
	}
	return sum * std::numbers::pi / STEPS;
}

} // namespace

DirectionPrior::DirectionPrior(double cone_deg, double deviation_deg) :
		cone_rad_(radians(cone_deg)), deviation_rad_(radians(deviation_deg)) {
	for (std::size_t i = 0; i < WIDTHS; ++i) {
		at_axis_[i] = 1.0 / mean_over_sphere(cone_rad_, deviation_rad_ + STEP_RAD * static_cast<double>(i));
	}
}

double DirectionPrior::ratio(
		const Eigen::Vector3d &way_m, const Eigen::Vector3d &axis, double jitter_m) const {
	const double distance_m = way_m.norm();
	if (!(distance_m > NO_WAY_M)) {
		return 1.0;
	}
	const double angle_rad = std::acos(std::clamp(way_m.dot(axis) / distance_m, -1.0, 1.0));
	const double wider_rad = std::hypot(deviation_rad_, jitter_m / distance_m) - deviation_rad_;
	const auto step =
			static_cast<std::size_t>(std::clamp(wider_rad / STEP_RAD, 0.0, static_cast<double>(WIDTHS - 1)));
	return at_axis_[step] *
			fall_off(angle_rad, cone_rad_, deviation_rad_ + STEP_RAD * static_cast<double>(step));
}

} // namespace steadyhand
