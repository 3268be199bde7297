#pragma once

#include "tracking/hand_skeleton.h"

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/variant/dictionary.hpp>

namespace godot {

/// One frame of a HandTracker, for scripts. It never changes.
class HandFrame : public RefCounted {
	GDCLASS(HandFrame, RefCounted)

	steadyhand::DeviceFrame frame_;

public:
	void set_frame(const steadyhand::DeviceFrame &p_frame) { frame_ = p_frame; }

	double get_time() const { return frame_.hand.t_s; }
	double get_device_time() const { return frame_.device_time_s; }
	double get_host_time() const { return frame_.host_time_s; }
	double get_confidence() const { return frame_.hand.confidence; }
	bool is_tracked() const { return frame_.hand.tracked != 0; }
	bool has_joint(int64_t p_joint) const;
	bool is_joint_inferred(int64_t p_joint) const;
	Vector3 get_joint_position(int64_t p_joint) const;
	Dictionary get_joints() const;

protected:
	static void _bind_methods();
};

/// All joints of a frame, from its skeleton or its HandFrame.
steadyhand::HandSkeleton joints_of(const steadyhand::DeviceFrame &p_frame);

} // namespace godot
