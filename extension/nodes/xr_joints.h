#pragma once

#include "conversions.h"

#include "tracking/hand_skeleton.h"

#include <godot_cpp/variant/transform3d.hpp>

#include <Eigen/Geometry>

namespace godot {

/// Godot turns each joint of OpenXR into the bones of its humanoid skeleton: -y along the bone in place of
/// -z.
inline Eigen::Quaterniond humanoid_turn() {
	constexpr double HALF_ROOT = 0.70710678118654752;
	return { 0.0, 0.0, -HALF_ROOT, HALF_ROOT };
}

inline Basis to_godot(const Eigen::Matrix3d &p_matrix) {
	return Basis(to_godot(Eigen::Vector3d(p_matrix.col(0))), to_godot(Eigen::Vector3d(p_matrix.col(1))),
			to_godot(Eigen::Vector3d(p_matrix.col(2))));
}

inline Eigen::Matrix3d to_core(const Basis &p_basis) {
	Eigen::Matrix3d matrix;
	for (int axis = 0; axis < 3; ++axis) {
		matrix.col(axis) = to_core(p_basis.get_column(axis));
	}
	return matrix;
}

} // namespace godot
