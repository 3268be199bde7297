#pragma once

#include "hand_source.h"

#include "devices/liberty_sequence.h"

#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/transform3d.hpp>

namespace godot {

/// A Polhemus Liberty on the USB: one sensor for each joint.
class LibertySource : public HandSource {
	GDCLASS(LibertySource, HandSource)

public:
	enum Rate : int64_t { RATE_120_HZ = 120, RATE_240_HZ = 240 };

	void set_joints(const PackedInt32Array &p_joints);
	PackedInt32Array get_joints() const { return joints_; }
	void set_rate(Rate p_rate);
	Rate get_rate() const { return rate_; }
	void set_hemisphere(const Vector3 &p_hemisphere);
	Vector3 get_hemisphere() const { return hemisphere_; }
	void set_device_transform(const Transform3D &p_transform);
	Transform3D get_device_transform() const { return device_transform_; }

	steadyhand::LibertySettings core() const;

	std::unique_ptr<HandStream> make_stream(HandTracker &p_tracker) override;
	String no_frame_advice() const override;
	bool is_script() const override { return false; }

protected:
	static void _bind_methods();

private:
	PackedInt32Array joints_ = { 10 }; ///< of station 1, 2, ...: XRHandTracker.HandJoint; -1: unused
	Rate rate_ = RATE_240_HZ;
	Vector3 hemisphere_ = Vector3(0, 0, -1); ///< in Godot's axes about the source
	Transform3D device_transform_;
};

} // namespace godot

VARIANT_ENUM_CAST(godot::LibertySource::Rate);
