// HandTracker as the inspector and scripts see it.

#include "hand_tracker.h"

#include "conversions.h"

#include "simulation/gesture_motion.h"

#include <godot_cpp/classes/file_access.hpp>
#include <godot_cpp/core/class_db.hpp>

#include <limits>

namespace godot {

void HandTracker::set_source(Source p_source) {
	ERR_FAIL_COND_MSG(!is_enumerator(p_source, SOURCE_SYNTHETIC), "HandTracker: source must be a Source");
	source_ = p_source;
	notify_property_list_changed();
	update_configuration_warnings();
}

void HandTracker::set_update_mode(UpdateMode p_mode) {
	ERR_FAIL_COND_MSG(
			!is_enumerator(p_mode, UPDATE_MANUAL), "HandTracker: update_mode must be an UpdateMode");
	update_mode_ = p_mode;
	update_processing();
}

void HandTracker::set_recording_path(const String &p_path) {
	recording_path_ = p_path;
	update_configuration_warnings();
}

void HandTracker::set_synthetic_position(SyntheticPosition p_position) {
	ERR_FAIL_COND_MSG(!is_enumerator(p_position, POSITION_UNSTABLE),
			"HandTracker: synthetic_position must be a SyntheticPosition");
	synthetic_position_ = p_position;
}

void HandTracker::set_synthetic_subject(int64_t p_subject) {
	ERR_FAIL_COND_MSG(p_subject < 0 || p_subject > std::numeric_limits<std::uint32_t>::max(),
			"HandTracker: synthetic_subject must be in 0..4294967295");
	synthetic_subject_ = p_subject;
}

PackedStringArray HandTracker::_get_configuration_warnings() const {
	PackedStringArray warnings;
	if (source_ == SOURCE_RECORDED && recording_path_.is_empty()) {
		warnings.push_back("Set \"recording_path\" to the track (*.csv) to be played.");
	} else if (source_ == SOURCE_RECORDED && !FileAccess::file_exists(recording_path_)) {
		warnings.push_back(String("Set \"recording_path\" to a file that exists; there is no ") +
				recording_path_ + String("."));
	}
	return warnings;
}

void HandTracker::_validate_property(PropertyInfo &p_property) const {
	const String name = p_property.name;
	if (name == "synthetic_gesture") {
		String gestures;
		for (const steadyhand::SimulatedGesture &gesture : steadyhand::simulated_gestures()) {
			gestures += to_godot(gesture.name) + String(",");
		}
		p_property.hint = PROPERTY_HINT_ENUM;
		p_property.hint_string = gestures + String("none");
	}
	const bool unused = (name.begins_with("synthetic_") && source_ != SOURCE_SYNTHETIC) ||
			(name == "recording_path" && source_ != SOURCE_RECORDED) ||
			(name == "loop" && source_ == SOURCE_SCRIPT);
	if (unused) {
		p_property.usage = PROPERTY_USAGE_NO_EDITOR;
	}
}

void HandTracker::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_source", "source"), &HandTracker::set_source);
	ClassDB::bind_method(D_METHOD("get_source"), &HandTracker::get_source);
	ClassDB::bind_method(D_METHOD("set_update_mode", "mode"), &HandTracker::set_update_mode);
	ClassDB::bind_method(D_METHOD("get_update_mode"), &HandTracker::get_update_mode);
	ClassDB::bind_method(D_METHOD("set_autostart", "autostart"), &HandTracker::set_autostart);
	ClassDB::bind_method(D_METHOD("get_autostart"), &HandTracker::get_autostart);
	ClassDB::bind_method(D_METHOD("set_recording_path", "path"), &HandTracker::set_recording_path);
	ClassDB::bind_method(D_METHOD("get_recording_path"), &HandTracker::get_recording_path);
	ClassDB::bind_method(D_METHOD("set_loop", "loop"), &HandTracker::set_loop);
	ClassDB::bind_method(D_METHOD("get_loop"), &HandTracker::get_loop);
	ClassDB::bind_method(D_METHOD("set_synthetic_gesture", "gesture"), &HandTracker::set_synthetic_gesture);
	ClassDB::bind_method(D_METHOD("get_synthetic_gesture"), &HandTracker::get_synthetic_gesture);
	ClassDB::bind_method(
			D_METHOD("set_synthetic_position", "position"), &HandTracker::set_synthetic_position);
	ClassDB::bind_method(D_METHOD("get_synthetic_position"), &HandTracker::get_synthetic_position);
	ClassDB::bind_method(D_METHOD("set_synthetic_seed", "seed"), &HandTracker::set_synthetic_seed);
	ClassDB::bind_method(D_METHOD("get_synthetic_seed"), &HandTracker::get_synthetic_seed);
	ClassDB::bind_method(D_METHOD("set_synthetic_subject", "subject"), &HandTracker::set_synthetic_subject);
	ClassDB::bind_method(D_METHOD("get_synthetic_subject"), &HandTracker::get_synthetic_subject);

	ClassDB::bind_method(D_METHOD("start"), &HandTracker::start);
	ClassDB::bind_method(D_METHOD("stop"), &HandTracker::stop);
	ClassDB::bind_method(D_METHOD("is_running"), &HandTracker::is_running);
	ClassDB::bind_method(D_METHOD("is_finished"), &HandTracker::is_finished);
	ClassDB::bind_method(D_METHOD("get_time"), &HandTracker::get_time);
	ClassDB::bind_method(D_METHOD("get_start_time"), &HandTracker::get_start_time);
	ClassDB::bind_method(D_METHOD("get_duration"), &HandTracker::get_duration);
	ClassDB::bind_method(D_METHOD("get_synthetic_trial"), &HandTracker::get_synthetic_trial);
	ClassDB::bind_method(D_METHOD("advance", "seconds"), &HandTracker::advance);
	ClassDB::bind_method(D_METHOD("advance_to", "time_s"), &HandTracker::advance_to);
	ClassDB::bind_method(
			D_METHOD("push_frame", "time_s", "joints", "confidence"), &HandTracker::push_frame, DEFVAL(1.0));
	ClassDB::bind_method(D_METHOD("get_joint_position", "joint"), &HandTracker::get_joint_position);
	ClassDB::bind_method(D_METHOD("is_joint_tracked", "joint"), &HandTracker::is_joint_tracked);
	ClassDB::bind_method(D_METHOD("start_recording", "path"), &HandTracker::start_recording);
	ClassDB::bind_method(D_METHOD("stop_recording"), &HandTracker::stop_recording);

	ADD_PROPERTY(PropertyInfo(Variant::INT, "source", PROPERTY_HINT_ENUM, "Script,Recorded,Synthetic"),
			"set_source", "get_source");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "update_mode", PROPERTY_HINT_ENUM, "Idle,Physics,Manual"),
			"set_update_mode", "get_update_mode");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "autostart"), "set_autostart", "get_autostart");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "loop"), "set_loop", "get_loop");
	ADD_GROUP("Recording", "recording_");
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "recording_path", PROPERTY_HINT_FILE, "*.csv"),
			"set_recording_path", "get_recording_path");
	ADD_GROUP("Synthetic", "synthetic_");
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "synthetic_gesture"), "set_synthetic_gesture",
			"get_synthetic_gesture");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "synthetic_position", PROPERTY_HINT_ENUM, "Stable,Unstable"),
			"set_synthetic_position", "get_synthetic_position");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "synthetic_seed", PROPERTY_HINT_RANGE, "0,1000,1,or_greater"),
			"set_synthetic_seed", "get_synthetic_seed");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "synthetic_subject", PROPERTY_HINT_RANGE, "0,100,1,or_greater"),
			"set_synthetic_subject", "get_synthetic_subject");

	ADD_SIGNAL(MethodInfo("frame_received", PropertyInfo(Variant::FLOAT, "time_s")));
	ADD_SIGNAL(MethodInfo("tracking_found"));
	ADD_SIGNAL(MethodInfo("tracking_lost"));
	ADD_SIGNAL(MethodInfo("finished"));
	ADD_SIGNAL(MethodInfo("source_ready"));
	ADD_SIGNAL(MethodInfo("source_unavailable", PropertyInfo(Variant::STRING, "message")));

	BIND_ENUM_CONSTANT(SOURCE_SCRIPT);
	BIND_ENUM_CONSTANT(SOURCE_RECORDED);
	BIND_ENUM_CONSTANT(SOURCE_SYNTHETIC);
	BIND_ENUM_CONSTANT(UPDATE_IDLE);
	BIND_ENUM_CONSTANT(UPDATE_PHYSICS);
	BIND_ENUM_CONSTANT(UPDATE_MANUAL);
	BIND_ENUM_CONSTANT(JOINT_THUMB);
	BIND_ENUM_CONSTANT(JOINT_INDEX);
	BIND_ENUM_CONSTANT(JOINT_MIDDLE);
	BIND_ENUM_CONSTANT(JOINT_RING);
	BIND_ENUM_CONSTANT(JOINT_PINKY);
	BIND_ENUM_CONSTANT(JOINT_PALM);
	BIND_ENUM_CONSTANT(JOINT_WRIST);
	BIND_ENUM_CONSTANT(POSITION_STABLE);
	BIND_ENUM_CONSTANT(POSITION_UNSTABLE);
}

} // namespace godot
