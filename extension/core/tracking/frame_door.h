#pragma once

#include "tracking/hand_skeleton.h"

#include <cstdint>

namespace steadyhand {

/// What a frame held that no hand can do.
enum class FrameFault : std::uint8_t {
	NOT_FINITE, ///< a joint at NaN, infinity, or beyond FARTHEST_M
	ZERO        ///< all joints exactly at the origin: how many trackers report a lost hand
};

/// Takes out of each frame what is no measurement, before anyone else sees it.
class FrameDoor {
public:
	/// Removes joints that are not finite. Removes all joints where each is exactly (0, 0, 0) and the hand
	/// was not within NEAR_ORIGIN_M of the origin in the frame before. Returns a set: bit i for FrameFault i.
	std::uint8_t clean(DeviceFrame &r_frame);

private:
	/// A single tracked point may pass through the origin of its space: from no further away than a fast hand
	/// (3 m/s) goes between two frames at 60 Hz.
	static constexpr double NEAR_ORIGIN_M = 0.05;

	bool was_near_origin_ = true; ///< a stream may begin at the origin
};

} // namespace steadyhand
