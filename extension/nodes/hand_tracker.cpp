#include "hand_tracker.h"

#include "conversions.h"
#include "hand_source.h"
#include "live_clock.h"
#include "node_label.h"
#include "written_file.h"
#include "xr_source.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/xr_server.hpp>
#include <godot_cpp/core/class_db.hpp>

#include <limits>

namespace godot {

HandTracker::HandTracker() = default;

HandTracker::~HandTracker() {
	listeners_.call(&FrameListener::on_tracker_freed);
}

void HandTracker::_notification(int p_what) {
	switch (p_what) {
		case NOTIFICATION_READY:
			if (autostart_ && source_.is_valid() && !Engine::get_singleton()->is_editor_hint()) {
				start();
			}
			break;
		case NOTIFICATION_INTERNAL_PROCESS:
			if (stream_ && stream_->is_polled()) {
				advance_live();
			} else {
				advance(get_process_delta_time());
			}
			break;
		case NOTIFICATION_INTERNAL_PHYSICS_PROCESS:
			if (stream_ && stream_->is_polled()) {
				advance_live();
			} else {
				advance(get_physics_process_delta_time());
			}
			break;
		case NOTIFICATION_PREDELETE:
			stream_.reset(); // while the source's script can still use this node
			break;
		default:
			break;
	}
}

/// Also starts a running scene: a parent's script may set the source after this node's _ready().
void HandTracker::set_source(const Ref<HandSource> &p_source) {
	if (source_ == p_source) {
		return;
	}
	const Callable on_changed = callable_mp(this, &HandTracker::on_source_changed);
	if (source_.is_valid()) {
		source_->disconnect("changed", on_changed);
	}
	const bool was_running = is_running();
	stop();
	source_ = p_source;
	if (source_.is_valid()) {
		source_->connect("changed", on_changed);
	}
	on_source_changed();
	const bool starts_automatically = autostart_ && is_node_ready() && is_inside_tree();
	if (source_.is_valid() && (was_running || starts_automatically) &&
			!Engine::get_singleton()->is_editor_hint()) {
		start_is_due_ = true;
		call_deferred("_start_if_due");
	}
}

Ref<HandSource> HandTracker::get_source() const {
	return source_;
}

void HandTracker::on_source_changed() {
	update_configuration_warnings();
}

void HandTracker::start_if_due() {
	if (start_is_due_) {
		start();
	}
}

Error HandTracker::start() {
	ERR_FAIL_COND_V_MSG(is_part_of_edited_scene(), ERR_UNAVAILABLE,
			node_label(*this) + String(": start() opens no source in a scene that is edited. Run the scene"));
	const Watch watch(listeners_);
	end_run();
	if (watch.is_destroyed()) {
		return ERR_UNAVAILABLE;
	}
	begin_run();
	const uint64_t this_run = run_;
	const std::shared_ptr<HandStream> stream = source_.is_valid() ? source_->make_stream(*this) : nullptr;
	const String fault = stream ? stream->open()
								: String("set \"source\", e.g. to an XRSource, or to a ScriptSource for "
										 "frames that a script pushes");
	if (!is_current(watch, this_run)) {
		return ERR_UNAVAILABLE; // the source's script has restarted or freed this node
	}
	if (!fault.is_empty()) {
		notify(&FrameListener::on_stream_ended);
		if (is_current(watch, this_run)) {
			report_failure(fault);
		}
		return ERR_CANT_OPEN;
	}
	stream_ = stream;
	if (stream->clock() == StreamClock::LIVE) {
		live_s_ = time_s_ = start_time_s_ = hand_seen_s_ = live_time_s(get_process_delta_time());
		clock_set_ = true;
	} else if (stream->clock() == StreamClock::GAME) {
		time_s_ = start_time_s_ = stream->start_s();
		duration_s_ = stream->duration_s();
	}
	update_publisher();
	update_processing();
	notify(&FrameListener::on_stream_started);
	report_events(*stream, watch, this_run);
	return OK;
}

void HandTracker::begin_run() {
	start_is_due_ = false;
	finished_ = false;
	clock_set_ = false;
	reported_refusals_ = 0;
	reported_stream_faults_ = 0;
	has_reported_confidence_ = false;
	reported_frame_faults_ = 0;
	refused_from_s_.reset();
	stream_check_ = {};
	frame_filter_ = {};
	statistics_ = {};
	time_s_ = live_s_ = start_time_s_ = duration_s_ = hand_seen_s_ = 0.0;
}

void HandTracker::stop() {
	const Watch watch(listeners_);
	const bool was_running = is_running();
	const uint64_t ended_run = end_run();
	if (was_running && is_current(watch, ended_run)) {
		notify(&FrameListener::on_stream_ended);
	}
}

/// Does not notify the listeners, because start() does. A handler of tracking_lost may start another run.
uint64_t HandTracker::end_run() {
	const uint64_t ended_run = ++run_;
	start_is_due_ = false;
	stream_.reset();
	publisher_.reset();
	tracked_ = inferred_ = 0;
	update_processing();
	set_hand_present(false);
	return ended_run;
}

bool HandTracker::report_events(HandStream &p_stream, const Watch &p_watch, uint64_t p_run) {
	StreamEvent event;
	while (is_current(p_watch, p_run) && p_stream.next_event(event)) {
		switch (event.kind) {
			case StreamEvent::Kind::READY:
				emit_signal("source_ready");
				break;
			case StreamEvent::Kind::FAILED:
				report_failure(event.text);
				break;
			case StreamEvent::Kind::WARNING:
				WARN_PRINT(node_label(*this) + String(": ") + event.text);
				break;
		}
	}
	return is_current(p_watch, p_run);
}

void HandTracker::report_failure(const String &p_reason) {
	ERR_PRINT(node_label(*this) + String(": ") + p_reason);
	emit_signal("failed", p_reason);
}

void HandTracker::update_processing() {
	const bool is_clocked = stream_ && (stream_->clock() == StreamClock::GAME || stream_->is_polled());
	const bool is_automatic = is_clocked && !finished_;
	set_process_internal(is_automatic && update_mode_ == UPDATE_IDLE);
	set_physics_process_internal(is_automatic && update_mode_ == UPDATE_PHYSICS);
}

void HandTracker::update_publisher() {
	publisher_.reset();
	if (!is_running() || publish_name_ == StringName()) {
		return;
	}
	const auto *const xr_source = Object::cast_to<XRSource>(*source_);
	if (xr_source != nullptr && xr_source->name_of_hand() == publish_name_) {
		ERR_PRINT(node_label(*this) + String(": its XRSource reads the tracker '") + String(publish_name_) +
				String("' too. Set \"publish_name\" to another name"));
	} else if (XRServer::get_singleton()->get_tracker(publish_name_).is_valid()) {
		ERR_PRINT(node_label(*this) + String(": the XRServer has a tracker '") + String(publish_name_) +
				String("' already. Set \"publish_name\" to another name"));
	} else {
		publisher_ = std::make_unique<HandPublisher>(publish_name_, publish_hand_ == HAND_LEFT);
	}
}

double HandTracker::get_reading_rate() const {
	const steadyhand::TrackerMonitor &monitor = statistics_.monitor();
	return monitor.is_period_known() ? 1.0 / monitor.period_s() : 0.0;
}

double HandTracker::get_noise() const {
	const steadyhand::TrackerMonitor &monitor = statistics_.monitor();
	return monitor.is_noise_known() ? monitor.noise_m() : std::numeric_limits<double>::quiet_NaN();
}

double HandTracker::get_latency() const {
	return stream_ ? stream_->latency_s() : std::numeric_limits<double>::quiet_NaN();
}

Vector3 HandTracker::get_joint_position(Joint p_joint) const {
	ERR_FAIL_COND_V_MSG(!is_enumerator(p_joint, JOINT_PINKY), Vector3(),
			refusal(*this, "the joint must be one of JOINT_*", p_joint));
	return positions_m_[static_cast<std::size_t>(p_joint)];
}

bool HandTracker::is_joint_tracked(Joint p_joint) const {
	ERR_FAIL_COND_V_MSG(!is_enumerator(p_joint, JOINT_PINKY), false,
			refusal(*this, "the joint must be one of JOINT_*", p_joint));
	return ((tracked_ >> static_cast<unsigned>(p_joint)) & 1U) != 0;
}

bool HandTracker::is_joint_inferred(Joint p_joint) const {
	ERR_FAIL_COND_V_MSG(!is_enumerator(p_joint, JOINT_PINKY), false,
			refusal(*this, "the joint must be one of JOINT_*", p_joint));
	return ((inferred_ >> static_cast<unsigned>(p_joint)) & 1U) != 0;
}

Error HandTracker::start_recording(const String &p_path) {
	// A mistyped path must not overwrite another file.
	ERR_FAIL_COND_V_MSG(p_path.get_extension().to_lower() != String("csv"), ERR_FILE_BAD_PATH,
			refusal(*this, "start_recording: the path must end with .csv, for example user://hand.csv",
					p_path));
	const bool is_played = stream_ && is_same_file(p_path, stream_->played_file());
	const bool will_be_played = source_.is_valid() && is_same_file(p_path, source_->played_file());
	ERR_FAIL_COND_V_MSG(is_played || will_be_played, ERR_FILE_ALREADY_IN_USE,
			node_label(*this) + String(": it plays ") + p_path + String(". Record to another file"));
	if (const Error error = WrittenFile::check_free(*this, p_path); error != OK) {
		return error;
	}
	if (recorder_ && is_same_file(p_path, recorder_->path())) {
		stop_recording();
	}
	auto opened = std::make_unique<TrackRecorder>();
	const Error error = opened->open(*this, p_path);
	if (error == OK) {
		recorder_ = std::move(opened);
	}
	return error;
}

void HandTracker::stop_recording() {
	recorder_.reset();
}

} // namespace godot
