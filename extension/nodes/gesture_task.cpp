#include "gesture_task.h"

#include "name_suggestions.h"
#include "node_label.h"

#include "gesture/task.h"
#include "tracking/frame.h"

#include <godot_cpp/classes/dir_access.hpp>
#include <godot_cpp/core/class_db.hpp>

#include <algorithm>
#include <cmath>

namespace godot {

namespace {

/// Gestures of the models in the add-on's folder.
PackedStringArray installed_gestures() {
	const String folder = "res://addons/steadyhand/models";
	PackedStringArray gestures;
	if (DirAccess::dir_exists_absolute(folder)) {
		for (const String &file : DirAccess::get_files_at(folder)) {
			if (file.get_extension() == "gesture") {
				gestures.push_back(file.get_basename());
			}
		}
	}
	return gestures;
}

/// For any length but 0. Scales first, because squares of very long and very short vectors overflow or
/// vanish.
Vector3 unit_of(const Vector3 &p_vector) {
	const real_t longest = std::max({ std::abs(p_vector.x), std::abs(p_vector.y), std::abs(p_vector.z) });
	return longest > 0 ? (p_vector / longest).normalized() : Vector3();
}

} // namespace

GestureTask::GestureTask() {
	set_notify_transform(true);
}

void GestureTask::_notification(int p_what) {
	if (p_what == NOTIFICATION_TRANSFORM_CHANGED) {
		emit_signal("changed");
	} else if (p_what == NOTIFICATION_EXIT_TREE) {
		const Node3D *const parent = is_set_as_top_level() ? nullptr : get_parent_node_3d();
		parent_place_ = parent != nullptr ? parent->get_global_transform() : Transform3D();
	}
}

Transform3D GestureTask::place() const {
	return is_inside_tree() ? get_global_transform() : parent_place_ * get_transform();
}

void GestureTask::announce_change() {
	emit_signal("changed");
	update_configuration_warnings();
	update_gizmos();
}

void GestureTask::set_gesture(const StringName &p_gesture) {
	if (gesture_ != p_gesture) {
		gesture_ = p_gesture;
		announce_change();
	}
}

void GestureTask::set_direction(const Vector3 &p_direction) {
	ERR_FAIL_COND_MSG(!p_direction.is_finite(), refusal(*this, "direction must be finite", p_direction));
	if (direction_ != p_direction) {
		direction_ = p_direction;
		announce_change();
	}
}

void GestureTask::set_amplitude(double p_amplitude) {
	ERR_FAIL_COND_MSG(
			!(p_amplitude >= steadyhand::SMALLEST_AMPLITUDE_M) || !(p_amplitude <= steadyhand::FARTHEST_M),
			refusal(*this, "amplitude must be 1e-6..1e9 m", p_amplitude));
	if (amplitude_ != p_amplitude) {
		amplitude_ = p_amplitude;
		announce_change();
	}
}

void GestureTask::set_start_radius(double p_radius) {
	ERR_FAIL_COND_MSG(!(p_radius >= 0.0) || !(p_radius <= steadyhand::FARTHEST_M),
			refusal(*this, "start_radius must be 0..1e9 m", p_radius));
	if (start_radius_ != p_radius) {
		start_radius_ = p_radius;
		announce_change();
	}
}

Vector3 GestureTask::get_start() const {
	return place().origin;
}

Vector3 GestureTask::get_axis() const {
	const Vector3 direction = unit_of(direction_), axis = unit_of(place().basis.xform(direction));
	return axis.is_finite() && axis.length_squared() > 0 ? axis : direction;
}

PackedStringArray GestureTask::_get_configuration_warnings() const {
	PackedStringArray warnings;
	if (gesture_ == StringName()) {
		warnings.push_back(
				"Set \"gesture\" to the name of the gesture that is expected here, e.g. horizontal_drag. "
				"While it is empty, a GestureHMM with several models does not use this place.");
	}
	if (direction_.length_squared() <= 0 && start_radius_ <= 0.0) {
		warnings.push_back("Set \"direction\" to the direction of the hand's motion, or \"start_radius\" for "
						   "a zoom; both are "
						   "zero.");
	}
	return warnings;
}

void GestureTask::_validate_property(PropertyInfo &p_property) const {
	if (p_property.name == StringName("gesture")) {
		suggest(installed_gestures(), p_property);
	}
}

void GestureTask::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_gesture", "gesture"), &GestureTask::set_gesture);
	ClassDB::bind_method(D_METHOD("get_gesture"), &GestureTask::get_gesture);
	ClassDB::bind_method(D_METHOD("set_direction", "direction"), &GestureTask::set_direction);
	ClassDB::bind_method(D_METHOD("get_direction"), &GestureTask::get_direction);
	ClassDB::bind_method(D_METHOD("set_amplitude", "amplitude"), &GestureTask::set_amplitude);
	ClassDB::bind_method(D_METHOD("get_amplitude"), &GestureTask::get_amplitude);
	ClassDB::bind_method(D_METHOD("set_start_radius", "start_radius"), &GestureTask::set_start_radius);
	ClassDB::bind_method(D_METHOD("get_start_radius"), &GestureTask::get_start_radius);
	ClassDB::bind_method(D_METHOD("get_start"), &GestureTask::get_start);
	ClassDB::bind_method(D_METHOD("get_axis"), &GestureTask::get_axis);

	ADD_PROPERTY(PropertyInfo(Variant::STRING_NAME, "gesture"), "set_gesture", "get_gesture");
	ADD_PROPERTY(PropertyInfo(Variant::VECTOR3, "direction"), "set_direction", "get_direction");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "amplitude", PROPERTY_HINT_RANGE,
						 "0.01,1,0.001,or_greater,suffix:m"),
			"set_amplitude", "get_amplitude");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "start_radius", PROPERTY_HINT_RANGE,
						 "0,0.3,0.001,or_greater,suffix:m"),
			"set_start_radius", "get_start_radius");

	ADD_SIGNAL(MethodInfo("changed"));
}

} // namespace godot
