#pragma once

#include "tracking/frame.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace steadyhand {

// Names of a track's columns, for its reader and writer.

constexpr std::string_view AXES = "xyz";

constexpr std::uint8_t joint_bit(std::size_t joint) {
	return static_cast<std::uint8_t>(1U << joint);
}

inline std::string coordinate_name(std::size_t joint, std::size_t axis) {
	return std::string(JOINT_NAMES[joint]) + '_' + AXES[axis];
}

} // namespace steadyhand
