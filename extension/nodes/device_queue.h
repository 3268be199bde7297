#pragma once

#include "tracking/hand_skeleton.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <deque>
#include <utility>

namespace godot {

/// Frames of a device that have arrived, but are not delivered yet.
class DeviceQueue {
public:
	/// Longest delay of a frame's arrival. The tracker's time waits for it. USB and a busy host delay frames
	/// by some tens of milliseconds.
	static constexpr double LATE_S = 0.1;

	/// Stamps must not decrease.
	void push(steadyhand::DeviceFrame p_frame) { frames_.push_back(std::move(p_frame)); }

	bool next(double p_until_s, steadyhand::DeviceFrame &r_frame) {
		if (frames_.empty() || frames_.front().hand.t_s > p_until_s) {
			return false;
		}
		r_frame = std::move(frames_.front());
		frames_.pop_front();
		return true;
	}

	/// All frames before this time have arrived, s.
	double complete_until_s(double p_now_s) const {
		const double newest_s = frames_.empty() ? p_now_s - LATE_S : frames_.back().hand.t_s;
		return std::max(newest_s, p_now_s - LATE_S);
	}

	void clear() { frames_.clear(); }

private:
	std::deque<steadyhand::DeviceFrame> frames_;
};

/// Transforms all joints, for example by the pose of their device in the scene.
inline void move_joints(steadyhand::HandSkeleton &r_joints, const Eigen::Affine3d &p_transform) {
	const Eigen::Quaterniond turn(p_transform.rotation());
	for (std::size_t i = 0; i < steadyhand::SKELETON_JOINT_COUNT; ++i) {
		if (r_joints.has(static_cast<steadyhand::SkeletonJoint>(i))) {
			r_joints.positions_m[i] = p_transform * r_joints.positions_m[i];
		}
		if ((r_joints.rotated >> i & 1U) != 0) {
			r_joints.rotations[i] = turn * r_joints.rotations[i];
		}
	}
}

} // namespace godot
