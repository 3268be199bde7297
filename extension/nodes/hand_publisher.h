#pragma once

#include "tracking/hand_skeleton.h"

#include <Eigen/Geometry>

#include <godot_cpp/classes/xr_hand_tracker.hpp>
#include <godot_cpp/variant/string_name.hpp>

namespace godot {

/// Godot turns each joint of OpenXR into the bones of its humanoid skeleton: -y along the bone in place of
/// -z.
inline Eigen::Quaterniond humanoid_turn() {
	constexpr double HALF_ROOT = 0.70710678118654752;
	return { 0.0, 0.0, -HALF_ROOT, HALF_ROOT };
}

/// Offers a hand to the engine as an XRHandTracker of a name of its own, so that XRHandModifier3D and hand
/// meshes follow any source.
class HandPublisher {
public:
	HandPublisher(const StringName &p_name, bool p_is_left);
	HandPublisher(const HandPublisher &) = delete;
	HandPublisher &operator=(const HandPublisher &) = delete;
	~HandPublisher();

	/// Joints that the frame lacks are inferred, and marked as valid only.
	void publish(const steadyhand::DeviceFrame &p_frame);
	void publish_lost();

private:
	Ref<XRHandTracker> tracker_;
};

} // namespace godot
