// Properties and methods of HandTracker for the inspector and scripts.

#include "hand_tracker.h"

#include "conversions.h"
#include "hand_frame.h"
#include "hand_source.h"
#include "node_label.h"

#include <godot_cpp/core/class_db.hpp>

namespace godot {

void HandTracker::set_update_mode(UpdateMode p_mode) {
	ERR_FAIL_COND_MSG(!is_enumerator(p_mode, UPDATE_MANUAL),
			refusal(*this, "update_mode must be one of UPDATE_*", p_mode));
	update_mode_ = p_mode;
	update_processing();
}

void HandTracker::set_publish_name(const StringName &p_name) {
	publish_name_ = p_name;
	update_publisher();
}

void HandTracker::set_publish_hand(Hand p_hand) {
	ERR_FAIL_COND_MSG(!is_enumerator(p_hand, HAND_RIGHT),
			refusal(*this, "publish_hand must be HAND_LEFT or HAND_RIGHT", p_hand));
	publish_hand_ = p_hand;
	update_publisher();
}

PackedStringArray HandTracker::_get_configuration_warnings() const {
	if (source_.is_valid()) {
		return source_->get_warnings();
	}
	PackedStringArray warnings;
	warnings.push_back("Set \"source\" to the device: an XRSource for a headset, a SyntheticSource to try it "
					   "without one, "
					   "a ScriptSource for frames that a script pushes.");
	return warnings;
}

void HandTracker::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_source", "source"), &HandTracker::set_source);
	ClassDB::bind_method(D_METHOD("get_source"), &HandTracker::get_source);
	ClassDB::bind_method(D_METHOD("set_update_mode", "mode"), &HandTracker::set_update_mode);
	ClassDB::bind_method(D_METHOD("get_update_mode"), &HandTracker::get_update_mode);
	ClassDB::bind_method(D_METHOD("set_autostart", "autostart"), &HandTracker::set_autostart);
	ClassDB::bind_method(D_METHOD("get_autostart"), &HandTracker::get_autostart);
	ClassDB::bind_method(D_METHOD("set_publish_name", "name"), &HandTracker::set_publish_name);
	ClassDB::bind_method(D_METHOD("get_publish_name"), &HandTracker::get_publish_name);
	ClassDB::bind_method(D_METHOD("set_publish_hand", "hand"), &HandTracker::set_publish_hand);
	ClassDB::bind_method(D_METHOD("get_publish_hand"), &HandTracker::get_publish_hand);

	ClassDB::bind_method(D_METHOD("start"), &HandTracker::start);
	ClassDB::bind_method(D_METHOD("_start_if_due"), &HandTracker::start_if_due);
	ClassDB::bind_method(D_METHOD("stop"), &HandTracker::stop);
	ClassDB::bind_method(D_METHOD("is_running"), &HandTracker::is_running);
	ClassDB::bind_method(D_METHOD("is_finished"), &HandTracker::is_finished);
	ClassDB::bind_method(D_METHOD("is_hand_tracked"), &HandTracker::is_hand_tracked);
	ClassDB::bind_method(D_METHOD("get_time"), &HandTracker::get_time);
	ClassDB::bind_method(D_METHOD("get_start_time"), &HandTracker::get_start_time);
	ClassDB::bind_method(D_METHOD("get_duration"), &HandTracker::get_duration);
	ClassDB::bind_method(D_METHOD("get_frame_rate"), &HandTracker::get_frame_rate);
	ClassDB::bind_method(D_METHOD("get_frame_jitter"), &HandTracker::get_frame_jitter);
	ClassDB::bind_method(D_METHOD("get_reading_rate"), &HandTracker::get_reading_rate);
	ClassDB::bind_method(D_METHOD("get_noise"), &HandTracker::get_noise);
	ClassDB::bind_method(D_METHOD("get_dropout_count"), &HandTracker::get_dropout_count);
	ClassDB::bind_method(D_METHOD("get_freeze_count"), &HandTracker::get_freeze_count);
	ClassDB::bind_method(D_METHOD("get_jump_count"), &HandTracker::get_jump_count);
	ClassDB::bind_method(D_METHOD("get_latency"), &HandTracker::get_latency);
	ClassDB::bind_method(D_METHOD("advance", "seconds"), &HandTracker::advance);
	ClassDB::bind_method(D_METHOD("advance_to", "time_s"), &HandTracker::advance_to);
	ClassDB::bind_method(
			D_METHOD("push_frame", "time_s", "joints", "confidence"), &HandTracker::push_frame, DEFVAL(1.0));
	ClassDB::bind_method(D_METHOD("report_failure", "reason"), &HandTracker::report_failure);
	ClassDB::bind_method(D_METHOD("get_joint_position", "joint"), &HandTracker::get_joint_position);
	ClassDB::bind_method(D_METHOD("is_joint_tracked", "joint"), &HandTracker::is_joint_tracked);
	ClassDB::bind_method(D_METHOD("is_joint_inferred", "joint"), &HandTracker::is_joint_inferred);
	ClassDB::bind_method(D_METHOD("start_recording", "path"), &HandTracker::start_recording);
	ClassDB::bind_method(D_METHOD("stop_recording"), &HandTracker::stop_recording);

	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "source", PROPERTY_HINT_RESOURCE_TYPE, "HandSource"),
			"set_source", "get_source");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "update_mode", PROPERTY_HINT_ENUM, "Idle,Physics,Manual"),
			"set_update_mode", "get_update_mode");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "autostart"), "set_autostart", "get_autostart");
	ADD_GROUP("Publish", "publish_");
	ADD_PROPERTY(PropertyInfo(Variant::STRING_NAME, "publish_name"), "set_publish_name", "get_publish_name");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "publish_hand", PROPERTY_HINT_ENUM, "Left,Right"),
			"set_publish_hand", "get_publish_hand");

	constexpr uint32_t READ_ONLY = PROPERTY_USAGE_NONE;
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "frame_rate", PROPERTY_HINT_NONE, "suffix:Hz", READ_ONLY), "",
			"get_frame_rate");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "frame_jitter", PROPERTY_HINT_NONE, "suffix:s", READ_ONLY), "",
			"get_frame_jitter");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "reading_rate", PROPERTY_HINT_NONE, "suffix:Hz", READ_ONLY), "",
			"get_reading_rate");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "noise", PROPERTY_HINT_NONE, "suffix:m", READ_ONLY), "",
			"get_noise");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "dropout_count", PROPERTY_HINT_NONE, "", READ_ONLY), "",
			"get_dropout_count");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "freeze_count", PROPERTY_HINT_NONE, "", READ_ONLY), "",
			"get_freeze_count");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "jump_count", PROPERTY_HINT_NONE, "", READ_ONLY), "",
			"get_jump_count");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "latency", PROPERTY_HINT_NONE, "suffix:s", READ_ONLY), "",
			"get_latency");

	ADD_SIGNAL(MethodInfo("frame_received",
			PropertyInfo(Variant::OBJECT, "frame", PROPERTY_HINT_RESOURCE_TYPE, "HandFrame")));
	ADD_SIGNAL(MethodInfo("tracking_lost"));
	ADD_SIGNAL(MethodInfo("tracking_restored"));
	ADD_SIGNAL(MethodInfo("finished"));
	ADD_SIGNAL(MethodInfo("source_ready"));
	ADD_SIGNAL(MethodInfo("failed", PropertyInfo(Variant::STRING, "reason")));

	BIND_ENUM_CONSTANT(UPDATE_IDLE);
	BIND_ENUM_CONSTANT(UPDATE_PHYSICS);
	BIND_ENUM_CONSTANT(UPDATE_MANUAL);
	BIND_ENUM_CONSTANT(JOINT_PALM);
	BIND_ENUM_CONSTANT(JOINT_WRIST);
	BIND_ENUM_CONSTANT(JOINT_THUMB);
	BIND_ENUM_CONSTANT(JOINT_INDEX);
	BIND_ENUM_CONSTANT(JOINT_MIDDLE);
	BIND_ENUM_CONSTANT(JOINT_RING);
	BIND_ENUM_CONSTANT(JOINT_PINKY);
	BIND_ENUM_CONSTANT(HAND_LEFT);
	BIND_ENUM_CONSTANT(HAND_RIGHT);
}

} // namespace godot
