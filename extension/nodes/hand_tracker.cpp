#include "hand_tracker.h"

#include "conversions.h"
#include "node_label.h"
#include "track_file.h"
#include "trial_dictionary.h"
#include "written_file.h"

#include "simulation/gesture_motion.h"
#include "simulation/synthetic_trial.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/core/class_db.hpp>

#include <algorithm>
#include <cmath>

namespace godot {

namespace {

/// A hand that has not been seen for this long is lost, even if its device goes quiet instead of saying so.
constexpr double LOST_AFTER_S = 0.25;

constexpr const char *TIME_FAULT = "the time must be finite, and below 1e12 s";

bool is_usable_time(double p_time_s) {
	return std::abs(p_time_s) <= steadyhand::FARTHEST_S;
}

/// Otherwise the joint is not tracked: no track CSV could hold it.
bool is_usable_place(const Eigen::Vector3d &p_position_m) {
	return p_position_m.allFinite() && p_position_m.cwiseAbs().maxCoeff() <= steadyhand::FARTHEST_M;
}

/// Why joints that were pushed cannot be taken.
String fault_of(const Dictionary &p_joints) {
	const Array keys = p_joints.keys();
	for (int64_t i = 0; i < keys.size(); ++i) {
		if (keys[i].get_type() == Variant::INT) {
			const int64_t joint = keys[i];
			if (joint < 0 || joint >= static_cast<int64_t>(steadyhand::JOINT_COUNT)) {
				return String("there is no joint ") + itos(joint);
			}
		}
	}
	return "joints must map a Joint to a Vector3";
}

} // namespace

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
	stop();
	if (watch.is_gone()) {
		return ERR_UNAVAILABLE;
	}
	playback_.reset();
	played_path_ = String();
	synthetic_trial_ = Dictionary();
	finished_ = false;
	clock_set_ = false;
	complained_ = 0;
	time_s_ = start_time_s_ = duration_s_ = 0.0;
	if (source_ != SOURCE_SCRIPT) {
		steadyhand::Result<std::vector<steadyhand::HandFrame>> frames = load_frames();
		if (!frames) {
			const String message = to_godot(frames.error());
			ERR_PRINT(node_label(*this) + String(": ") + message);
			emit_signal("source_unavailable", message);
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
	++run_;
	running_ = false;
	tracked_ = 0;
	update_processing();
	set_hand_present(false);
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

void HandTracker::advance(double p_seconds) {
	if (source_ != SOURCE_SCRIPT || clock_set_) {
		advance_to(time_s_ + p_seconds);
	}
}

void HandTracker::advance_to(double p_time_s) {
	ERR_FAIL_COND_MSG(!running_, "HandTracker: start() it before its clock can advance");
	ERR_FAIL_COND_MSG(!is_usable_time(p_time_s), String("HandTracker: ") + TIME_FAULT);
	constexpr double LONGEST_LOOPED_STEP_S = 3600.0;
	ERR_FAIL_COND_MSG(playback_ && playback_->is_looped() && p_time_s - time_s_ > LONGEST_LOOPED_STEP_S,
			"HandTracker: a track in a loop is advanced by an hour at most");
	if (p_time_s < time_s_) {
		return;
	}
	clock_set_ = true;
	const Watch watch(listeners_);
	const uint64_t this_run = run_;
	if (playback_) {
		TrackPlayback &playback = *playback_;
		bool new_round = playback.begins_round();
		steadyhand::HandFrame frame;
		while (playback.next(p_time_s, frame)) {
			if (new_round) {
				tell(&FrameListener::on_stream_started);
			}
			if (goes_on(watch, this_run)) {
				deliver(frame);
			}
			if (!goes_on(watch, this_run)) {
				return; // playback is gone, or another one's
			}
			new_round = playback.begins_round();
		}
	}
	tell_time(p_time_s);
	if (goes_on(watch, this_run) && time_s_ - hand_seen_s_ > LOST_AFTER_S) {
		set_hand_present(false);
	}
	if (goes_on(watch, this_run) && playback_ && playback_->finished() && !finished_) {
		finished_ = true;
		update_processing();
		emit_signal("finished");
	}
}

/// Who is told of a frame may have advanced the clock further.
void HandTracker::tell_time(double p_time_s) {
	if (p_time_s >= time_s_) {
		time_s_ = p_time_s;
		tell(&FrameListener::on_time_advanced, p_time_s);
	}
}

Error HandTracker::push_frame(double p_time_s, const Dictionary &p_joints, double p_confidence) {
	if (source_ != SOURCE_SCRIPT) {
		return refuse_frame(Refusal::OTHER_SOURCE, "set source to SOURCE_SCRIPT first");
	}
	if (!running_ || playback_) {
		return refuse_frame(Refusal::NOT_RUNNING, "start() the tracker first");
	}
	if (!is_usable_time(p_time_s)) {
		return refuse_frame(Refusal::NO_TIME, TIME_FAULT);
	}
	if (clock_set_ && p_time_s < time_s_) {
		return refuse_frame(Refusal::OLDER,
				String("the time ") + String::num(p_time_s) + String(" s is before ") + String::num(time_s_) +
						String(" s"));
	}
	steadyhand::HandFrame frame;
	frame.t_s = p_time_s;
	frame.confidence = std::isfinite(p_confidence) ? std::clamp(p_confidence, 0.0, 1.0) : 0.0;
	int64_t known = 0;
	for (std::size_t joint = 0; joint < steadyhand::JOINT_COUNT; ++joint) {
		const Variant position = p_joints.get(static_cast<int64_t>(joint), Variant());
		if (position.get_type() == Variant::VECTOR3) {
			++known;
			const Eigen::Vector3d position_m = to_core(static_cast<Vector3>(position));
			if (is_usable_place(position_m)) {
				frame.set(static_cast<steadyhand::Joint>(joint), position_m);
			}
		}
	}
	if (known != p_joints.size()) {
		return refuse_frame(Refusal::NO_JOINTS, fault_of(p_joints));
	}
	if (!clock_set_) {
		start_time_s_ = p_time_s;
	}
	clock_set_ = true;
	duration_s_ = p_time_s - start_time_s_;
	const Watch watch(listeners_);
	const uint64_t this_run = run_;
	deliver(frame);
	if (goes_on(watch, this_run)) {
		tell_time(p_time_s);
	}
	return OK;
}

Error HandTracker::refuse_frame(Refusal p_refusal, const String &p_reason) {
	const auto bit = static_cast<uint8_t>(1U << static_cast<unsigned>(p_refusal));
	if ((complained_ & bit) == 0) {
		complained_ |= bit;
		ERR_PRINT(node_label(*this) + String(": push_frame: ") + p_reason + String(" (said once a run)"));
	}
	return ERR_INVALID_PARAMETER;
}

void HandTracker::deliver(const steadyhand::HandFrame &p_frame) {
	const Watch watch(listeners_);
	const uint64_t this_run = run_;
	time_s_ = p_frame.t_s;
	tracked_ = p_frame.tracked;
	for (std::size_t joint = 0; joint < positions_m_.size(); ++joint) {
		if (p_frame.has(static_cast<steadyhand::Joint>(joint))) {
			positions_m_[joint] = to_godot(p_frame.positions_m[joint]);
		}
	}
	if (recorder_) {
		recorder_->write(p_frame);
	}
	if (tracked_ != 0) {
		hand_seen_s_ = time_s_;
	}
	set_hand_present(tracked_ != 0);
	if (goes_on(watch, this_run)) {
		tell(&FrameListener::on_frame, p_frame);
	}
	if (goes_on(watch, this_run) && has_connections(names_.frame_received)) {
		emit_signal(names_.frame_received, p_frame.t_s);
	}
}

void HandTracker::set_hand_present(bool p_present) {
	if (hand_present_ != p_present) {
		hand_present_ = p_present;
		emit_signal(p_present ? names_.tracking_found : names_.tracking_lost);
	}
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
