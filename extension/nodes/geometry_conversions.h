#pragma once

#include "conversions.h"

#include <godot_cpp/variant/transform3d.hpp>

#include <Eigen/Geometry>

namespace godot {

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

inline Eigen::Affine3d to_core(const Transform3D &p_transform) {
	Eigen::Affine3d transform = Eigen::Affine3d::Identity();
	transform.linear() = to_core(p_transform.basis);
	transform.translation() = to_core(p_transform.origin);
	return transform;
}

} // namespace godot
