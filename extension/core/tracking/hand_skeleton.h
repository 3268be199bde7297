#pragma once

#include "tracking/frame.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace steadyhand {

/// Joints of XR_EXT_hand_tracking, in the order of OpenXR and of Godot's XRHandTracker.HandJoint.
enum class SkeletonJoint : std::uint8_t {
	PALM,
	WRIST,
	THUMB_METACARPAL,
	THUMB_PROXIMAL,
	THUMB_DISTAL,
	THUMB_TIP,
	INDEX_METACARPAL,
	INDEX_PROXIMAL,
	INDEX_INTERMEDIATE,
	INDEX_DISTAL,
	INDEX_TIP,
	MIDDLE_METACARPAL,
	MIDDLE_PROXIMAL,
	MIDDLE_INTERMEDIATE,
	MIDDLE_DISTAL,
	MIDDLE_TIP,
	RING_METACARPAL,
	RING_PROXIMAL,
	RING_INTERMEDIATE,
	RING_DISTAL,
	RING_TIP,
	PINKY_METACARPAL,
	PINKY_PROXIMAL,
	PINKY_INTERMEDIATE,
	PINKY_DISTAL,
	PINKY_TIP
};

inline constexpr std::size_t SKELETON_JOINT_COUNT = 26;

/// Skeleton joint of each Joint.
inline constexpr std::array<SkeletonJoint, JOINT_COUNT> SKELETON_OF = { SkeletonJoint::THUMB_TIP,
	SkeletonJoint::INDEX_TIP, SkeletonJoint::MIDDLE_TIP, SkeletonJoint::RING_TIP, SkeletonJoint::PINKY_TIP,
	SkeletonJoint::PALM, SkeletonJoint::WRIST };

/// All joints of a hand that the tracker reports. Positions are in metres, in Godot's axes. Rotations are
/// OpenXR's: +z of a joint points back along the bone, +y out of the back of the hand.
struct HandSkeleton {
	std::array<Eigen::Vector3d, SKELETON_JOINT_COUNT> positions_m{};
	std::array<Eigen::Quaterniond, SKELETON_JOINT_COUNT> rotations{};
	std::uint32_t positioned = 0; ///< bit i set: positions_m[i] is valid and finite
	std::uint32_t rotated = 0;    ///< bit i set: rotations[i] is valid
	std::uint32_t inferred = 0;   ///< bit i set: the tracker's hand model infers the joint's position

	static constexpr std::uint32_t bit(SkeletonJoint joint) { return 1U << static_cast<unsigned>(joint); }

	/// Removes all joints.
	void clear() { positioned = rotated = inferred = 0; }
	[[nodiscard]] bool has(SkeletonJoint joint) const { return (positioned & bit(joint)) != 0; }
	[[nodiscard]] const Eigen::Vector3d &position(SkeletonJoint joint) const {
		return positions_m[static_cast<std::size_t>(joint)];
	}
	void set(SkeletonJoint joint, const Eigen::Vector3d &position_m) {
		positions_m[static_cast<std::size_t>(joint)] = position_m;
		positioned |= bit(joint);
	}
};

/// Frame with the tips, palm and wrist of `skeleton` at t_s.
[[nodiscard]] inline HandFrame hand_frame_of(const HandSkeleton &skeleton, double t_s) {
	HandFrame frame;
	frame.t_s = t_s;
	for (std::size_t i = 0; i < JOINT_COUNT; ++i) {
		if (skeleton.has(SKELETON_OF[i])) {
			frame.set(static_cast<Joint>(i), skeleton.position(SKELETON_OF[i]));
			if ((skeleton.inferred & HandSkeleton::bit(SKELETON_OF[i])) != 0) {
				frame.inferred = static_cast<std::uint8_t>(frame.inferred | (1U << i));
			}
		}
	}
	return frame;
}

/// One frame from a device. Times are in s, NaN if there is none.
struct DeviceFrame {
	HandFrame hand;        ///< its stamp is on the tracker's clock, which all listeners share
	HandSkeleton skeleton; ///< empty if the device has only the joints of `hand`
	double device_time_s = std::numeric_limits<double>::quiet_NaN(); ///< on the device's own clock
	double host_time_s = std::numeric_limits<double>::quiet_NaN();   ///< arrival, on the host's clock
};

} // namespace steadyhand
