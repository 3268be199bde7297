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

/// Hand frames from one source, in the order and with the stamps that the source gives them. Positions are
/// published in the source's space: the node's transform is not applied.
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
	/// Of a pushed frame; each is explained once a run.
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
	/// A hand whose frames are empty for this long is lost, s: shorter dropouts come and go (MRTK #10391).
	static constexpr double LOST_AFTER_S = 0.1;
	/// Without any frame, a hand is lost after this, s: slow trackers send 5 to 10 a second.
	static constexpr double SILENT_AFTER_S = 0.25;
	/// A handler may advance the tracker that told it; not without end.
	static constexpr int DEEPEST_ADVANCE = 8;

	/// Names that each frame needs: making one takes a lock.
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
	std::shared_ptr<HandStream> stream_; ///< null while it is stopped; shared with the loops that use it
	bool start_is_due_ = false;          ///< at the end of this frame of the game
	std::unique_ptr<TrackRecorder> recorder_;
	std::unique_ptr<HandPublisher> publisher_;
	bool finished_ = false;
	bool clock_set_ = false; ///< a pushed stream starts with its first frame
	double time_s_ = 0.0;
	double live_s_ = 0.0; ///< live_time_s() of the last poll; in UPDATE_MANUAL moved on by advance()
	double start_time_s_ = 0.0;
	double duration_s_ = 0.0;
	/// Of the run: start() and stop() out of a signal end the loop that delivers frames.
	uint64_t run_ = 0;

	uint32_t tracked_ = 0;                                              ///< bit i: joint i in the last frame
	uint32_t inferred_ = 0;                                             ///< the same
	std::array<Vector3, steadyhand::SKELETON_JOINT_COUNT> positions_m_; ///< last seen ones
	bool hand_present_ = false;
	double hand_seen_s_ = 0.0;
	int advancing_ = 0;                    ///< advance_to() that are under way, one in a handler of the other
	std::optional<double> refused_from_s_; ///< the first stamp of those refused as older since the last frame
	/// Bit i: of a pushed frame, by Refusal i, in this run; threads that may not push are told by it too.
	std::atomic<uint8_t> complained_ = 0;
	steadyhand::FrameFilter door_;
	uint8_t door_faults_ = 0; ///< bit i: FrameFault i has been told in this run
	steadyhand::StreamStatistics statistics_;
	steadyhand::StreamCheck doubts_;
	uint8_t doubted_ = 0; ///< bit i: StreamFault i has been told in this run

	/// What is told of a frame may free this node.
	using Watch = ListenerList<FrameListener>::Watch;
	/// Neither freed nor stopped since.
	bool goes_on(const Watch &p_watch, uint64_t p_run) const { return !p_watch.is_gone() && run_ == p_run; }

	const steadyhand::TrackerFaults &faults() const { return statistics_.monitor().faults(); }
	void start_if_due();
	/// The number that there is of none that runs.
	uint64_t end_run();
	void begin_run();
	/// False where a handler of the signals ended this run.
	bool tell_events(HandStream &p_stream, const Watch &p_watch, uint64_t p_run);
	void tell_failure(const String &p_reason);
	void advance_live();
	void advance_stream(double p_time_s, const Watch &p_watch);
	void deliver_until(double p_time_s);
	Error refuse_older(double p_time_s);
	Error refuse_frame(Refusal p_refusal, const String &p_reason);
	Error read_joints(const Dictionary &p_joints, steadyhand::DeviceFrame &r_frame);
	void doubt(const steadyhand::HandFrame &p_frame);
	void tell_door_faults(uint8_t p_faults);
	void deliver(steadyhand::DeviceFrame p_frame);
	void keep_joints(const steadyhand::DeviceFrame &p_frame);
	/// The listeners; what is of this run is none's any more once one of them has begun another.
	template <class... Arguments, class... Values>
	void tell(void (FrameListener::*p_method)(Arguments...), const Values &...p_values) {
		const uint64_t this_run = run_;
		listeners_.call_while([&] { return run_ == this_run; }, p_method, p_values...);
	}
	void tell_time(double p_time_s);
	void set_hand_present(bool p_present);
	void update_processing();
	void update_publisher();
	void on_source_changed();
};

} // namespace godot

VARIANT_ENUM_CAST(godot::HandTracker::UpdateMode);
VARIANT_ENUM_CAST(godot::HandTracker::Joint);
VARIANT_ENUM_CAST(godot::HandTracker::Hand);
