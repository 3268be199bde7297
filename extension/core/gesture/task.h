#pragma once

#include <Eigen/Core>

namespace steadyhand {

/// Least amplitude of a task and of a model file.
inline constexpr double SMALLEST_AMPLITUDE_M = 1e-6;

/// Fraction of the amplitude at which a gesture ends (docs/method.md).
inline constexpr double END_LEVEL = 0.95;

/// Start, direction and amplitude of an expected gesture, given by the scene. Features are relative to it.
struct Task {
	/// Start of the motion, m. For a radius: x is the radius at the start; y and z are unused.
	Eigen::Vector3d start_m = Eigen::Vector3d::Zero();
	/// Unit vector of the motion; unused for a radius.
	Eigen::Vector3d axis = Eigen::Vector3d::UnitX();
	/// Length of the motion, or growth of the radius, m, > 0.
	double amplitude_m = 0.2;

	bool operator==(const Task &) const = default;
};

} // namespace steadyhand
