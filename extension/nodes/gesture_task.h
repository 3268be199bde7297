#pragma once

#include <godot_cpp/classes/node3d.hpp>

namespace godot {

/// Where a scene expects a gesture: its global position is the start. Emits `changed` after each change.
class GestureTask : public Node3D {
	GDCLASS(GestureTask, Node3D)

	StringName gesture_;
	Vector3 direction_ = Vector3(1, 0, 0);
	double amplitude_ = 0.2;
	double start_radius_ = 0.0;
	Transform3D parent_place_; ///< parent in the world when the task last left the tree

	/// Transform in the world. Outside the tree the parent counts as if it had stayed.
	Transform3D place() const;
	void announce_change();

protected:
	static void _bind_methods();
	void _notification(int p_what);
	void _validate_property(PropertyInfo &p_property) const;

public:
	GestureTask();

	void set_gesture(const StringName &p_gesture);
	StringName get_gesture() const { return gesture_; }
	void set_direction(const Vector3 &p_direction);
	Vector3 get_direction() const { return direction_; }
	void set_amplitude(double p_amplitude);
	double get_amplitude() const { return amplitude_; }
	void set_start_radius(double p_radius);
	double get_start_radius() const { return start_radius_; }

	/// m, world; before the task first enters the tree: relative to the parent.
	Vector3 get_start() const;
	/// Unit vector; the local direction if the node's scale is degenerate.
	Vector3 get_axis() const;

	PackedStringArray _get_configuration_warnings() const override;
};

} // namespace godot
