#pragma once

#include <godot_cpp/variant/packed_float64_array.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <span>
#include <string>
#include <string_view>

namespace godot {

// Conversions between the engine's types and the core's. Vector3 is single precision in Godot's usual builds.

inline String to_godot(std::string_view p_text) {
	return String::utf8(p_text.data(), static_cast<int64_t>(p_text.size()));
}

inline Vector3 to_godot(const Eigen::Vector3d &p_vector) {
	return Vector3(static_cast<real_t>(p_vector.x()), static_cast<real_t>(p_vector.y()),
			static_cast<real_t>(p_vector.z()));
}

inline PackedFloat64Array to_godot(std::span<const double> p_numbers) {
	PackedFloat64Array array;
	array.resize(static_cast<int64_t>(p_numbers.size()));
	std::copy(p_numbers.begin(), p_numbers.end(), array.ptrw());
	return array;
}

inline PackedFloat64Array to_godot(const Eigen::VectorXd &p_numbers) {
	return to_godot(std::span(p_numbers.data(), static_cast<std::size_t>(p_numbers.size())));
}

/// UTF-8.
inline std::string to_core(const String &p_text) {
	const CharString utf8 = p_text.utf8();
	return std::string(utf8.get_data(), static_cast<std::size_t>(utf8.length()));
}

inline Eigen::Vector3d to_core(const Vector3 &p_vector) {
	return { static_cast<double>(p_vector.x), static_cast<double>(p_vector.y),
		static_cast<double>(p_vector.z) };
}

/// Whether the value is in an enum with the values 0..p_last. Scripts can pass any number.
template <class Enum> constexpr bool is_enumerator(Enum p_value, Enum p_last) {
	const auto number = static_cast<int64_t>(p_value);
	return number >= 0 && number <= static_cast<int64_t>(p_last);
}

/// Valid until the array changes.
inline std::span<const double> to_core(const PackedFloat64Array &p_numbers) {
	return { p_numbers.ptr(), static_cast<std::size_t>(p_numbers.size()) };
}

} // namespace godot
