#pragma once

#include <godot_cpp/variant/vector3.hpp>

namespace godot {

// A 3 x 3 matrix, stored by rows as in the engine. Its columns are the images of the axes.
struct Basis {
	Vector3 rows[3] = { Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1) };

	constexpr Basis() = default;
	constexpr Basis(const Vector3 &p_x_axis, const Vector3 &p_y_axis, const Vector3 &p_z_axis) :
			rows{ Vector3(p_x_axis.x, p_y_axis.x, p_z_axis.x), Vector3(p_x_axis.y, p_y_axis.y, p_z_axis.y),
				Vector3(p_x_axis.z, p_y_axis.z, p_z_axis.z) } {}

	constexpr Vector3 get_column(int p_index) const {
		return Vector3(rows[0][p_index], rows[1][p_index], rows[2][p_index]);
	}
	constexpr Vector3 xform(const Vector3 &p_v) const {
		return Vector3(rows[0].dot(p_v), rows[1].dot(p_v), rows[2].dot(p_v));
	}
	// By the transpose: the inverse for a pure rotation.
	constexpr Vector3 xform_inv(const Vector3 &p_v) const {
		return rows[0] * p_v.x + rows[1] * p_v.y + rows[2] * p_v.z;
	}
	constexpr real_t determinant() const { return rows[0].dot(rows[1].cross(rows[2])); }
	// By the adjugate; the determinant must not be zero.
	constexpr Basis inverse() const {
		const real_t scale = 1 / determinant();
		return Basis(rows[1].cross(rows[2]) * scale, rows[2].cross(rows[0]) * scale,
				rows[0].cross(rows[1]) * scale);
	}
	constexpr Basis operator*(const Basis &p_b) const {
		return Basis(xform(p_b.get_column(0)), xform(p_b.get_column(1)), xform(p_b.get_column(2)));
	}
	constexpr bool operator==(const Basis &p_b) const {
		return rows[0] == p_b.rows[0] && rows[1] == p_b.rows[1] && rows[2] == p_b.rows[2];
	}
	constexpr bool operator!=(const Basis &p_b) const { return !(*this == p_b); }
};

} // namespace godot
