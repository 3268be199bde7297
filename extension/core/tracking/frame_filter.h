#pragma once

#include "tracking/hand_skeleton.h"

#include <cstdint>

namespace steadyhand {

/// An invalid position in a frame.
enum class FrameFault : std::uint8_t {
	NOT_FINITE, ///< a joint at NaN, infinity, or beyond FARTHEST_M
	ZERO        ///< all joints exactly at the origin: many trackers report a lost hand so
};

/// Removes invalid joints from each frame, before all other processing.
class FrameFilter {
public:
	/// Removes joints with invalid positions. Removes all joints if each is exactly (0, 0, 0), except a
	/// single point that was within NEAR_ORIGIN_M of the origin in the frame before. Returns a set: bit i for
	/// FrameFault i.
	std::uint8_t clean(DeviceFrame &r_frame);

private:
	/// A single tracked point may pass through the origin. This is the distance of a fast hand (3 m/s)
	/// between two frames at 60 Hz.
	static constexpr double NEAR_ORIGIN_M = 0.05;

	bool was_near_origin_ = true; ///< a stream may begin at the origin
};

} // namespace steadyhand
