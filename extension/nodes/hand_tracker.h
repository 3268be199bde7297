#pragma once

#include "frame_listener.h"
#include "hand_publisher.h"
#include "listener_list.h"
#include "track_recorder.h"

#include "tracking/frame_filter.h"
#include "tracking/stream_check.h"
#include "tracking/stream_statistics.h"

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/dictionary.hpp>

#include <array>
#include <atomic>
#include <memory>
#include <optional>

namespace godot {

class HandSource; // includes this header: its virtual methods take the tracker
class HandStream;

/// Hand frames from one source, with the source's order and stamps. Positions are in the source's space: the
/// node's transform is not applied.
class HandTracker : public Node3D {
	GDCLASS(HandTracker, Node3D)

public:
	enum UpdateMode : int64_t { UPDATE_IDLE, UPDATE_PHYSICS, UPDATE_MANUAL };
	/// The numbers are those of XRHandTracker.HandJoint.
	enum Joint : int64_t {
		JOINT_PALM = 0,
		JOINT_WRIST = 1,
		JOINT_THUMB = 5,
		JOINT_INDEX = 10,
		JOINT_MIDDLE = 15,
		JOINT_RING = 20,
		JOINT_PINKY = 25
	};
	enum Hand : int64_t { HAND_LEFT, HAND_RIGHT };

	HandTracker();
	~HandTracker() override;

	void set_source(const Ref<HandSource> &p_source);
	Ref<HandSource> get_source() const;
	void set_update_mode(UpdateMode p_mode);
	UpdateMode get_update_mode() const { return update_mode_; }
	void set_autostart(bool p_autostart) { autostart_ = p_autostart; }
	bool get_autostart() const { return autostart_; }
	void set_publish_name(const StringName &p_name);
	StringName get_publish_name() const { return publish_name_; }
	void set_publish_hand(Hand p_hand);
	Hand get_publish_hand() const { return publish_hand_; }

	Error start();
	void stop();
	bool is_running() const { return stream_ != nullptr; }
	bool is_finished() const { return finished_; }
	bool is_hand_tracked() const { return hand_present_; }
	double get_time() const { return time_s_; }
	double get_start_time() const { return start_time_s_; }
	double get_duration() const { return duration_s_; }
	double get_frame_rate() const { return statistics_.rate_hz(); }
	double get_frame_jitter() const { return statistics_.jitter_s(); }
	double get_reading_rate() const;
	double get_noise() const;
	int64_t get_dropout_count() const { return static_cast<int64_t>(faults().dropouts); }
	int64_t get_freeze_count() const { return static_cast<int64_t>(faults().freezes); }
	int64_t get_jump_count() const { return static_cast<int64_t>(faults().jumps); }
	double get_latency() const;

	void advance(double p_seconds);
	void advance_to(double p_time_s);
	Error push_frame(double p_time_s, const Dictionary &p_joints, double p_confidence);
	void report_failure(const String &p_reason);

	Vector3 get_joint_position(Joint p_joint) const;
	bool is_joint_tracked(Joint p_joint) const;
	bool is_joint_inferred(Joint p_joint) const;

	Error start_recording(const String &p_path);
	void stop_recording();

	void add_listener(FrameListener *p_listener) { listeners_.add(p_listener); }
	void remove_listener(FrameListener *p_listener) { listeners_.remove(p_listener); }

	PackedStringArray _get_configuration_warnings() const override;

protected:
	static void _bind_methods();
	void _notification(int p_what);

private:
	/// Reason for which a pushed frame is refused. Each is reported once per run.
	enum class Refusal : uint8_t {
		OTHER_SOURCE,
		NOT_RUNNING,
		NO_TIME,
		OLDER,
		UNKNOWN_JOINT,
		NO_JOINTS,
		NO_PLACE,
		OTHER_THREAD
	};
	/// A hand is lost after empty frames for this time, s. Shorter dropouts are frequent (MRTK #10391).
	static constexpr double LOST_AFTER_S = 0.1;
	/// A hand is lost after this time without frames, s. Slow trackers send 5 to 10 frames a second.
	static constexpr double NO_FRAME_AFTER_S = 0.25;
	/// A signal handler may advance the tracker, but not in an endless recursion.
	static constexpr int DEEPEST_ADVANCE = 8;

	/// Kept, because each frame needs them and making a StringName takes a lock.
	struct SignalNames {
		StringName frame_received = "frame_received";
		StringName tracking_restored = "tracking_restored";
		StringName tracking_lost = "tracking_lost";
	};

	Ref<HandSource> source_;
	UpdateMode update_mode_ = UPDATE_IDLE;
	bool autostart_ = true;
	StringName publish_name_;
	Hand publish_hand_ = HAND_RIGHT;

	SignalNames names_;
	ListenerList<FrameListener> listeners_;
	std::shared_ptr<HandStream> stream_; ///< null while stopped; shared with the loops that use it
	bool start_is_due_ = false;          ///< start() follows at the end of this game frame
	std::unique_ptr<TrackRecorder> recorder_;
	std::unique_ptr<HandPublisher> publisher_;
	bool finished_ = false;
	bool clock_set_ = false; ///< false until the first frame of a pushed stream
	double time_s_ = 0.0;
	double live_s_ = 0.0; ///< live_time_s() of the last poll; in UPDATE_MANUAL advanced by advance()
	double start_time_s_ = 0.0;
	double duration_s_ = 0.0;
	/// Number of the run. A change ends the loops that deliver frames: a handler may call start() or stop().
	uint64_t run_ = 0;

	uint32_t tracked_ = 0;                                              ///< bit i: joint i in the last frame
	uint32_t inferred_ = 0;                                             ///< as tracked_
	std::array<Vector3, steadyhand::SKELETON_JOINT_COUNT> positions_m_; ///< last tracked positions
	bool hand_present_ = false;
	double hand_seen_s_ = 0.0;
	int advancing_ = 0;                    ///< depth of nested advance_to() calls
	std::optional<double> refused_from_s_; ///< earliest stamp refused as older since the last frame
	/// Bit i: Refusal i was reported in this run. Atomic, because other threads may call push_frame().
	std::atomic<uint8_t> reported_refusals_ = 0;
	steadyhand::FrameFilter frame_filter_;
	uint8_t reported_frame_faults_ = 0; ///< bit i: FrameFault i was reported in this run
	steadyhand::StreamStatistics statistics_;
	steadyhand::StreamCheck stream_check_;
	uint8_t reported_stream_faults_ = 0;   ///< bit i: StreamFault i was reported in this run
	bool has_reported_confidence_ = false; ///< in this run

	/// A signal handler may free this node.
	using Watch = ListenerList<FrameListener>::Watch;
	/// Whether this node still exists and the run is the same.
	bool is_current(const Watch &p_watch, uint64_t p_run) const {
		return !p_watch.is_destroyed() && run_ == p_run;
	}

	const steadyhand::TrackerFaults &faults() const { return statistics_.monitor().faults(); }
	void start_if_due();
	/// Returns the new value of run_.
	uint64_t end_run();
	void begin_run();
	/// False if a handler ended this run.
	bool report_events(HandStream &p_stream, const Watch &p_watch, uint64_t p_run);
	void advance_live();
	void advance_stream(double p_time_s, const Watch &p_watch);
	void deliver_until(double p_time_s);
	Error refuse_older(double p_time_s);
	Error refuse_frame(Refusal p_refusal, const String &p_reason);
	Error read_joints(const Dictionary &p_joints, steadyhand::DeviceFrame &r_frame);
	double limit_confidence(double p_confidence);
	void check_stream(const steadyhand::HandFrame &p_frame);
	void warn_of_frame_faults(uint8_t p_faults);
	void deliver(steadyhand::DeviceFrame p_frame);
	void keep_joints(const steadyhand::DeviceFrame &p_frame);
	/// Calls the listeners, until one of them starts another run.
	template <class... Arguments, class... Values>
	void notify(void (FrameListener::*p_method)(Arguments...), const Values &...p_values) {
		const uint64_t this_run = run_;
		listeners_.call_while([&] { return run_ == this_run; }, p_method, p_values...);
	}
	void report_time(double p_time_s);
	void set_hand_present(bool p_present);
	void update_processing();
	void update_publisher();
	void on_source_changed();
};

} // namespace godot

VARIANT_ENUM_CAST(godot::HandTracker::UpdateMode);
VARIANT_ENUM_CAST(godot::HandTracker::Joint);
VARIANT_ENUM_CAST(godot::HandTracker::Hand);
