#include "synthetic_source.h"

#include "conversions.h"
#include "gesture_task.h"
#include "hand_tracker.h"
#include "node_label.h"
#include "track_stream.h"
#include "trial_dictionary.h"

#include "simulation/gesture_motion.h"

#include <godot_cpp/core/class_db.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace godot {

namespace {

class SyntheticStream : public TrackStream {
public:
	SyntheticStream(const Ref<SyntheticSource> &p_source, const HandTracker &p_tracker) :
			TrackStream(p_source->get_loop()), source_(p_source), tracker_(p_tracker) {}

	String open() override {
		steadyhand::Result<steadyhand::SyntheticTrial> made = source_->make_trial(&tracker_);
		if (!made) {
			return to_godot(made.error());
		}
		steadyhand::SyntheticTrial &trial = made.value();
		play(std::move((source_->is_true_motion() ? trial.reference : trial.measured).frames));
		return String();
	}

private:
	Ref<SyntheticSource> source_;
	const HandTracker &tracker_;
};

/// Gestures of the user are not simulated; the source's own "gesture" is used instead.
bool is_simulated(const StringName &p_gesture) {
	return steadyhand::find_simulated_gesture(to_core(String(p_gesture))) != nullptr;
}

} // namespace

std::unique_ptr<HandStream> SyntheticSource::make_stream(HandTracker &p_tracker) {
	return std::make_unique<SyntheticStream>(Ref<SyntheticSource>(this), p_tracker);
}

void SyntheticSource::set_place_of(
		const GestureTask &p_task, steadyhand::SyntheticTrialRequest &r_request) const {
	if (is_simulated(p_task.get_gesture())) {
		r_request.gesture = to_core(p_task.get_gesture());
	}
	r_request.place = { to_core(p_task.get_start()), to_core(p_task.get_axis()), p_task.get_amplitude(),
		p_task.get_start_radius() };
}

steadyhand::Result<steadyhand::SyntheticTrial> SyntheticSource::make_trial(
		const HandTracker *p_tracker) const {
	steadyhand::SyntheticTrialRequest request;
	request.name = "synthetic";
	request.gesture = to_core(gesture_);
	request.position = position_ == POSITION_STABLE ? steadyhand::HandPosition::STABLE
													: steadyhand::HandPosition::UNSTABLE;
	// Other people than those of the models' training.
	request.subject =
			steadyhand::draw_subject(steadyhand::Population::EVALUATE, static_cast<std::uint32_t>(subject_));
	request.subject.pace = pace_;
	request.seed = static_cast<std::uint64_t>(seed_);
	request.duration_s = duration_s_;
	if (placement_ == PLACEMENT_FIXED) {
		request.place = { to_core(start_m_), to_core(direction_).normalized(), amplitude_m_,
			start_radius_m_ };
	} else if (placement_ == PLACEMENT_TASK) {
		const GestureTask *const task = p_tracker == nullptr
				? nullptr
				: Object::cast_to<GestureTask>(p_tracker->get_node_or_null(task_path_));
		if (task == nullptr) {
			return steadyhand::Error{ "set \"task_path\" of the SyntheticSource to a GestureTask, as seen "
									  "from the HandTracker; there is none at '" +
				to_core(String(task_path_)) + "'" };
		}
		set_place_of(*task, request);
	}
	return steadyhand::make_synthetic_trial(request);
}

Dictionary SyntheticSource::get_trial() const {
	ERR_FAIL_COND_V_MSG(placement_ == PLACEMENT_TASK, Dictionary(),
			"SyntheticSource: get_trial() has no values with PLACEMENT_TASK. Read them from the GestureTask");
	const steadyhand::Result<steadyhand::SyntheticTrial> made = make_trial(nullptr);
	ERR_FAIL_COND_V_MSG(
			!made, Dictionary(), String("SyntheticSource: ") + to_godot(made.ok() ? "" : made.error()));
	return trial_dictionary(made.value().trial);
}

void SyntheticSource::place_at(GestureTask *p_task) {
	ERR_FAIL_NULL_MSG(p_task, "SyntheticSource: place_at() needs a GestureTask, is null");
	if (is_simulated(p_task->get_gesture())) {
		set_gesture(p_task->get_gesture());
	}
	set_start(p_task->get_start());
	set_direction(p_task->get_axis());
	set_amplitude(p_task->get_amplitude());
	if (p_task->get_start_radius() > 0.0) {
		set_start_radius(p_task->get_start_radius());
	}
	set_placement(PLACEMENT_FIXED);
}

void SyntheticSource::set_gesture(const StringName &p_gesture) {
	gesture_ = p_gesture;
	emit_changed();
}

void SyntheticSource::set_position(Position p_position) {
	ERR_FAIL_COND_MSG(!is_enumerator(p_position, POSITION_UNSTABLE),
			refusal("SyntheticSource", "position must be POSITION_STABLE or POSITION_UNSTABLE", p_position));
	position_ = p_position;
	emit_changed();
}

void SyntheticSource::set_subject(int64_t p_subject) {
	ERR_FAIL_COND_MSG(p_subject < 0 || p_subject > std::numeric_limits<std::uint32_t>::max(),
			refusal("SyntheticSource", "subject must be 0..4294967295", p_subject));
	subject_ = p_subject;
	emit_changed();
}

void SyntheticSource::set_seed(int64_t p_seed) {
	seed_ = p_seed;
	emit_changed();
}

void SyntheticSource::set_duration(double p_duration_s) {
	ERR_FAIL_COND_MSG(!(p_duration_s >= 0.0) || !(p_duration_s <= steadyhand::GESTURE_MAX_S),
			refusal("SyntheticSource", "duration must be 0 (the person's own) or up to 4 s", p_duration_s));
	duration_s_ = p_duration_s;
	emit_changed();
}

void SyntheticSource::set_pace(double p_pace) {
	ERR_FAIL_COND_MSG(!(p_pace >= 0.1) || !(p_pace <= 10.0),
			refusal("SyntheticSource", "pace must be 0.1..10", p_pace));
	pace_ = p_pace;
	emit_changed();
}

void SyntheticSource::set_loop(bool p_loop) {
	loop_ = p_loop;
	emit_changed();
}

void SyntheticSource::set_true_motion(bool p_true_motion) {
	true_motion_ = p_true_motion;
	emit_changed();
}

void SyntheticSource::set_placement(Placement p_placement) {
	ERR_FAIL_COND_MSG(!is_enumerator(p_placement, PLACEMENT_TASK),
			refusal("SyntheticSource", "placement must be one of PLACEMENT_*", p_placement));
	placement_ = p_placement;
	notify_property_list_changed();
	emit_changed();
}

void SyntheticSource::set_task_path(const NodePath &p_path) {
	task_path_ = p_path;
	emit_changed();
}

void SyntheticSource::set_start(const Vector3 &p_start_m) {
	ERR_FAIL_COND_MSG(!p_start_m.is_finite(), refusal("SyntheticSource", "start must be finite", p_start_m));
	start_m_ = p_start_m;
	emit_changed();
}

void SyntheticSource::set_direction(const Vector3 &p_direction) {
	ERR_FAIL_COND_MSG(!p_direction.is_finite() || !(p_direction.length_squared() > 0),
			refusal("SyntheticSource", "direction must be finite and not zero", p_direction));
	direction_ = p_direction;
	emit_changed();
}

void SyntheticSource::set_amplitude(double p_amplitude_m) {
	ERR_FAIL_COND_MSG(!(p_amplitude_m >= steadyhand::SMALLEST_AMPLITUDE_M) || !(p_amplitude_m <= 10.0),
			refusal("SyntheticSource", "amplitude must be 1e-6..10 m", p_amplitude_m));
	amplitude_m_ = p_amplitude_m;
	emit_changed();
}

void SyntheticSource::set_start_radius(double p_radius_m) {
	ERR_FAIL_COND_MSG(!(p_radius_m > 0.0) || !(p_radius_m <= 1.0),
			refusal("SyntheticSource", "start_radius must be above 0 and at most 1 m", p_radius_m));
	start_radius_m_ = p_radius_m;
	emit_changed();
}

PackedStringArray SyntheticSource::get_warnings() const {
	PackedStringArray warnings;
	if (placement_ == PLACEMENT_TASK && task_path_.is_empty()) {
		warnings.push_back("Set \"task_path\" of the SyntheticSource to the GestureTask at which the hand "
						   "makes its gesture, as seen from the HandTracker.");
	}
	return warnings;
}

String SyntheticSource::no_frame_advice() const {
	return "Call start() or advance() of the HandTracker";
}

void SyntheticSource::_validate_property(PropertyInfo &p_property) const {
	const String name = p_property.name;
	if (name == "gesture") {
		String gestures;
		for (const steadyhand::SimulatedGesture &gesture : steadyhand::simulated_gestures()) {
			gestures += to_godot(gesture.name) + String(",");
		}
		p_property.hint = PROPERTY_HINT_ENUM;
		p_property.hint_string = gestures + String("none");
	}
	const bool is_place =
			name == "start" || name == "direction" || name == "amplitude" || name == "start_radius";
	if ((is_place && placement_ != PLACEMENT_FIXED) ||
			(name == "task_path" && placement_ != PLACEMENT_TASK)) {
		p_property.usage = PROPERTY_USAGE_NO_EDITOR;
	}
}

void SyntheticSource::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_gesture", "gesture"), &SyntheticSource::set_gesture);
	ClassDB::bind_method(D_METHOD("get_gesture"), &SyntheticSource::get_gesture);
	ClassDB::bind_method(D_METHOD("set_position", "position"), &SyntheticSource::set_position);
	ClassDB::bind_method(D_METHOD("get_position"), &SyntheticSource::get_position);
	ClassDB::bind_method(D_METHOD("set_subject", "subject"), &SyntheticSource::set_subject);
	ClassDB::bind_method(D_METHOD("get_subject"), &SyntheticSource::get_subject);
	ClassDB::bind_method(D_METHOD("set_seed", "seed"), &SyntheticSource::set_seed);
	ClassDB::bind_method(D_METHOD("get_seed"), &SyntheticSource::get_seed);
	ClassDB::bind_method(D_METHOD("set_duration", "duration"), &SyntheticSource::set_duration);
	ClassDB::bind_method(D_METHOD("get_duration"), &SyntheticSource::get_duration);
	ClassDB::bind_method(D_METHOD("set_pace", "pace"), &SyntheticSource::set_pace);
	ClassDB::bind_method(D_METHOD("get_pace"), &SyntheticSource::get_pace);
	ClassDB::bind_method(D_METHOD("set_loop", "loop"), &SyntheticSource::set_loop);
	ClassDB::bind_method(D_METHOD("get_loop"), &SyntheticSource::get_loop);
	ClassDB::bind_method(D_METHOD("set_true_motion", "true_motion"), &SyntheticSource::set_true_motion);
	ClassDB::bind_method(D_METHOD("is_true_motion"), &SyntheticSource::is_true_motion);
	ClassDB::bind_method(D_METHOD("set_placement", "placement"), &SyntheticSource::set_placement);
	ClassDB::bind_method(D_METHOD("get_placement"), &SyntheticSource::get_placement);
	ClassDB::bind_method(D_METHOD("set_task_path", "path"), &SyntheticSource::set_task_path);
	ClassDB::bind_method(D_METHOD("get_task_path"), &SyntheticSource::get_task_path);
	ClassDB::bind_method(D_METHOD("set_start", "start"), &SyntheticSource::set_start);
	ClassDB::bind_method(D_METHOD("get_start"), &SyntheticSource::get_start);
	ClassDB::bind_method(D_METHOD("set_direction", "direction"), &SyntheticSource::set_direction);
	ClassDB::bind_method(D_METHOD("get_direction"), &SyntheticSource::get_direction);
	ClassDB::bind_method(D_METHOD("set_amplitude", "amplitude"), &SyntheticSource::set_amplitude);
	ClassDB::bind_method(D_METHOD("get_amplitude"), &SyntheticSource::get_amplitude);
	ClassDB::bind_method(D_METHOD("set_start_radius", "start_radius"), &SyntheticSource::set_start_radius);
	ClassDB::bind_method(D_METHOD("get_start_radius"), &SyntheticSource::get_start_radius);
	ClassDB::bind_method(D_METHOD("place_at", "task"), &SyntheticSource::place_at);
	ClassDB::bind_method(D_METHOD("get_trial"), &SyntheticSource::get_trial);

	ADD_PROPERTY(PropertyInfo(Variant::STRING_NAME, "gesture"), "set_gesture", "get_gesture");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "position", PROPERTY_HINT_ENUM, "Stable,Unstable"),
			"set_position", "get_position");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "subject", PROPERTY_HINT_RANGE, "0,100,1,or_greater"),
			"set_subject", "get_subject");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "seed", PROPERTY_HINT_RANGE, "0,1000,1,or_greater"), "set_seed",
			"get_seed");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "duration", PROPERTY_HINT_RANGE, "0,4,0.01,suffix:s"),
			"set_duration", "get_duration");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "pace", PROPERTY_HINT_RANGE, "0.1,10,0.01"), "set_pace", "get_pace");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "loop"), "set_loop", "get_loop");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "true_motion"), "set_true_motion", "is_true_motion");
	ADD_GROUP("Placement", "");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "placement", PROPERTY_HINT_ENUM, "Sensor,Fixed,Task"),
			"set_placement", "get_placement");
	ADD_PROPERTY(
			PropertyInfo(Variant::NODE_PATH, "task_path", PROPERTY_HINT_NODE_PATH_VALID_TYPES, "GestureTask"),
			"set_task_path", "get_task_path");
	ADD_PROPERTY(PropertyInfo(Variant::VECTOR3, "start", PROPERTY_HINT_NONE, "suffix:m"), "set_start",
			"get_start");
	ADD_PROPERTY(PropertyInfo(Variant::VECTOR3, "direction"), "set_direction", "get_direction");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "amplitude", PROPERTY_HINT_RANGE,
						 "0.01,1,0.001,or_greater,suffix:m"),
			"set_amplitude", "get_amplitude");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "start_radius", PROPERTY_HINT_RANGE,
						 "0.001,0.3,0.001,or_greater,suffix:m"),
			"set_start_radius", "get_start_radius");

	BIND_ENUM_CONSTANT(POSITION_STABLE);
	BIND_ENUM_CONSTANT(POSITION_UNSTABLE);
	BIND_ENUM_CONSTANT(PLACEMENT_SENSOR);
	BIND_ENUM_CONSTANT(PLACEMENT_FIXED);
	BIND_ENUM_CONSTANT(PLACEMENT_TASK);
}

} // namespace godot
