// Properties and methods of GestureHMM for the inspector and scripts.

#include "gesture_hmm.h"

#include "conversions.h"
#include "gesture_task.h"
#include "hand_tracker.h"
#include "node_label.h"
#include "parent_as.h"

#include "recognition/gesture_recogniser.h"

#include <godot_cpp/core/class_db.hpp>

namespace godot {

namespace {

constexpr double LARGEST_LATENCY_S = 0.2;
/// Below half of the amplitude the hand may still return.
constexpr double LEAST_COMPLETION = 0.5;
constexpr double SHORTEST_DWELL_S = 0.1, LONGEST_DWELL_S = 3.0;
/// An open hand has 5 to 13 cm between thumb and index (leapjs-playback).
constexpr double NARROWEST_PINCH_M = 0.005, WIDEST_PINCH_M = 0.1;

} // namespace

// In this file, because it includes the recogniser's definition.
GestureHMM::GestureHMM() = default;

GestureHMM::~GestureHMM() {
	if (tracker_ != nullptr) {
		tracker_->remove_listener(this);
	}
	listeners_.call(&MotionListener::on_motion_freed);
}

void GestureHMM::set_tracker(HandTracker *p_tracker) {
	follows_parent_ = false;
	if (listen_to(p_tracker, tracker_, this)) {
		restart_tracker_watch();
		update_configuration_warnings();
		on_stream_started();
	}
}

void GestureHMM::follow_parent() {
	HandTracker *const parent = parent_as<HandTracker>(*this);
	if (tracker_ == nullptr && parent != nullptr) {
		set_tracker(parent);
		follows_parent_ = true;
	}
}

void GestureHMM::on_tracker_freed() {
	tracker_ = nullptr;
	follows_parent_ = false;
	restart_tracker_watch();
	update_configuration_warnings();
	on_stream_started();
}

void GestureHMM::set_models(const TypedArray<GestureModel> &p_models) {
	const Callable callable = callable_mp(this, &GestureHMM::on_expected_changed);
	for (int64_t i = 0; i < models_.size(); ++i) {
		connect_changed(models_[i], callable, false);
	}
	models_ = p_models.duplicate();
	for (int64_t i = 0; i < models_.size(); ++i) {
		connect_changed(models_[i], callable, true);
	}
	on_expected_changed();
}

void GestureHMM::connect_changed(Object *p_object, const Callable &p_callable, bool p_connect) {
	if (p_object == nullptr || p_object->is_connected("changed", p_callable) == p_connect) {
		return; // a model may be in the list twice
	}
	if (p_connect) {
		p_object->connect("changed", p_callable);
	} else {
		p_object->disconnect("changed", p_callable);
	}
}

void GestureHMM::on_settings_changed() {
	update_configuration_warnings();
	reset();
}

void GestureHMM::set_mode(Mode p_mode) {
	ERR_FAIL_COND_MSG(!is_enumerator(p_mode, MODE_PAPER),
			refusal(*this, "mode must be MODE_PHASE or MODE_PAPER", p_mode));
	if (mode_ != p_mode) {
		mode_ = p_mode;
		on_settings_changed();
	}
}

void GestureHMM::set_quality(Quality p_quality) {
	ERR_FAIL_COND_MSG(!is_enumerator(p_quality, QUALITY_ACCURATE),
			refusal(*this, "quality must be one of QUALITY_*", p_quality));
	if (quality_ != p_quality) {
		quality_ = p_quality;
		on_settings_changed();
	}
}

void GestureHMM::set_motion(Motion p_motion) {
	ERR_FAIL_COND_MSG(!is_enumerator(p_motion, MOTION_KALMAN),
			refusal(*this, "motion must be one of MOTION_*", p_motion));
	motion_ = p_motion;
}

void GestureHMM::set_sensor_latency(double p_latency_s) {
	ERR_FAIL_COND_MSG(!(p_latency_s >= 0.0) || p_latency_s > LARGEST_LATENCY_S,
			refusal(*this, "sensor_latency must be 0..0.2 s", p_latency_s));
	if (sensor_latency_s_ != p_latency_s) {
		sensor_latency_s_ = p_latency_s;
		on_settings_changed();
	}
}

void GestureHMM::set_min_confidence(double p_confidence) {
	ERR_FAIL_COND_MSG(!(p_confidence >= 0.0) || p_confidence > 1.0,
			refusal(*this, "min_confidence must be 0..1", p_confidence));
	min_confidence_ = p_confidence;
	if (recogniser_) {
		recogniser_->set_min_confidence(p_confidence);
	}
}

void GestureHMM::set_completion(double p_fraction) {
	ERR_FAIL_COND_MSG(!(p_fraction >= LEAST_COMPLETION) || p_fraction > 1.0,
			refusal(*this, "completion must be 0.5..1", p_fraction));
	completion_ = p_fraction;
	if (recogniser_) {
		recogniser_->set_completion(completion_);
	}
}

/// Does not affect active gestures.
void GestureHMM::on_start_changed() {
	frames_with_hand_ = 0;
	if (recogniser_) {
		recogniser_->set_start_condition(start_);
		warn_of_settings();
	}
	update_configuration_warnings();
}

void GestureHMM::set_start_condition(StartCondition p_condition) {
	ERR_FAIL_COND_MSG(!is_enumerator(p_condition, START_POINTING_POSE),
			refusal(*this, "start_condition must be one of START_*", p_condition));
	if (get_start_condition() != p_condition) {
		start_.kind = static_cast<steadyhand::StartKind>(p_condition);
		on_start_changed();
	}
}

void GestureHMM::set_dwell_time(double p_time_s) {
	ERR_FAIL_COND_MSG(!(p_time_s >= SHORTEST_DWELL_S) || p_time_s > LONGEST_DWELL_S,
			refusal(*this, "dwell_time must be 0.1..3 s", p_time_s));
	if (start_.dwell_s != p_time_s) {
		start_.dwell_s = p_time_s;
		on_start_changed();
	}
}

void GestureHMM::set_pinch_distance(double p_distance_m) {
	ERR_FAIL_COND_MSG(!(p_distance_m >= NARROWEST_PINCH_M) || p_distance_m > WIDEST_PINCH_M,
			refusal(*this, "pinch_distance must be 0.005..0.1 m", p_distance_m));
	if (start_.pinch_m != p_distance_m) {
		start_.pinch_m = p_distance_m;
		on_start_changed();
	}
}

void GestureHMM::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_tracker", "tracker"), &GestureHMM::set_tracker);
	ClassDB::bind_method(D_METHOD("get_tracker"), &GestureHMM::get_tracker);
	ClassDB::bind_method(D_METHOD("set_tasks", "tasks"), &GestureHMM::set_tasks);
	ClassDB::bind_method(D_METHOD("get_tasks"), &GestureHMM::get_tasks);
	ClassDB::bind_method(D_METHOD("set_task", "task"), &GestureHMM::set_task);
	ClassDB::bind_method(D_METHOD("get_task"), &GestureHMM::get_task);
	ClassDB::bind_method(D_METHOD("set_models", "models"), &GestureHMM::set_models);
	ClassDB::bind_method(D_METHOD("get_models"), &GestureHMM::get_models);
	ClassDB::bind_method(D_METHOD("set_mode", "mode"), &GestureHMM::set_mode);
	ClassDB::bind_method(D_METHOD("get_mode"), &GestureHMM::get_mode);
	ClassDB::bind_method(D_METHOD("set_quality", "quality"), &GestureHMM::set_quality);
	ClassDB::bind_method(D_METHOD("get_quality"), &GestureHMM::get_quality);
	ClassDB::bind_method(D_METHOD("set_motion", "motion"), &GestureHMM::set_motion);
	ClassDB::bind_method(D_METHOD("get_motion"), &GestureHMM::get_motion);
	ClassDB::bind_method(D_METHOD("set_sensor_latency", "latency"), &GestureHMM::set_sensor_latency);
	ClassDB::bind_method(D_METHOD("get_sensor_latency"), &GestureHMM::get_sensor_latency);
	ClassDB::bind_method(D_METHOD("set_min_confidence", "confidence"), &GestureHMM::set_min_confidence);
	ClassDB::bind_method(D_METHOD("get_min_confidence"), &GestureHMM::get_min_confidence);
	ClassDB::bind_method(D_METHOD("set_completion", "fraction"), &GestureHMM::set_completion);
	ClassDB::bind_method(D_METHOD("get_completion"), &GestureHMM::get_completion);
	ClassDB::bind_method(D_METHOD("set_start_condition", "condition"), &GestureHMM::set_start_condition);
	ClassDB::bind_method(D_METHOD("get_start_condition"), &GestureHMM::get_start_condition);
	ClassDB::bind_method(D_METHOD("set_dwell_time", "time"), &GestureHMM::set_dwell_time);
	ClassDB::bind_method(D_METHOD("get_dwell_time"), &GestureHMM::get_dwell_time);
	ClassDB::bind_method(D_METHOD("set_pinch_distance", "distance"), &GestureHMM::set_pinch_distance);
	ClassDB::bind_method(D_METHOD("get_pinch_distance"), &GestureHMM::get_pinch_distance);
	ClassDB::bind_method(D_METHOD("get_value"), &GestureHMM::get_value);
	ClassDB::bind_method(D_METHOD("get_value_at", "time"), &GestureHMM::get_value_at);
	ClassDB::bind_method(D_METHOD("get_velocity"), &GestureHMM::get_velocity);
	ClassDB::bind_method(D_METHOD("get_acceleration"), &GestureHMM::get_acceleration);
	ClassDB::bind_method(D_METHOD("get_progress"), &GestureHMM::get_progress);
	ClassDB::bind_method(D_METHOD("get_gesture"), &GestureHMM::get_gesture);
	ClassDB::bind_method(D_METHOD("get_current_task"), &GestureHMM::get_current_task);
	ClassDB::bind_method(D_METHOD("get_state"), &GestureHMM::get_state);
	ClassDB::bind_method(D_METHOD("get_confidence"), &GestureHMM::get_confidence);
	ClassDB::bind_method(D_METHOD("get_time"), &GestureHMM::get_time);
	ClassDB::bind_method(D_METHOD("get_recognised"), &GestureHMM::get_recognised);
	ClassDB::bind_method(D_METHOD("reset"), &GestureHMM::reset);
	ClassDB::bind_method(D_METHOD("get_motion_value", "motion"), &GestureHMM::get_motion_value);

	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "tracker", PROPERTY_HINT_NODE_TYPE, "HandTracker"),
			"set_tracker", "get_tracker");
	const String task_hint =
			itos(Variant::OBJECT) + String("/") + itos(PROPERTY_HINT_NODE_TYPE) + ":GestureTask";
	// With this hint, a scene file stores paths for an array of nodes.
	ADD_PROPERTY(PropertyInfo(Variant::ARRAY, "tasks", PROPERTY_HINT_TYPE_STRING, task_hint), "set_tasks",
			"get_tasks");
	const String model_hint =
			itos(Variant::OBJECT) + String("/") + itos(PROPERTY_HINT_RESOURCE_TYPE) + ":GestureModel";
	ADD_PROPERTY(PropertyInfo(Variant::ARRAY, "models", PROPERTY_HINT_ARRAY_TYPE, model_hint), "set_models",
			"get_models");
	ADD_PROPERTY(
			PropertyInfo(Variant::INT, "mode", PROPERTY_HINT_ENUM, "Phase,Paper"), "set_mode", "get_mode");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "quality", PROPERTY_HINT_ENUM, "Fast,Balanced,Accurate"),
			"set_quality", "get_quality");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "motion", PROPERTY_HINT_ENUM,
						 "Synthesised,Measured,Moving Average,One Euro,Kalman"),
			"set_motion", "get_motion");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "sensor_latency", PROPERTY_HINT_RANGE, "0,0.2,0.001,suffix:s"),
			"set_sensor_latency", "get_sensor_latency");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "min_confidence", PROPERTY_HINT_RANGE, "0,1,0.01"),
			"set_min_confidence", "get_min_confidence");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "completion", PROPERTY_HINT_RANGE, "0.5,1,0.01"),
			"set_completion", "get_completion");
	ADD_GROUP("Start", "");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "start_condition", PROPERTY_HINT_ENUM,
						 "None,Dwell,Pinch,Pointing Pose"),
			"set_start_condition", "get_start_condition");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "dwell_time", PROPERTY_HINT_RANGE, "0.1,3,0.05,suffix:s"),
			"set_dwell_time", "get_dwell_time");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "pinch_distance", PROPERTY_HINT_RANGE, "0.005,0.1,0.001,suffix:m"),
			"set_pinch_distance", "get_pinch_distance");
	ADD_GROUP("", "");

	constexpr uint32_t SCRIPT_ONLY = PROPERTY_USAGE_NONE, READ_ONLY = PROPERTY_USAGE_NONE;
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "task", PROPERTY_HINT_NODE_TYPE, "GestureTask", SCRIPT_ONLY),
			"set_task", "get_task");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "value", PROPERTY_HINT_NONE, "suffix:m", READ_ONLY), "",
			"get_value");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "velocity", PROPERTY_HINT_NONE, "suffix:m/s", READ_ONLY), "",
			"get_velocity");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "acceleration", PROPERTY_HINT_NONE, "suffix:m/s^2", READ_ONLY),
			"", "get_acceleration");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "progress", PROPERTY_HINT_NONE, "", READ_ONLY), "", "get_progress");
	ADD_PROPERTY(PropertyInfo(Variant::STRING_NAME, "gesture", PROPERTY_HINT_NONE, "", READ_ONLY), "",
			"get_gesture");
	ADD_PROPERTY(
			PropertyInfo(Variant::OBJECT, "current_task", PROPERTY_HINT_NODE_TYPE, "GestureTask", READ_ONLY),
			"", "get_current_task");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "state", PROPERTY_HINT_NONE, "", READ_ONLY), "", "get_state");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "confidence", PROPERTY_HINT_NONE, "", READ_ONLY), "",
			"get_confidence");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "time", PROPERTY_HINT_NONE, "suffix:s", READ_ONLY), "", "get_time");
	ADD_PROPERTY(PropertyInfo(Variant::STRING_NAME, "recognised", PROPERTY_HINT_NONE, "", READ_ONLY), "",
			"get_recognised");

	const PropertyInfo task(Variant::OBJECT, "task", PROPERTY_HINT_NODE_TYPE, "GestureTask",
			PROPERTY_USAGE_DEFAULT, "GestureTask");
	ADD_SIGNAL(MethodInfo("gesture_started", PropertyInfo(Variant::STRING_NAME, "gesture"), task));
	ADD_SIGNAL(MethodInfo("state_changed", PropertyInfo(Variant::INT, "state")));
	ADD_SIGNAL(MethodInfo("gesture_ended", PropertyInfo(Variant::STRING_NAME, "gesture"),
			PropertyInfo(Variant::FLOAT, "time_s"), task, PropertyInfo(Variant::FLOAT, "fraction")));
	ADD_SIGNAL(MethodInfo("gesture_aborted", PropertyInfo(Variant::STRING_NAME, "gesture"), task));
	ADD_SIGNAL(MethodInfo("motion_updated", PropertyInfo(Variant::FLOAT, "time_s")));

	BIND_ENUM_CONSTANT(MODE_PHASE);
	BIND_ENUM_CONSTANT(MODE_PAPER);
	BIND_ENUM_CONSTANT(QUALITY_FAST);
	BIND_ENUM_CONSTANT(QUALITY_BALANCED);
	BIND_ENUM_CONSTANT(QUALITY_ACCURATE);
	BIND_ENUM_CONSTANT(MOTION_SYNTHESISED);
	BIND_ENUM_CONSTANT(MOTION_MEASURED);
	BIND_ENUM_CONSTANT(MOTION_AVERAGE);
	BIND_ENUM_CONSTANT(MOTION_ONE_EURO);
	BIND_ENUM_CONSTANT(MOTION_KALMAN);
	BIND_ENUM_CONSTANT(START_NONE);
	BIND_ENUM_CONSTANT(START_DWELL);
	BIND_ENUM_CONSTANT(START_PINCH);
	BIND_ENUM_CONSTANT(START_POINTING_POSE);
}

} // namespace godot
