#pragma once

#include "hand_source.h"

#include "base/result.h"
#include "simulation/synthetic_trial.h"

#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/node_path.hpp>

namespace godot {

class GestureTask;

/// A simulated person makes one gesture in front of a simulated tracker, at a position relative to the sensor
/// or at a chosen place.
class SyntheticSource : public HandSource {
	GDCLASS(SyntheticSource, HandSource)

public:
	enum Position : int64_t { POSITION_STABLE, POSITION_UNSTABLE };
	enum Placement : int64_t { PLACEMENT_SENSOR, PLACEMENT_FIXED, PLACEMENT_TASK };

	void set_gesture(const StringName &p_gesture);
	StringName get_gesture() const { return gesture_; }
	void set_position(Position p_position);
	Position get_position() const { return position_; }
	void set_subject(int64_t p_subject);
	int64_t get_subject() const { return subject_; }
	void set_seed(int64_t p_seed);
	int64_t get_seed() const { return seed_; }
	void set_duration(double p_duration_s);
	double get_duration() const { return duration_s_; }
	void set_pace(double p_pace);
	double get_pace() const { return pace_; }
	void set_loop(bool p_loop);
	bool get_loop() const { return loop_; }
	void set_true_motion(bool p_true_motion);
	bool is_true_motion() const { return true_motion_; }
	void set_placement(Placement p_placement);
	Placement get_placement() const { return placement_; }
	void set_task_path(const NodePath &p_path);
	NodePath get_task_path() const { return task_path_; }
	void set_start(const Vector3 &p_start_m);
	Vector3 get_start() const { return start_m_; }
	void set_direction(const Vector3 &p_direction);
	Vector3 get_direction() const { return direction_; }
	void set_amplitude(double p_amplitude_m);
	double get_amplitude() const { return amplitude_m_; }
	void set_start_radius(double p_radius_m);
	double get_start_radius() const { return start_radius_m_; }

	void place_at(GestureTask *p_task);
	/// The simulated trial, in the form of TrialSet.get_trial(); empty if it is not known yet.
	Dictionary get_trial() const;
	/// p_tracker: node from which task_path is resolved; null for no task.
	steadyhand::Result<steadyhand::SyntheticTrial> make_trial(const HandTracker *p_tracker) const;

	std::unique_ptr<HandStream> make_stream(HandTracker &p_tracker) override;
	PackedStringArray get_warnings() const override;
	String no_frame_advice() const override;
	bool is_script() const override { return false; }

protected:
	static void _bind_methods();
	void _validate_property(PropertyInfo &p_property) const;

private:
	StringName gesture_ = "horizontal_drag";
	Position position_ = POSITION_STABLE;
	int64_t subject_ = 0;
	int64_t seed_ = 0;
	double duration_s_ = 0.0; ///< 0: the person's own duration
	double pace_ = 1.0;
	bool loop_ = false;
	bool true_motion_ = false;
	Placement placement_ = PLACEMENT_SENSOR;
	NodePath task_path_;
	Vector3 start_m_;
	Vector3 direction_ = Vector3(1, 0, 0);
	double amplitude_m_ = 0.2;
	double start_radius_m_ = 0.03;

	void set_place_of(const GestureTask &p_task, steadyhand::SyntheticTrialRequest &r_request) const;
};

} // namespace godot

VARIANT_ENUM_CAST(godot::SyntheticSource::Position);
VARIANT_ENUM_CAST(godot::SyntheticSource::Placement);
