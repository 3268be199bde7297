#pragma once

#include <godot_cpp/core/defs.hpp>

#include <cmath>

namespace godot {

struct Vector2 {
	real_t x = 0;
	real_t y = 0;

	constexpr Vector2() = default;
	constexpr Vector2(real_t p_x, real_t p_y) : x(p_x), y(p_y) {}

	real_t &operator[](int p_axis) { return p_axis == 0 ? x : y; }
	constexpr const real_t &operator[](int p_axis) const { return p_axis == 0 ? x : y; }

	constexpr Vector2 operator+(const Vector2 &p_v) const { return Vector2(x + p_v.x, y + p_v.y); }
	constexpr Vector2 operator-(const Vector2 &p_v) const { return Vector2(x - p_v.x, y - p_v.y); }
	constexpr Vector2 operator*(real_t p_scale) const { return Vector2(x * p_scale, y * p_scale); }
	constexpr bool operator==(const Vector2 &p_v) const { return x == p_v.x && y == p_v.y; }
	constexpr bool operator!=(const Vector2 &p_v) const { return !(*this == p_v); }

	real_t length() const { return std::sqrt(x * x + y * y); }
	bool is_finite() const { return std::isfinite(x) && std::isfinite(y); }
};

} // namespace godot
