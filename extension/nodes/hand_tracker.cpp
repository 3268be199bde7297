#include "hand_tracker.h"

#include "conversions.h"
#include "node_label.h"
#include "track_file.h"
#include "trial_dictionary.h"
#include "written_file.h"

#include "simulation/synthetic_trial.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/core/class_db.hpp>

namespace godot {

HandTracker::HandTracker() = default;

HandTracker::~HandTracker() {
	listeners_.call(&FrameListener::on_tracker_freed);
}

void HandTracker::_notification(int p_what) {
	switch (p_what) {
		case NOTIFICATION_READY:
			if (autostart_ && !Engine::get_singleton()->is_editor_hint()) {
				start();
			}
			break;
		case NOTIFICATION_INTERNAL_PROCESS:
			advance(get_process_delta_time());
			break;
		case NOTIFICATION_INTERNAL_PHYSICS_PROCESS:
			advance(get_physics_process_delta_time());
			break;
		default:
			break;
	}
}

Error HandTracker::start() {
	ERR_FAIL_COND_V_MSG(Engine::get_singleton()->is_editor_hint(), ERR_UNAVAILABLE,
			"HandTracker: nothing is opened inside the editor; run the scene");
	const Watch watch(listeners_);
	end_run();
	if (watch.is_gone()) {
		return ERR_UNAVAILABLE;
	}
	playback_.reset();
	played_path_ = String();
	synthetic_trial_ = Dictionary();
	finished_ = false;
	clock_set_ = false;
	complained_ = 0;
	doubted_ = 0;
	refused_from_s_.reset();
	doubts_ = {};
	time_s_ = start_time_s_ = duration_s_ = 0.0;
	if (source_ != SOURCE_SCRIPT) {
		steadyhand::Result<std::vector<steadyhand::HandFrame>> frames = load_frames();
		if (!frames) {
			const String message = to_godot(frames.error());
			ERR_PRINT(node_label(*this) + String(": ") + message);
			const uint64_t no_run = run_;
			tell(&FrameListener::on_stream_ended);
			if (goes_on(watch, no_run)) {
				emit_signal("source_unavailable", message);
			}
			return ERR_CANT_OPEN;
		}
		playback_.emplace(std::move(frames).value(), loop_);
		played_path_ = source_ == SOURCE_RECORDED ? recording_path_ : String();
		time_s_ = start_time_s_ = playback_->start_s();
		duration_s_ = playback_->duration_s();
	}
	running_ = true;
	update_processing();
	const uint64_t this_run = run_;
	tell(&FrameListener::on_stream_started);
	if (goes_on(watch, this_run)) {
		emit_signal("source_ready");
	}
	return OK;
}

void HandTracker::stop() {
	const Watch watch(listeners_);
	const bool was_running = running_;
	const uint64_t ended_run = end_run();
	if (was_running && goes_on(watch, ended_run)) {
		tell(&FrameListener::on_stream_ended);
	}
}

/// Listeners are not told: a start tells them all the same. Who is told that the hand is lost may begin
/// another.
uint64_t HandTracker::end_run() {
	const uint64_t ended_run = ++run_;
	running_ = false;
	tracked_ = 0;
	update_processing();
	set_hand_present(false);
	return ended_run;
}

steadyhand::Result<std::vector<steadyhand::HandFrame>> HandTracker::load_frames() {
	if (source_ == SOURCE_RECORDED) {
		if (recording_path_.is_empty()) {
			return steadyhand::Error{ "set recording_path to a track CSV" };
		}
		steadyhand::Result<steadyhand::Track> track = read_track_file(recording_path_);
		if (!track) {
			return steadyhand::Error{ track.error() };
		}
		if (track.value().frames.empty()) {
			return steadyhand::Error{ to_core(recording_path_) + ": this track has no frames" };
		}
		return std::move(track.value().frames);
	}
	steadyhand::SyntheticTrialRequest request;
	request.name = "synthetic";
	request.gesture = to_core(synthetic_gesture_);
	request.position = synthetic_position_ == POSITION_STABLE ? steadyhand::HandPosition::STABLE
															  : steadyhand::HandPosition::UNSTABLE;
	// Not the people that models are trained on.
	request.subject = steadyhand::draw_subject(
			steadyhand::Population::EVALUATE, static_cast<std::uint32_t>(synthetic_subject_));
	request.seed = static_cast<std::uint64_t>(synthetic_seed_);
	steadyhand::Result<steadyhand::SyntheticTrial> made = steadyhand::make_synthetic_trial(request);
	if (!made) {
		return steadyhand::Error{ made.error() };
	}
	synthetic_trial_ = trial_dictionary(made.value().trial);
	return std::move(made.value().measured.frames);
}

void HandTracker::update_processing() {
	const bool own_clock = running_ && playback_.has_value() && !finished_;
	set_process_internal(own_clock && update_mode_ == UPDATE_IDLE);
	set_physics_process_internal(own_clock && update_mode_ == UPDATE_PHYSICS);
}

Vector3 HandTracker::get_joint_position(Joint p_joint) const {
	ERR_FAIL_COND_V_MSG(
			!is_enumerator(p_joint, JOINT_WRIST), Vector3(), "HandTracker: there is no such joint");
	return positions_m_[static_cast<std::size_t>(p_joint)];
}

bool HandTracker::is_joint_tracked(Joint p_joint) const {
	ERR_FAIL_COND_V_MSG(!is_enumerator(p_joint, JOINT_WRIST), false, "HandTracker: there is no such joint");
	return ((tracked_ >> static_cast<unsigned>(p_joint)) & 1U) != 0;
}

Error HandTracker::start_recording(const String &p_path) {
	ERR_FAIL_COND_V_MSG(p_path.is_empty(), ERR_FILE_BAD_PATH,
			"HandTracker: start_recording needs the path of a file, e.g. user://hand.csv");
	const bool is_played = running_ && is_same_file(p_path, played_path_);
	const bool will_be_played = source_ == SOURCE_RECORDED && is_same_file(p_path, recording_path_);
	ERR_FAIL_COND_V_MSG(is_played || will_be_played, ERR_FILE_ALREADY_IN_USE,
			String("HandTracker: ") + p_path +
					String(" is the recording that it plays; record to another file"));
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
