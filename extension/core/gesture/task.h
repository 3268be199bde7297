#pragma once

#include <Eigen/Core>

namespace steadyhand {

/// Less is no hand's motion, and a model over it no file that can be read.
inline constexpr double SMALLEST_AMPLITUDE_M = 1e-6;

/// Share of the amplitude at which a gesture has come to its end (docs/method.md).
inline constexpr double END_LEVEL = 0.95;

/// What the scene knows of the gesture it waits for; the frame in which features are measured.
struct Task {
	/// Where the motion starts, m. For a radius: x is the starting radius, y and z are unused.
	Eigen::Vector3d start_m = Eigen::Vector3d::Zero();
	/// Unit vector of the motion; unused by a radius.
	Eigen::Vector3d axis = Eigen::Vector3d::UnitX();
	/// Length of the whole motion (radius: its growth), m, > 0.
	double amplitude_m = 0.2;

	bool operator==(const Task &) const = default;
};

} // namespace steadyhand
