#pragma once

#include "frame_listener.h"
#include "gesture_model.h"
#include "listener_list.h"
#include "motion_listener.h"
#include "read_only_copy.h"

#include "gesture/task.h"
#include "gesture/task_watch.h"
#include "motion/motion.h"
#include "recognition/gesture_changes.h"
#include "recognition/start_condition.h"

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/core/object_id.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace godot {

class GestureTask;
class HandTracker;

/// Recognises the gesture of a HandTracker's hand and outputs its motion at control instants, 1 ms apart on
/// the frames' clock. The output at an instant depends only on frames with stamps up to that instant.
class GestureHMM : public Node, public FrameListener {
	GDCLASS(GestureHMM, Node)

public:
	/// In the order of the core's MotionMode.
	enum Mode : int64_t { MODE_PHASE, MODE_PAPER };
	/// In the order of the core's Quality.
	enum Quality : int64_t { QUALITY_FAST, QUALITY_BALANCED, QUALITY_ACCURATE };
	/// In the order of the core's MotionSource.
	enum Motion : int64_t {
		MOTION_SYNTHESISED,
		MOTION_MEASURED,
		MOTION_AVERAGE,
		MOTION_ONE_EURO,
		MOTION_KALMAN
	};
	/// In the order of the core's StartKind.
	enum StartCondition : int64_t { START_NONE, START_DWELL, START_PINCH, START_POINTING_POSE };

	GestureHMM();
	~GestureHMM() override;

	void set_tracker(HandTracker *p_tracker);
	HandTracker *get_tracker() const { return tracker_; }
	void set_tasks(const TypedArray<GestureTask> &p_tasks);
	/// A read-only copy.
	TypedArray<GestureTask> get_tasks() const;
	/// Sets one task, or none.
	void set_task(GestureTask *p_task);
	/// The first task, or null.
	GestureTask *get_task() const { return tasks_.is_empty() ? nullptr : task_at(0); }
	void set_models(const TypedArray<GestureModel> &p_models);
	/// A read-only copy.
	TypedArray<GestureModel> get_models() const { return read_only_copy(models_); }
	void set_mode(Mode p_mode);
	Mode get_mode() const { return mode_; }
	void set_quality(Quality p_quality);
	Quality get_quality() const { return quality_; }
	void set_motion(Motion p_motion);
	Motion get_motion() const { return motion_; }
	void set_sensor_latency(double p_latency_s);
	double get_sensor_latency() const { return sensor_latency_s_; }
	void set_min_confidence(double p_confidence);
	double get_min_confidence() const { return min_confidence_; }
	void set_completion(double p_fraction);
	double get_completion() const { return completion_; }
	void set_start_condition(StartCondition p_condition);
	StartCondition get_start_condition() const { return static_cast<StartCondition>(start_.kind); }
	void set_dwell_time(double p_time_s);
	double get_dwell_time() const { return start_.dwell_s; }
	void set_pinch_distance(double p_distance_m);
	double get_pinch_distance() const { return start_.pinch_m; }

	double get_value() const;
	/// Prediction for p_time_s.
	double get_value_at(double p_time_s) const;
	double get_velocity() const;
	double get_acceleration() const;
	double get_progress() const;
	StringName get_gesture() const { return gesture_name(shown_.gesture); }
	/// Task of the active gesture; null without an active gesture or without a task.
	GestureTask *get_current_task() const;
	int get_state() const { return shown_.state; }
	double get_confidence() const;
	double get_time() const { return time_s_; }
	StringName get_recognised() const { return recognised_; }

	void reset();
	double get_motion_value(Motion p_motion) const;

	/// Prediction for p_time_s, which is not before get_time().
	MotionInstant motion_at(double p_time_s) const;

	void add_listener(MotionListener *p_listener) { listeners_.add(p_listener); }
	void remove_listener(MotionListener *p_listener) { listeners_.remove(p_listener); }

	void on_stream_started() override;
	void on_stream_ended() override;
	void on_frame(const steadyhand::HandFrame &p_frame) override;
	void on_time_advanced(double p_time_s) override;
	void on_tracker_freed() override;

	PackedStringArray _get_configuration_warnings() const override;

protected:
	static void _bind_methods();
	void _notification(int p_what);

private:
	struct SignalNames {
		StringName gesture_started = "gesture_started";
		StringName state_changed = "state_changed";
		StringName gesture_ended = "gesture_ended";
		StringName gesture_aborted = "gesture_aborted";
		StringName motion_updated = "motion_updated";
	};
	/// A model, and the task at which it is evaluated.
	struct Expected {
		std::shared_ptr<const steadyhand::GestureModel> model;
		StringName gesture;
		ObjectID task; ///< GestureTask; none without a task
		std::optional<steadyhand::Task> place;

		bool operator==(const Expected &p_other) const = default;
	};

	HandTracker *tracker_ = nullptr;
	bool follows_parent_ = false; ///< tracker_ is the parent, because none was set
	TypedArray<GestureTask> tasks_;
	TypedArray<GestureModel> models_;
	Mode mode_ = MODE_PHASE;
	Quality quality_ = QUALITY_BALANCED;
	Motion motion_ = MOTION_SYNTHESISED;
	/// The default is the low end of hand trackers' latencies, 10 to 30 ms. A value above the real latency
	/// makes ends early.
	double sensor_latency_s_ = steadyhand::USUAL_SENSOR_LATENCY_S;
	double min_confidence_ = 0.0;
	double completion_ = steadyhand::END_LEVEL;
	steadyhand::StartSettings start_;

	SignalNames names_;
	ListenerList<MotionListener> listeners_;
	std::unique_ptr<steadyhand::GestureRecogniser> recogniser_;
	std::vector<Expected> expected_; ///< the recogniser's gestures, in its order
	/// Settings have changed: the recogniser is rebuilt before the next frame, never inside a signal.
	bool outdated_ = true;
	/// Models or tasks have changed inside a signal: the recogniser gets them after this instant.
	bool expected_changed_ = false;
	int emitting_ = 0;   ///< depth of nested publish() calls: a handler may push the next frame
	uint64_t build_ = 0; ///< incremented with each change of recogniser_ or its gestures
	uint64_t stream_ = 0;
	int64_t next_instant_ = 0; ///< in control periods on the frames' clock
	double time_s_ = 0.0;
	steadyhand::ShownGesture shown_; ///< at the last control instant, index into expected_
	StringName recognised_;
	/// Signals of this instant's gesture that are not emitted yet.
	bool is_start_unreported_ = false, is_end_unreported_ = false;
	int reported_state_ = -1; ///< in the last state_changed
	uint32_t gestures_started_ = 0;
	String warned_;
	int task_changes_ = 0;                        ///< since the last end of a gesture
	int long_gaps_ = 0;                           ///< gaps above LONGEST_GAP_S in a row
	int frames_with_hand_ = 0;                    ///< since expected_ or start_ changed
	uint8_t joints_seen_ = 0, joints_warned_ = 0; ///< joint_bits(): in any frame; warned of as missing
	steadyhand::TaskWatch task_watch_;
	std::vector<ObjectID> watched_tasks_; ///< tasks of task_watch_
	bool has_frame_ = false;              ///< from this tracker
	bool has_warned_of_no_hand_ = false;  ///< the warning was printed
	double waited_s_ = 0.0;               ///< time without a hand of this tracker

	/// A signal handler may free this node with its scene.
	using Watch = ListenerList<MotionListener>::Watch;

	/// False if a handler has freed this node or changed the stream; as run_clock().
	[[nodiscard]] bool prepare(double p_time_s);
	static bool is_usable(const Ref<GestureModel> &p_model);
	static steadyhand::Task core_task(const GestureTask &p_task, const steadyhand::GestureModel &p_model);
	/// The usable models, without tasks.
	std::vector<Expected> find_usable() const;
	/// The usable models at their tasks.
	std::vector<Expected> find_expected() const;
	/// The same, but tasks that have hardly moved keep their place in expected_.
	std::vector<Expected> find_new_expected() const;
	static std::vector<steadyhand::ExpectedGesture> core_of(const std::vector<Expected> &p_expected);
	/// Whether expected_ already has this task with its present properties.
	bool is_as_expected(const GestureTask &p_task) const;
	bool is_task_freed() const;
	void build_recogniser();
	void update_expected();
	/// Ends the motion and its gesture. The next frame starts another one. A handler may free this node.
	void end_motion();
	/// Ends the shown gesture and emits the signals of this. A handler may free this node.
	void abort_shown(const StringName &p_gesture, GestureTask *p_task);
	void warn_of_settings();
	void follow_parent();
	void watch_tracker(double p_passed_s);
	void restart_tracker_watch();
	void watch_joints(uint8_t p_tracked);
	void warn_of_missing_joints(const String &p_what, uint8_t p_needed);
	void restart_task_watch();
	void watch_tasks(const steadyhand::HandFrame &p_frame);
	/// How to correct a task at which no model's motion can be measured; empty if it can.
	String place_fault(const GestureTask &p_task) const;
	/// Warning about a gesture without a task that needs one, or has no HMMs; empty if there is none.
	String taskless_fault() const;
	/// Warning about START_PINCH with a gesture that opens the fingers; empty if there is none.
	String start_fault() const;
	[[nodiscard]] bool run_clock(double p_time_s, bool p_up_to_and_including);
	void publish();
	/// At p_time_s, or now if that is later.
	steadyhand::Motion current(
			Motion p_motion, double p_time_s = -std::numeric_limits<double>::infinity()) const;
	double amplitude_m() const;
	/// Value of the active gesture, in amplitudes.
	/// Null if there is none, or it was freed.
	GestureTask *task_at(int64_t p_index) const;
	bool has_model_of(const StringName &p_gesture) const;
	StringName gesture_name(int p_expected) const;
	/// Null if there is none, or it was freed.
	GestureTask *task_of(int p_expected) const;
	void on_settings_changed();
	void on_start_changed();
	void on_expected_changed();
	void on_task_changed(uint64_t p_task);
	void connect_tasks(bool p_connect);
	void connect_changed(Object *p_object, const Callable &p_callable, bool p_connect);
};

} // namespace godot

VARIANT_ENUM_CAST(godot::GestureHMM::Mode);
VARIANT_ENUM_CAST(godot::GestureHMM::Quality);
VARIANT_ENUM_CAST(godot::GestureHMM::Motion);
VARIANT_ENUM_CAST(godot::GestureHMM::StartCondition);
