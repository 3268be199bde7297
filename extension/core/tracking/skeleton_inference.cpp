#include "tracking/skeleton_inference.h"

#include <algorithm>
#include <span>

namespace steadyhand {
namespace {

constexpr std::size_t FINGERS = 5;
/// Where each finger's metacarpal begins in the order of SkeletonJoint; the tip is its last joint.
constexpr std::array<std::size_t, FINGERS + 1> FIRST = { 2, 6, 11, 16, 21, 26 };
/// Shares of the way from wrist to tip of a straight finger (hand proportions of Buryanov & Kotiuk 2010).
constexpr std::array<double, 4> THUMB_SHARES = { 0.25, 0.55, 0.80, 1.0 };
constexpr std::array<double, 5> FINGER_SHARES = { 0.15, 0.52, 0.76, 0.89, 1.0 };

/// Along the bone that ends at `to`: OpenXR's z points back from there.
Eigen::Quaterniond along(const Eigen::Vector3d &from, const Eigen::Vector3d &to) {
	return Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), from - to);
}

void rotate(
		HandSkeleton &r_skeleton, std::size_t joint, const Eigen::Vector3d &from, const Eigen::Vector3d &to) {
	const std::uint32_t bit = 1U << joint;
	if ((r_skeleton.rotated & bit) == 0 && (to - from).squaredNorm() > 0.0) {
		r_skeleton.rotations[joint] = along(from, to);
		r_skeleton.rotated |= bit;
	}
}

void place(HandSkeleton &r_skeleton, std::size_t joint, const Eigen::Vector3d &position_m) {
	if (!r_skeleton.has(static_cast<SkeletonJoint>(joint))) {
		r_skeleton.set(static_cast<SkeletonJoint>(joint), position_m);
		r_skeleton.inferred |= 1U << joint;
	}
}

} // namespace

HandSkeleton infer_skeleton(const DeviceFrame &frame) {
	HandSkeleton skeleton = frame.skeleton;
	for (std::size_t i = 0; i < JOINT_COUNT; ++i) {
		if (frame.hand.has(static_cast<Joint>(i)) && !skeleton.has(SKELETON_OF[i])) {
			skeleton.set(SKELETON_OF[i], frame.hand.positions_m[i]);
		}
	}
	const bool has_wrist = skeleton.has(SkeletonJoint::WRIST);
	if (!has_wrist && !skeleton.has(SkeletonJoint::PALM)) {
		return skeleton;
	}
	const Eigen::Vector3d root = skeleton.position(has_wrist ? SkeletonJoint::WRIST : SkeletonJoint::PALM);
	Eigen::Vector3d tips = Eigen::Vector3d::Zero();
	int tip_count = 0;
	for (std::size_t finger = 0; finger < FINGERS; ++finger) {
		const std::size_t tip = FIRST[finger + 1] - 1;
		if (!skeleton.has(static_cast<SkeletonJoint>(tip))) {
			continue;
		}
		const Eigen::Vector3d tip_m = skeleton.positions_m[tip];
		tips += tip_m;
		++tip_count;
		const auto shares = finger == 0 ? std::span<const double>(THUMB_SHARES) : FINGER_SHARES;
		for (std::size_t i = 0; i < shares.size(); ++i) {
			place(skeleton, FIRST[finger] + i, root + shares[i] * (tip_m - root));
		}
		for (std::size_t joint = FIRST[finger]; joint <= tip; ++joint) {
			const bool is_first = joint == FIRST[finger];
			rotate(skeleton, joint, is_first ? root : skeleton.positions_m[joint - 1],
					skeleton.positions_m[joint]);
		}
	}
	if (tip_count > 0) {
		const Eigen::Vector3d middle = tips / tip_count;
		place(skeleton, static_cast<std::size_t>(SkeletonJoint::WRIST), root);
		place(skeleton, static_cast<std::size_t>(SkeletonJoint::PALM), root + 0.4 * (middle - root));
		rotate(skeleton, static_cast<std::size_t>(SkeletonJoint::WRIST), root, middle);
		rotate(skeleton, static_cast<std::size_t>(SkeletonJoint::PALM), root, middle);
	}
	return skeleton;
}

} // namespace steadyhand
