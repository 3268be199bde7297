#pragma once

#include "tracking/hand_skeleton.h"

#include <Eigen/Geometry>

#include <godot_cpp/classes/xr_hand_tracker.hpp>
#include <godot_cpp/variant/string_name.hpp>

namespace godot {

/// Rotation from OpenXR's joints to the bones of Godot's humanoid skeleton: -y along the bone instead of -z.
inline Eigen::Quaterniond humanoid_turn() {
	constexpr double HALF_ROOT = 0.70710678118654752;
	return { 0.0, 0.0, -HALF_ROOT, HALF_ROOT };
}

/// Registers a hand as an XRHandTracker with its own name, so that XRHandModifier3D and hand meshes follow
/// any source.
class HandPublisher {
public:
	HandPublisher(const StringName &p_name, bool p_is_left);
	HandPublisher(const HandPublisher &) = delete;
	HandPublisher &operator=(const HandPublisher &) = delete;
	~HandPublisher();

	/// Missing joints are inferred, and marked as valid but not tracked. p_tracking_to_frames: from the
	/// tracking space, in which the joints are published, to the space of the frame.
	void publish(const steadyhand::DeviceFrame &p_frame, const Eigen::Affine3d &p_tracking_to_frames);
	void publish_lost();

private:
	Ref<XRHandTracker> tracker_;
};

} // namespace godot
