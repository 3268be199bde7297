#pragma once

#include "base/result.h"
#include "tracking/hand_skeleton.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace steadyhand {

// The WebSocket protocol of Leap Motion and Ultraleap services: ws://127.0.0.1:6437/v6.json, one JSON object
// in each text message. Three services use it: the original V2, Orion (V3, V4), and Ultraleap's bridge for
// Gemini (V5) and later. This file turns messages into structs. It does no I/O.

/// The first message of a connection.
struct LeapVersion {
	int version = 0;             ///< of the protocol, 1 or more
	std::string service_version; ///< as "2.3.1+33747"; empty if the service has none
};

/// Sent after the version message, and whenever a device is plugged in, paused or unplugged.
struct LeapDevice {
	std::string id;         ///< serial number, or a number as text; may be empty
	std::string type;       ///< in lower case, as "peripheral"; may be empty
	bool attached = false;  ///< the device is plugged in
	bool streaming = false; ///< the device sends frames; false if it is not attached
};

/// One hand of a frame.
struct LeapHand {
	std::int64_t id = 0; ///< constant while the hand is tracked; a lost hand returns with another id
	bool is_left = false;
	double confidence = 1.0;     ///< 0..1; 1 if the service sends none; newer services always send 1
	double grab = 0.0;           ///< 0 open hand .. 1 fist
	double pinch = 0.0;          ///< 0..1
	double time_visible_s = 0.0; ///< for how long the hand has had this id
	/// Metres in the device's own axes: x right, y up out of the device, z towards the user; origin on top of
	/// the device. The palm always has a position. The wrist has no rotation.
	HandSkeleton skeleton;
};

struct LeapFrame {
	std::int64_t id = 0;           ///< consecutive, even if frames are missing
	std::int64_t timestamp_us = 0; ///< on the service's clock
	double frame_rate_hz = 0.0;    ///< 0 if the service sends none
	std::vector<LeapHand> hands;   ///< in arbitrary order

	[[nodiscard]] double device_time_s() const { return static_cast<double>(timestamp_us) * 1e-6; }
};

/// A valid JSON message that is not used here, such as another event.
struct LeapOther {};

using LeapMessage = std::variant<LeapVersion, LeapDevice, LeapFrame, LeapOther, Error>;

/// A frame of two hands is 10 to 20 kB. A longer message is an error, because parsing it would stall the
/// game.
inline constexpr std::size_t LEAP_MESSAGE_SIZE_MAX = 256UL * 1024;
/// Services track two hands, some track more. Further hands of a frame are skipped.
inline constexpr std::size_t LEAP_HANDS_MAX = 8;
/// Limit of a joint's distance from the device, m. A farther joint is a fault of the service. Devices see
/// about 1 m.
inline constexpr double LEAP_FARTHEST_M = 10.0;

/// Parses one text message. Never throws; takes any bytes.
///
/// Skipped without an error: a joint whose position is not three numbers, is further away than
/// LEAP_FARTHEST_M or is exactly zero (how trackers report a lost joint); a rotation whose basis is no
/// rotation; a hand without an integer id, a type "left" or "right", or a palm position; a pointable that is
/// a tool or belongs to no hand of the frame.
///
/// The Error is one sentence without its source: "invalid JSON", "frame: 'timestamp' is not a number".
[[nodiscard]] LeapMessage parse_leap_message(std::string_view text);

} // namespace steadyhand
