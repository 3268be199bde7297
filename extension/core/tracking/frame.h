#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>

namespace steadyhand {

/// The points of a hand that a track can hold: five fingertips, the palm's centre, the wrist.
enum class Joint : std::uint8_t { THUMB, INDEX, MIDDLE, RING, PINKY, PALM, WRIST };

inline constexpr std::size_t JOINT_COUNT = 7;
/// As in track CSV.
inline constexpr std::array<std::string_view, JOINT_COUNT> JOINT_NAMES = { "thumb", "index", "middle", "ring",
	"pinky", "palm", "wrist" };

/// Bit i set: joint i is one of them.
constexpr std::uint8_t joint_bits(std::initializer_list<Joint> joints) {
	unsigned bits = 0;
	for (const Joint joint : joints) {
		bits |= 1U << static_cast<unsigned>(joint);
	}
	return static_cast<std::uint8_t>(bits);
}

/// No coordinate of a file is further from its origin, m: what is, is no place.
inline constexpr double FARTHEST_M = 1e9;
/// Nor a time from 0, s: it would be of another unit, or damaged. No clock counts further: beyond, a symbol's
/// period is lost in rounding, and the count of control instants, whole milliseconds, overflows.
inline constexpr double FARTHEST_S = 1e12;

/// Whether a point can be a place: finite, and no coordinate beyond FARTHEST_M.
[[nodiscard]] inline bool is_place(const Eigen::Vector3d &point_m) {
	return point_m.allFinite() && point_m.cwiseAbs().maxCoeff() <= FARTHEST_M;
}

/// One moment of a tracked hand. Positions in metres, x right, y up, -z forward (Godot's convention); time in
/// seconds on the device's own clock.
struct HandFrame {
	double t_s = 0.0;
	std::array<Eigen::Vector3d, JOINT_COUNT> positions_m{};
	std::uint8_t tracked =
			0; ///< bit i set: joint i was seen in this frame, positions_m[i] is valid and finite
	std::uint8_t inferred = 0; ///< bit i set: joint i is tracked, and the tracker's hand model guessed it
	double confidence = 1.0;   ///< 0..1 as the device reports it; 1 where it reports none

	[[nodiscard]] bool has(Joint joint) const { return (tracked >> static_cast<unsigned>(joint)) & 1U; }
	[[nodiscard]] bool has_all(std::uint8_t joints) const { return (tracked & joints) == joints; }
	[[nodiscard]] const Eigen::Vector3d &position(Joint joint) const {
		return positions_m[static_cast<std::size_t>(joint)];
	}
	void set(Joint joint, const Eigen::Vector3d &position_m) {
		positions_m[static_cast<std::size_t>(joint)] = position_m;
		tracked = static_cast<std::uint8_t>(tracked | (1U << static_cast<unsigned>(joint)));
	}
	/// The same moment, and the same hand in it to the last bit.
	[[nodiscard]] bool repeats(const HandFrame &other) const {
		bool is_same = t_s == other.t_s && tracked == other.tracked;
		for (std::size_t i = 0; is_same && i < JOINT_COUNT; ++i) {
			is_same = !has(static_cast<Joint>(i)) || positions_m[i] == other.positions_m[i];
		}
		return is_same;
	}
};

} // namespace steadyhand
