#include "tracking/skeleton_inference.h"

#include <doctest/doctest.h>

#include <bit>
#include <utility>

using namespace steadyhand;

namespace {

const Eigen::Vector3d WRIST(0.0, 1.0, 0.0);
const Eigen::Vector3d INDEX_TIP(0.02, 1.0, -0.18);

} // namespace

TEST_CASE("a wrist and a tip make one finger on the line between them") {
	DeviceFrame frame;
	frame.hand.set(Joint::WRIST, WRIST);
	frame.hand.set(Joint::INDEX, INDEX_TIP);
	const HandSkeleton hand = infer_skeleton(frame);
	CHECK(std::popcount(hand.positioned) == 5 + 2); // the finger, wrist and palm
	CHECK(hand.position(SkeletonJoint::INDEX_TIP) == INDEX_TIP);
	const Eigen::Vector3d along = (INDEX_TIP - WRIST).normalized();
	double before = 0.0;
	for (int joint = 6; joint <= 10; ++joint) {
		const Eigen::Vector3d from_wrist = hand.positions_m[static_cast<std::size_t>(joint)] - WRIST;
		CHECK(from_wrist.cross(along).norm() < 1e-12);
		CHECK(from_wrist.dot(along) > before);
		before = from_wrist.dot(along);
		// OpenXR: z points back along the bone.
		const Eigen::Vector3d back =
				hand.rotations[static_cast<std::size_t>(joint)] * Eigen::Vector3d::UnitZ();
		CHECK((back + along).norm() < 1e-9);
	}
}

TEST_CASE("measured joints stay and inferred ones are marked") {
	DeviceFrame frame;
	frame.hand.set(Joint::WRIST, WRIST);
	frame.hand.set(Joint::INDEX, INDEX_TIP);
	const Eigen::Vector3d knuckle(0.03, 1.02, -0.09);
	frame.skeleton.set(SkeletonJoint::INDEX_PROXIMAL, knuckle);
	const HandSkeleton hand = infer_skeleton(frame);
	CHECK(hand.position(SkeletonJoint::INDEX_PROXIMAL) == knuckle);
	const std::uint32_t measured = HandSkeleton::bit(SkeletonJoint::INDEX_PROXIMAL) |
			HandSkeleton::bit(SkeletonJoint::INDEX_TIP) | HandSkeleton::bit(SkeletonJoint::WRIST);
	CHECK((hand.positioned & ~hand.inferred) == measured);
}

TEST_CASE("tips without wrist and palm make no fingers") {
	DeviceFrame frame;
	frame.hand.set(Joint::INDEX, INDEX_TIP);
	CHECK(infer_skeleton(frame).positioned == HandSkeleton::bit(SkeletonJoint::INDEX_TIP));
	CHECK(infer_skeleton(DeviceFrame()).positioned == 0);
}

TEST_CASE("fingers bend evenly, to the inner side, and have their length") {
	// A right hand that points along -z, palm down, with all tips drawn towards the palm.
	DeviceFrame frame;
	frame.hand.set(Joint::WRIST, { 0.0, 1.0, 0.0 });
	frame.hand.set(Joint::PALM, { 0.0, 1.0, -0.085 });
	for (const auto &[joint, x] : { std::pair(Joint::INDEX, -0.027), { Joint::MIDDLE, -0.006 },
				 { Joint::RING, 0.014 }, { Joint::PINKY, 0.032 } }) {
		frame.hand.set(joint, { x, 0.96, -0.11 });
	}
	const HandSkeleton hand = infer_skeleton(frame);
	const auto at = [&hand](SkeletonJoint joint) { return hand.position(joint); };
	CHECK((at(SkeletonJoint::INDEX_PROXIMAL) - Eigen::Vector3d(-0.027, 1.0, -0.093)).norm() < 0.003);
	// The arc passes beyond both ends, and returns below.
	CHECK(at(SkeletonJoint::INDEX_INTERMEDIATE).z() < at(SkeletonJoint::INDEX_TIP).z());
	CHECK(at(SkeletonJoint::INDEX_INTERMEDIATE).y() > at(SkeletonJoint::INDEX_TIP).y());
	double length_m = 0.0;
	for (std::size_t joint = 8; joint <= 10; ++joint) {
		length_m += (hand.positions_m[joint] - hand.positions_m[joint - 1]).norm();
	}
	CHECK(length_m > 0.8 * 0.095); // chords are shorter than the arc
	CHECK(length_m < 0.095);
}
