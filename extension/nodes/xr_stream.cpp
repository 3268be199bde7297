#include "xr_stream.h"

#include "conversions.h"
#include "device_queue.h"
#include "geometry_conversions.h"
#include "hand_publisher.h"
#include "live_clock.h"

#include <godot_cpp/classes/xr_server.hpp>

namespace godot {

namespace {

using steadyhand::HandSkeleton;
using steadyhand::SkeletonJoint;

/// Some runtimes repeat a pose for seconds and report it as tracked (STYLY-NetSync #474).
constexpr double FROZEN_AFTER_S = 0.5;
/// A headset's runtime needs some seconds to start the session.
constexpr double SEARCHED_FOR_S = 5.0;
/// The hands are swapped if a palm is within OTHER_HAND_M of the other hand's last palm, and farther than
/// OWN_HAND_M from its own. After SWAPPED_FOR_S the new palm is accepted.
constexpr double OTHER_HAND_M = 0.05, OWN_HAND_M = 0.15, SWAPPED_FOR_S = 0.5;

bool has_flag(uint64_t p_flags, XRHandTracker::HandJointFlags p_flag) {
	return (p_flags & static_cast<uint64_t>(p_flag)) != 0;
}

Ref<XRHandTracker> find_tracker(const StringName &p_name) {
	return XRServer::get_singleton()->get_tracker(p_name);
}

} // namespace

Ref<XRHandTracker> XRStream::find_hand() {
	const StringName name = source_->name_of_hand();
	const Ref<XRTracker> tracker = XRServer::get_singleton()->get_tracker(name);
	const Ref<XRHandTracker> hand = tracker;
	if (tracker.is_valid() && hand.is_null() && !is_class_reported_) {
		is_class_reported_ = true;
		announce(StreamEvent::Kind::FAILED,
				String("XRSource: the tracker '") + String(name) + String("' is an ") + tracker->get_class() +
						String(", not an XRHandTracker. Set \"tracker_name\" to the name of a hand"));
	}
	return hand;
}

void XRStream::report_search(const Ref<XRHandTracker> &p_hand, double p_now_s) {
	if (p_hand.is_valid()) {
		searched_from_s_.reset();
		if (!is_found_) {
			is_found_ = true;
			announce(StreamEvent::Kind::READY);
		}
		return;
	}
	is_found_ = false;
	searched_from_s_ = searched_from_s_.value_or(p_now_s);
	if (!is_missing_reported_ && !is_class_reported_ && p_now_s - *searched_from_s_ > SEARCHED_FOR_S) {
		is_missing_reported_ = true;
		announce(StreamEvent::Kind::FAILED,
				String("XRSource: the XRServer has no hand tracker '") + String(source_->name_of_hand()) +
						String("'. Enable XR > OpenXR and its hand tracking in the project settings, and set "
							   "use_xr "
							   "of the main viewport. XRSource waits for it"));
	}
}

HandSkeleton XRStream::read_joints(XRHandTracker &p_hand) const {
	HandSkeleton joints;
	if (!p_hand.get_has_tracking_data()) {
		return joints;
	}
	for (std::size_t i = 0; i < steadyhand::SKELETON_JOINT_COUNT; ++i) {
		const auto joint = static_cast<XRHandTracker::HandJoint>(i);
		const auto flags = static_cast<uint64_t>(static_cast<int64_t>(p_hand.get_hand_joint_flags(joint)));
		const bool is_tracked = has_flag(flags, XRHandTracker::HAND_JOINT_FLAG_POSITION_TRACKED);
		const bool is_inferred =
				!is_tracked && has_flag(flags, XRHandTracker::HAND_JOINT_FLAG_POSITION_VALID);
		if (!is_tracked && !(is_inferred && source_->get_use_inferred())) {
			continue;
		}
		const Transform3D place = p_hand.get_hand_joint_transform(joint);
		joints.set(static_cast<SkeletonJoint>(i), to_core(place.origin));
		joints.inferred |= is_inferred ? 1U << i : 0U;
		if (has_flag(flags, XRHandTracker::HAND_JOINT_FLAG_ORIENTATION_VALID)) {
			joints.rotations[i] = Eigen::Quaterniond(to_core(place.basis)) * humanoid_turn().conjugate();
			joints.rotated |= 1U << i;
		}
	}
	return joints;
}

bool XRStream::is_frozen(const HandSkeleton &p_joints, double p_now_s) {
	bool is_same = p_joints.positioned != 0 && p_joints.positioned == last_.positioned;
	for (std::size_t i = 0; is_same && i < steadyhand::SKELETON_JOINT_COUNT; ++i) {
		is_same = !p_joints.has(static_cast<SkeletonJoint>(i)) ||
				p_joints.positions_m[i] == last_.positions_m[i];
	}
	if (!is_same) {
		moved_s_ = p_now_s;
		last_ = p_joints;
	}
	return p_now_s - moved_s_ >= FROZEN_AFTER_S;
}

bool XRStream::is_other_hand(const HandSkeleton &p_joints, double p_now_s) {
	const auto other_before_m = other_palm_m_;
	const Ref<XRHandTracker> other = find_tracker(source_->name_of_other_hand());
	if (other.is_valid() && other->get_has_tracking_data()) {
		other_palm_m_ = to_core(other->get_hand_joint_transform(XRHandTracker::HAND_JOINT_PALM).origin);
	}
	if (!p_joints.has(SkeletonJoint::PALM)) {
		return false;
	}
	const Eigen::Vector3d &palm_m = p_joints.position(SkeletonJoint::PALM);
	const bool is_swapped = other_before_m && p_now_s - own_palm_s_ < SWAPPED_FOR_S &&
			(palm_m - *other_before_m).norm() < OTHER_HAND_M && (palm_m - own_palm_m_).norm() > OWN_HAND_M;
	if (is_swapped) {
		other_palm_m_ = other_before_m; // the other tracker may now have this hand
		return true;
	}
	own_palm_m_ = palm_m;
	own_palm_s_ = p_now_s;
	return false;
}

void XRStream::to_space(HandSkeleton &r_joints, double p_now_s) {
	if (source_->get_space() == XRSource::SPACE_WORLD) {
		tracking_to_frames_ = tracking_to_world();
	} else {
		// Gestures without a task have the size of the real hand's motion, for any world scale.
		const double scale = XRServer::get_singleton()->get_world_scale();
		tracking_to_frames_ = Eigen::Scaling(1.0 / scale) * tracking_to_origin();
	}
	if (source_->get_space() == XRSource::SPACE_BODY) {
		if (r_joints.has(SkeletonJoint::INDEX_TIP)) {
			const Eigen::Vector3d tip_m = tracking_to_frames_ * r_joints.position(SkeletonJoint::INDEX_TIP);
			body_.follow(tip_m, head_turn(), p_now_s);
		}
		tracking_to_frames_ = body_.transform() * tracking_to_frames_;
	}
	move_joints(r_joints, tracking_to_frames_);
}

void XRStream::poll(double p_now_s) {
	if (polled_s_ && p_now_s <= *polled_s_) {
		return;
	}
	polled_s_ = p_now_s;
	const Ref<XRHandTracker> hand = find_hand();
	report_search(hand, p_now_s);
	if (hand.is_null()) {
		return;
	}
	HandSkeleton joints = read_joints(**hand);
	if (is_frozen(joints, p_now_s) || is_other_hand(joints, p_now_s)) {
		joints.clear();
	}
	to_space(joints, p_now_s);
	sampled_.emplace();
	sampled_->skeleton = joints;
	sampled_->hand = steadyhand::hand_frame_of(joints, p_now_s);
	sampled_->host_time_s = host_time_s();
}

bool XRStream::next(double p_until_s, steadyhand::DeviceFrame &r_frame) {
	if (!sampled_ || sampled_->hand.t_s > p_until_s) {
		return false;
	}
	r_frame = *sampled_;
	sampled_.reset();
	return true;
}

} // namespace godot
