#pragma once

#include <godot_cpp/core/defs.hpp>

namespace godot {

struct Quaternion {
	real_t x = 0;
	real_t y = 0;
	real_t z = 0;
	real_t w = 1;

	constexpr Quaternion() = default;
	constexpr Quaternion(real_t p_x, real_t p_y, real_t p_z, real_t p_w) : x(p_x), y(p_y), z(p_z), w(p_w) {}

	constexpr bool operator==(const Quaternion &p_q) const {
		return x == p_q.x && y == p_q.y && z == p_q.z && w == p_q.w;
	}
	constexpr bool operator!=(const Quaternion &p_q) const { return !(*this == p_q); }
};

} // namespace godot
