#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>

namespace steadyhand {

/// Points of a hand in a track: five fingertips, the palm's centre, the wrist.
enum class Joint : std::uint8_t { THUMB, INDEX, MIDDLE, RING, PINKY, PALM, WRIST };

inline constexpr std::size_t JOINT_COUNT = 7;
/// Names in track CSV.
inline constexpr std::array<std::string_view, JOINT_COUNT> JOINT_NAMES = { "thumb", "index", "middle", "ring",
	"pinky", "palm", "wrist" };

/// Set of joints: bit i for joint i.
constexpr std::uint8_t joint_bits(std::initializer_list<Joint> joints) {
	unsigned bits = 0;
	for (const Joint joint : joints) {
		bits |= 1U << static_cast<unsigned>(joint);
	}
	return static_cast<std::uint8_t>(bits);
}

/// Limit of |coordinate|, m. Points beyond it are invalid.
inline constexpr double FARTHEST_M = 1e9;
/// Limit of |time|, s. A time beyond it has another unit, or is damaged. Beyond it rounding exceeds a
/// symbol's period, and the count of control instants in milliseconds overflows.
inline constexpr double FARTHEST_S = 1e12;

/// Whether a point is valid: finite, and no coordinate beyond FARTHEST_M.
[[nodiscard]] inline bool is_place(const Eigen::Vector3d &point_m) {
	return point_m.allFinite() && point_m.cwiseAbs().maxCoeff() <= FARTHEST_M;
}

/// One frame of a tracked hand. Positions are in metres, x right, y up, -z forward (Godot's axes). The time
/// is in seconds on the device's clock.
struct HandFrame {
	double t_s = 0.0;
	std::array<Eigen::Vector3d, JOINT_COUNT> positions_m{};
	std::uint8_t tracked = 0;  ///< bit i set: joint i is tracked, and positions_m[i] is valid
	std::uint8_t inferred = 0; ///< bit i set: joint i is tracked, but inferred by the tracker's hand model
	double confidence = 1.0;   ///< 0..1 by the device; 1 if it reports none

	[[nodiscard]] bool has(Joint joint) const { return (tracked >> static_cast<unsigned>(joint)) & 1U; }
	[[nodiscard]] bool has_all(std::uint8_t joints) const { return (tracked & joints) == joints; }
	[[nodiscard]] const Eigen::Vector3d &position(Joint joint) const {
		return positions_m[static_cast<std::size_t>(joint)];
	}
	void set(Joint joint, const Eigen::Vector3d &position_m) {
		positions_m[static_cast<std::size_t>(joint)] = position_m;
		tracked = static_cast<std::uint8_t>(tracked | (1U << static_cast<unsigned>(joint)));
	}
	/// Whether time and tracked joints have equal bits.
	[[nodiscard]] bool repeats(const HandFrame &other) const {
		bool is_same = t_s == other.t_s && tracked == other.tracked;
		for (std::size_t i = 0; is_same && i < JOINT_COUNT; ++i) {
			is_same = !has(static_cast<Joint>(i)) || positions_m[i] == other.positions_m[i];
		}
		return is_same;
	}
};

} // namespace steadyhand
