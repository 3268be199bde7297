#pragma once

#include <godot_cpp/variant/basis.hpp>

namespace godot {

struct Transform3D {
	Basis basis;
	Vector3 origin;

	constexpr Transform3D() = default;
	constexpr Transform3D(const Basis &p_basis, const Vector3 &p_origin = Vector3()) :
			basis(p_basis), origin(p_origin) {}

	constexpr Vector3 xform(const Vector3 &p_v) const { return basis.xform(p_v) + origin; }
	constexpr Transform3D affine_inverse() const {
		const Basis inverted = basis.inverse();
		return Transform3D(inverted, -inverted.xform(origin));
	}
	constexpr Transform3D operator*(const Transform3D &p_t) const {
		return Transform3D(basis * p_t.basis, xform(p_t.origin));
	}
	constexpr bool operator==(const Transform3D &p_t) const {
		return basis == p_t.basis && origin == p_t.origin;
	}
	constexpr bool operator!=(const Transform3D &p_t) const { return !(*this == p_t); }
};

} // namespace godot
