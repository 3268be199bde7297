#pragma once

#include "tracking/hand_skeleton.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <deque>
#include <utility>

namespace godot {

/// Frames of a device between its arrival and a tracker's time.
class DeviceQueue {
public:
	/// A frame may arrive so much later than it was taken: the tracker's time waits for it. USB and a busy
	/// host delay by some tens of milliseconds.
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

	/// Up to where all frames have come, s.
	double complete_until_s(double p_now_s) const {
		const double newest_s = frames_.empty() ? p_now_s - LATE_S : frames_.back().hand.t_s;
		return std::max(newest_s, p_now_s - LATE_S);
	}

	void clear() { frames_.clear(); }

private:
	std::deque<steadyhand::DeviceFrame> frames_;
};

/// Moves all joints from the device's space, as where the device stands in the scene says.
inline void move_joints(steadyhand::HandSkeleton &r_joints, const Eigen::Affine3d &p_device) {
	const Eigen::Quaterniond turn(p_device.rotation());
	for (std::size_t i = 0; i < steadyhand::SKELETON_JOINT_COUNT; ++i) {
		if (r_joints.has(static_cast<steadyhand::SkeletonJoint>(i))) {
			r_joints.positions_m[i] = p_device * r_joints.positions_m[i];
		}
		if ((r_joints.rotated >> i & 1U) != 0) {
			r_joints.rotations[i] = turn * r_joints.rotations[i];
		}
	}
}

} // namespace godot
