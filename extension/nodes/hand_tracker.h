#pragma once

#include "frame_listener.h"
#include "listener_list.h"
#include "track_playback.h"
#include "track_recorder.h"

#include "base/result.h"
#include "tracking/stream_doubts.h"

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/dictionary.hpp>

#include <array>
#include <atomic>
#include <memory>
#include <optional>

namespace godot {

/// Hand frames from one source, in the order and with the stamps that the source gave them. Positions are
/// published in the tracker's own space, as the source has them: the node's transform is not applied.
class HandTracker : public Node3D {
	GDCLASS(HandTracker, Node3D)

public:
	enum Source { SOURCE_SCRIPT, SOURCE_RECORDED, SOURCE_SYNTHETIC };
	enum UpdateMode { UPDATE_IDLE, UPDATE_PHYSICS, UPDATE_MANUAL };
	enum Joint { JOINT_THUMB, JOINT_INDEX, JOINT_MIDDLE, JOINT_RING, JOINT_PINKY, JOINT_PALM, JOINT_WRIST };
	enum SyntheticPosition { POSITION_STABLE, POSITION_UNSTABLE };

	HandTracker();
	~HandTracker() override;

	void set_source(Source p_source);
	Source get_source() const { return source_; }
	void set_update_mode(UpdateMode p_mode);
	UpdateMode get_update_mode() const { return update_mode_; }
	void set_autostart(bool p_autostart) { autostart_ = p_autostart; }
	bool get_autostart() const { return autostart_; }
	void set_recording_path(const String &p_path);
	String get_recording_path() const { return recording_path_; }
	void set_loop(bool p_loop) { loop_ = p_loop; }
	bool get_loop() const { return loop_; }
	void set_synthetic_gesture(const String &p_gesture) { synthetic_gesture_ = p_gesture; }
	String get_synthetic_gesture() const { return synthetic_gesture_; }
	void set_synthetic_position(SyntheticPosition p_position);
	SyntheticPosition get_synthetic_position() const { return synthetic_position_; }
	void set_synthetic_seed(int64_t p_seed) { synthetic_seed_ = p_seed; }
	int64_t get_synthetic_seed() const { return synthetic_seed_; }
	void set_synthetic_subject(int64_t p_subject);
	int64_t get_synthetic_subject() const { return synthetic_subject_; }

	Error start();
	void stop();
	bool is_running() const { return running_; }
	bool is_finished() const { return finished_; }
	double get_time() const { return time_s_; }
	double get_start_time() const { return start_time_s_; }
	double get_duration() const { return duration_s_; }
	Dictionary get_synthetic_trial() const { return synthetic_trial_; }

	void advance(double p_seconds);
	void advance_to(double p_time_s);
	Error push_frame(double p_time_s, const Dictionary &p_joints, double p_confidence);

	Vector3 get_joint_position(Joint p_joint) const;
	bool is_joint_tracked(Joint p_joint) const;

	Error start_recording(const String &p_path);
	void stop_recording();

	void add_listener(FrameListener *p_listener) { listeners_.add(p_listener); }
	void remove_listener(FrameListener *p_listener) { listeners_.remove(p_listener); }

	PackedStringArray _get_configuration_warnings() const override;

protected:
	static void _bind_methods();
	void _notification(int p_what);
	void _validate_property(PropertyInfo &p_property) const;

private:
	/// Of a pushed frame; each is explained once a run.
	enum class Refusal : uint8_t {
		OTHER_SOURCE,
		NOT_RUNNING,
		NO_TIME,
		OLDER,
		UNKNOWN_JOINT,
		NO_JOINTS,
		OTHER_THREAD
	};
	/// Names that each frame needs: making one takes a lock.
	struct SignalNames {
		StringName frame_received = "frame_received";
		StringName tracking_found = "tracking_found";
		StringName tracking_lost = "tracking_lost";
	};

	Source source_ = SOURCE_SCRIPT;
	UpdateMode update_mode_ = UPDATE_IDLE;
	bool autostart_ = true;
	String recording_path_;
	bool loop_ = false;
	String synthetic_gesture_ = "horizontal_drag";
	SyntheticPosition synthetic_position_ = POSITION_STABLE;
	int64_t synthetic_seed_ = 0;
	int64_t synthetic_subject_ = 0;

	SignalNames names_;
	ListenerList<FrameListener> listeners_;
	std::optional<TrackPlayback> playback_;
	String played_path_;
	std::unique_ptr<TrackRecorder> recorder_;
	Dictionary synthetic_trial_;
	bool running_ = false;
	bool finished_ = false;
	bool clock_set_ = false; ///< a pushed stream starts with its first frame
	double time_s_ = 0.0;
	double start_time_s_ = 0.0;
	double duration_s_ = 0.0;
	/// Of the run: start() and stop() out of a signal end the loop that delivers frames.
	uint64_t run_ = 0;

	uint8_t tracked_ = 0;                                      ///< bit i: joint i in the last frame
	std::array<Vector3, steadyhand::JOINT_COUNT> positions_m_; ///< last seen ones
	bool hand_present_ = false;
	double hand_seen_s_ = 0.0;
	std::optional<double> refused_from_s_; ///< the first stamp of those refused as older since the last frame
	/// Bit i: of a pushed frame, by Refusal i, in this run; threads that may not push are told by it too.
	std::atomic<uint8_t> complained_ = 0;
	steadyhand::StreamDoubts doubts_;
	uint8_t doubted_ = 0; ///< bit i: StreamDoubt i has been told in this run

	/// What is told of a frame may free this node.
	using Watch = ListenerList<FrameListener>::Watch;
	/// Neither freed nor stopped since.
	bool goes_on(const Watch &p_watch, uint64_t p_run) const { return !p_watch.is_gone() && run_ == p_run; }

	/// The number that there is of none that runs.
	uint64_t end_run();
	steadyhand::Result<std::vector<steadyhand::HandFrame>> load_frames();
	Error refuse_older(double p_time_s);
	Error refuse_frame(Refusal p_refusal, const String &p_reason);
	void doubt(const steadyhand::HandFrame &p_frame);
	void deliver(const steadyhand::HandFrame &p_frame);
	/// The listeners; what is of this run is none's any more once one of them has begun another.
	template <class... Arguments, class... Values>
	void tell(void (FrameListener::*p_method)(Arguments...), const Values &...p_values) {
		const uint64_t this_run = run_;
		listeners_.call_while([&] { return run_ == this_run; }, p_method, p_values...);
	}
	void tell_time(double p_time_s);
	void set_hand_present(bool p_present);
	void update_processing();
};

} // namespace godot

VARIANT_ENUM_CAST(godot::HandTracker::Source);
VARIANT_ENUM_CAST(godot::HandTracker::UpdateMode);
VARIANT_ENUM_CAST(godot::HandTracker::Joint);
VARIANT_ENUM_CAST(godot::HandTracker::SyntheticPosition);
