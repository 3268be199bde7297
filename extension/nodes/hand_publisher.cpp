#include "hand_publisher.h"

#include "device_queue.h"
#include "geometry_conversions.h"

#include "tracking/skeleton_inference.h"

#include <godot_cpp/classes/xr_pose.hpp>
#include <godot_cpp/classes/xr_server.hpp>

namespace godot {

HandPublisher::HandPublisher(const StringName &p_name, bool p_is_left) {
	tracker_.instantiate();
	tracker_->set_tracker_name(p_name);
	tracker_->set_tracker_hand(
			p_is_left ? XRPositionalTracker::TRACKER_HAND_LEFT : XRPositionalTracker::TRACKER_HAND_RIGHT);
	tracker_->set_hand_tracking_source(XRHandTracker::HAND_TRACKING_SOURCE_UNOBSTRUCTED);
	XRServer::get_singleton()->add_tracker(tracker_);
}

HandPublisher::~HandPublisher() {
	publish_lost();
	XRServer *const server = XRServer::get_singleton();
	const Ref<XRTracker> registered = server->get_tracker(tracker_->get_tracker_name());
	if (registered.ptr() == tracker_.ptr()) { // an XR interface may have replaced it
		server->remove_tracker(tracker_);
	}
}

void HandPublisher::publish(
		const steadyhand::DeviceFrame &p_frame, const Eigen::Affine3d &p_tracking_to_frames) {
	if (p_frame.hand.tracked == 0) {
		publish_lost();
		return;
	}
	steadyhand::HandSkeleton hand = steadyhand::infer_skeleton(p_frame);
	move_joints(hand, p_tracking_to_frames.inverse());
	for (std::size_t i = 0; i < steadyhand::SKELETON_JOINT_COUNT; ++i) {
		const auto joint = static_cast<XRHandTracker::HandJoint>(i);
		int64_t flags = 0;
		Transform3D place;
		if (hand.has(static_cast<steadyhand::SkeletonJoint>(i))) {
			flags |= XRHandTracker::HAND_JOINT_FLAG_POSITION_VALID;
			if ((hand.inferred >> i & 1U) == 0) {
				flags |= XRHandTracker::HAND_JOINT_FLAG_POSITION_TRACKED;
			}
			place.origin = to_godot(hand.positions_m[i]);
			if ((hand.rotated >> i & 1U) != 0) {
				flags |= XRHandTracker::HAND_JOINT_FLAG_ORIENTATION_VALID;
				place.basis = to_godot((hand.rotations[i] * humanoid_turn()).toRotationMatrix());
			}
		}
		tracker_->set_hand_joint_transform(joint, place);
		tracker_->set_hand_joint_flags(joint, BitField<XRHandTracker::HandJointFlags>(flags));
	}
	tracker_->set_has_tracking_data(true);
	// Nodes that follow the hand read its pose.
	tracker_->set_pose("default", tracker_->get_hand_joint_transform(XRHandTracker::HAND_JOINT_PALM),
			Vector3(), Vector3(), XRPose::XR_TRACKING_CONFIDENCE_HIGH);
}

void HandPublisher::publish_lost() {
	tracker_->set_has_tracking_data(false);
	tracker_->invalidate_pose("default");
}

} // namespace godot
