#pragma once

namespace godot {

// Single precision in every build of the engine.
struct Color {
	float r = 0;
	float g = 0;
	float b = 0;
	float a = 1;

	constexpr Color() = default;
	constexpr Color(float p_r, float p_g, float p_b, float p_a = 1) : r(p_r), g(p_g), b(p_b), a(p_a) {}

	constexpr bool operator==(const Color &p_c) const {
		return r == p_c.r && g == p_c.g && b == p_c.b && a == p_c.a;
	}
	constexpr bool operator!=(const Color &p_c) const { return !(*this == p_c); }
};

} // namespace godot
