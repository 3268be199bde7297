#include "hand_frame.h"

#include "conversions.h"

#include <godot_cpp/core/class_db.hpp>

namespace godot {

namespace {

bool is_joint(int64_t p_joint) {
	return p_joint >= 0 && p_joint < static_cast<int64_t>(steadyhand::SKELETON_JOINT_COUNT);
}

constexpr const char *JOINT_FAULT = "HandFrame: the joint must be one of HandTracker.JOINT_*, 0..25";

} // namespace

steadyhand::HandSkeleton joints_of(const steadyhand::DeviceFrame &p_frame) {
	steadyhand::HandSkeleton joints = p_frame.skeleton;
	for (std::size_t i = 0; i < steadyhand::JOINT_COUNT; ++i) {
		if (p_frame.hand.has(static_cast<steadyhand::Joint>(i))) {
			const steadyhand::SkeletonJoint joint = steadyhand::SKELETON_OF[i];
			joints.set(joint, p_frame.hand.positions_m[i]);
			if ((p_frame.hand.inferred >> i & 1U) != 0) {
				joints.inferred |= steadyhand::HandSkeleton::bit(joint);
			}
		}
	}
	return joints;
}

bool HandFrame::has_joint(int64_t p_joint) const {
	ERR_FAIL_COND_V_MSG(!is_joint(p_joint), false, JOINT_FAULT);
	return joints_of(frame_).has(static_cast<steadyhand::SkeletonJoint>(p_joint));
}

bool HandFrame::is_joint_inferred(int64_t p_joint) const {
	ERR_FAIL_COND_V_MSG(!is_joint(p_joint), false, JOINT_FAULT);
	return (joints_of(frame_).inferred >> p_joint & 1U) != 0;
}

Vector3 HandFrame::get_joint_position(int64_t p_joint) const {
	ERR_FAIL_COND_V_MSG(!is_joint(p_joint), Vector3(), JOINT_FAULT);
	const steadyhand::HandSkeleton joints = joints_of(frame_);
	const auto joint = static_cast<steadyhand::SkeletonJoint>(p_joint);
	return joints.has(joint) ? to_godot(joints.position(joint)) : Vector3();
}

Dictionary HandFrame::get_joints() const {
	const steadyhand::HandSkeleton joints = joints_of(frame_);
	Dictionary positions;
	for (std::size_t i = 0; i < steadyhand::SKELETON_JOINT_COUNT; ++i) {
		if (joints.has(static_cast<steadyhand::SkeletonJoint>(i))) {
			positions[static_cast<int64_t>(i)] = to_godot(joints.positions_m[i]);
		}
	}
	return positions;
}

void HandFrame::_bind_methods() {
	ClassDB::bind_method(D_METHOD("get_time"), &HandFrame::get_time);
	ClassDB::bind_method(D_METHOD("get_device_time"), &HandFrame::get_device_time);
	ClassDB::bind_method(D_METHOD("get_host_time"), &HandFrame::get_host_time);
	ClassDB::bind_method(D_METHOD("get_confidence"), &HandFrame::get_confidence);
	ClassDB::bind_method(D_METHOD("is_tracked"), &HandFrame::is_tracked);
	ClassDB::bind_method(D_METHOD("has_joint", "joint"), &HandFrame::has_joint);
	ClassDB::bind_method(D_METHOD("is_joint_inferred", "joint"), &HandFrame::is_joint_inferred);
	ClassDB::bind_method(D_METHOD("get_joint_position", "joint"), &HandFrame::get_joint_position);
	ClassDB::bind_method(D_METHOD("get_joints"), &HandFrame::get_joints);

	constexpr uint32_t READ_ONLY = PROPERTY_USAGE_NONE;
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "time", PROPERTY_HINT_NONE, "suffix:s", READ_ONLY), "", "get_time");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "device_time", PROPERTY_HINT_NONE, "suffix:s", READ_ONLY), "",
			"get_device_time");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "host_time", PROPERTY_HINT_NONE, "suffix:s", READ_ONLY), "",
			"get_host_time");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "confidence", PROPERTY_HINT_NONE, "", READ_ONLY), "",
			"get_confidence");
}

} // namespace godot
