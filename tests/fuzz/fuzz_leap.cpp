// Any text of a Leap service is a message or one error; every number of a frame is finite and in range.

#include "devices/leap_protocol.h"
#include "require.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <variant>

using namespace steadyhand;
using steadyhand::fuzz::require;

namespace {

bool is_share(double value) {
	return value >= 0.0 && value <= 1.0;
}

void check_skeleton(const HandSkeleton &skeleton) {
	for (std::size_t i = 0; i < SKELETON_JOINT_COUNT; ++i) {
		const std::uint32_t bit = HandSkeleton::bit(static_cast<SkeletonJoint>(i));
		if ((skeleton.positioned & bit) != 0) {
			require(skeleton.positions_m[i].allFinite() &&
							skeleton.positions_m[i].norm() <= LEAP_FARTHEST_M * (1.0 + 1e-12),
					"a joint is within reach");
		}
		if ((skeleton.rotated & bit) != 0) {
			require(std::abs(skeleton.rotations[i].norm() - 1.0) < 1e-6, "a rotation is of unit length");
		}
	}
}

void check_frame(const LeapFrame &frame) {
	require(std::isfinite(frame.device_time_s()), "the time is finite");
	require(std::isfinite(frame.frame_rate_hz) && frame.frame_rate_hz >= 0.0, "the rate is not negative");
	require(frame.hands.size() <= LEAP_HANDS_MAX, "hands are no more than the limit");
	for (const LeapHand &hand : frame.hands) {
		require(is_share(hand.confidence) && is_share(hand.grab) && is_share(hand.pinch),
				"confidence, grab and pinch are within 0..1");
		require(std::isfinite(hand.time_visible_s) && hand.time_visible_s >= 0.0, "a hand's time is sound");
		require(hand.skeleton.has(SkeletonJoint::PALM), "a hand has a palm");
		check_skeleton(hand.skeleton);
	}
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
	const LeapMessage message = parse_leap_message({ reinterpret_cast<const char *>(data), size });
	if (const auto *frame = std::get_if<LeapFrame>(&message)) {
		check_frame(*frame);
	} else if (const auto *error = std::get_if<Error>(&message)) {
		require(!error->message.empty(), "an error says what is wrong");
	} else if (const auto *version = std::get_if<LeapVersion>(&message)) {
		require(version->version >= 1, "a version is 1 or more");
	}
	return 0;
}
