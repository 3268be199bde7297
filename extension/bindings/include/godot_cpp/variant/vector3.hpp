#pragma once

#include <godot_cpp/core/defs.hpp>

#include <cmath>

namespace godot {

struct Vector3 {
	real_t x = 0;
	real_t y = 0;
	real_t z = 0;

	constexpr Vector3() = default;
	constexpr Vector3(real_t p_x, real_t p_y, real_t p_z) : x(p_x), y(p_y), z(p_z) {}

	real_t &operator[](int p_axis) { return p_axis == 0 ? x : (p_axis == 1 ? y : z); }
	constexpr const real_t &operator[](int p_axis) const { return p_axis == 0 ? x : (p_axis == 1 ? y : z); }

	constexpr Vector3 operator+(const Vector3 &p_v) const { return Vector3(x + p_v.x, y + p_v.y, z + p_v.z); }
	constexpr Vector3 operator-(const Vector3 &p_v) const { return Vector3(x - p_v.x, y - p_v.y, z - p_v.z); }
	constexpr Vector3 operator-() const { return Vector3(-x, -y, -z); }
	constexpr Vector3 operator*(real_t p_scale) const {
		return Vector3(x * p_scale, y * p_scale, z * p_scale);
	}
	constexpr Vector3 operator/(real_t p_scale) const {
		return Vector3(x / p_scale, y / p_scale, z / p_scale);
	}
	constexpr Vector3 &operator+=(const Vector3 &p_v) { return *this = *this + p_v; }
	constexpr Vector3 &operator-=(const Vector3 &p_v) { return *this = *this - p_v; }
	constexpr Vector3 &operator*=(real_t p_scale) { return *this = *this * p_scale; }
	constexpr Vector3 &operator/=(real_t p_scale) { return *this = *this / p_scale; }
	constexpr bool operator==(const Vector3 &p_v) const { return x == p_v.x && y == p_v.y && z == p_v.z; }
	constexpr bool operator!=(const Vector3 &p_v) const { return !(*this == p_v); }

	constexpr real_t dot(const Vector3 &p_v) const { return x * p_v.x + y * p_v.y + z * p_v.z; }
	constexpr Vector3 cross(const Vector3 &p_v) const {
		return Vector3(y * p_v.z - z * p_v.y, z * p_v.x - x * p_v.z, x * p_v.y - y * p_v.x);
	}
	constexpr real_t length_squared() const { return dot(*this); }
	real_t length() const { return std::sqrt(length_squared()); }
	real_t distance_to(const Vector3 &p_v) const { return (p_v - *this).length(); }
	// Zero for the zero vector, as in Godot.
	Vector3 normalized() const { return length_squared() == 0 ? Vector3() : *this / length(); }
	constexpr Vector3 lerp(const Vector3 &p_to, real_t p_weight) const {
		return *this + (p_to - *this) * p_weight;
	}
	bool is_finite() const { return std::isfinite(x) && std::isfinite(y) && std::isfinite(z); }
};

constexpr Vector3 operator*(real_t p_scale, const Vector3 &p_v) {
	return p_v * p_scale;
}

} // namespace godot
