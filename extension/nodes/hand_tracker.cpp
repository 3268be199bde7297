#include "hand_tracker.h"

#include "conversions.h"
#include "track_file.h"
#include "trial_dictionary.h"

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

/// As in track CSV. Control instants are counted in whole milliseconds: beyond it the count would overflow.
constexpr double TIME_MAX_S = 1e12;

bool is_usable_time(double p_time_s) {
	return std::abs(p_time_s) <= TIME_MAX_S;
}

} // namespace

HandTracker::HandTracker() = default;

HandTracker::~HandTracker() {
	listeners.call(&FrameListener::on_tracker_freed);
}

void HandTracker::_notification(int p_what) {
	switch (p_what) {
		case NOTIFICATION_READY:
			if (autostart && !Engine::get_singleton()->is_editor_hint()) {
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
	stop();
	playback.reset();
	synthetic_trial = Dictionary();
	finished = false;
	clock_set = false;
	complained = false;
	time_s = start_time_s = duration_s = 0.0;
	if (source != SOURCE_SCRIPT) {
		steadyhand::Result<std::vector<steadyhand::HandFrame>> frames = load_frames();
		if (!frames) {
			const String message = to_godot(frames.error());
			ERR_PRINT(String("HandTracker: ") + message);
			emit_signal("source_unavailable", message);
			return ERR_CANT_OPEN;
		}
		playback.emplace(std::move(frames).value(), loop);
		time_s = start_time_s = playback->start_s();
		duration_s = playback->duration_s();
	}
	running = true;
	listeners.call(&FrameListener::on_stream_started);
	update_processing();
	emit_signal("source_ready");
	return OK;
}

void HandTracker::stop() {
	++run;
	running = false;
	tracked = 0;
	update_processing();
	set_hand_present(false);
}

steadyhand::Result<std::vector<steadyhand::HandFrame>> HandTracker::load_frames() {
	if (source == SOURCE_RECORDED) {
		if (recording_path.is_empty()) {
			return steadyhand::Error{ "set recording_path to a track CSV" };
		}
		steadyhand::Result<steadyhand::Track> track = read_track_file(recording_path);
		if (!track) {
			return steadyhand::Error{ track.error() };
		}
		if (track.value().frames.empty()) {
			return steadyhand::Error{ to_core(recording_path) + ": this track has no frames" };
		}
		return std::move(track.value().frames);
	}
	steadyhand::SyntheticTrialRequest request;
	request.name = "synthetic";
	request.gesture = to_core(synthetic_gesture);
	request.position = synthetic_position == POSITION_STABLE ? steadyhand::HandPosition::STABLE
															 : steadyhand::HandPosition::UNSTABLE;
	// Not the people that models are trained on.
	request.subject = steadyhand::draw_subject(
			steadyhand::Population::EVALUATE, static_cast<std::uint32_t>(synthetic_subject));
	request.seed = static_cast<std::uint64_t>(synthetic_seed);
	steadyhand::Result<steadyhand::SyntheticTrial> made = steadyhand::make_synthetic_trial(request);
	if (!made) {
		return steadyhand::Error{ made.error() };
	}
	synthetic_trial = trial_dictionary(made.value().trial);
	return std::move(made.value().measured.frames);
}

void HandTracker::advance(double p_seconds) {
	if (source != SOURCE_SCRIPT || clock_set) {
		advance_to(time_s + p_seconds);
	}
}

void HandTracker::advance_to(double p_time_s) {
	ERR_FAIL_COND_MSG(!running, "HandTracker: start() it before its clock can advance");
	ERR_FAIL_COND_MSG(!is_usable_time(p_time_s), "HandTracker: a time must be finite, and below 1e12 s");
	constexpr double LONGEST_LOOPED_STEP_S = 3600.0;
	ERR_FAIL_COND_MSG(playback && loop && p_time_s - time_s > LONGEST_LOOPED_STEP_S,
			"HandTracker: a track in a loop is advanced by an hour at most");
	if (p_time_s < time_s) {
		return;
	}
	clock_set = true;
	const uint64_t this_run = run;
	if (playback) {
		bool new_round = playback->begins_round();
		steadyhand::HandFrame frame;
		while (playback->next(p_time_s, frame)) {
			if (new_round) {
				listeners.call(&FrameListener::on_stream_started);
			}
			deliver(frame);
			if (run != this_run) {
				return;
			}
			new_round = playback->begins_round();
		}
	}
	time_s = p_time_s;
	listeners.call(&FrameListener::on_time_advanced, time_s);
	if (run == this_run && time_s - hand_seen_s > LOST_AFTER_S) {
		set_hand_present(false);
	}
	if (run == this_run && playback && playback->finished() && !finished) {
		finished = true;
		update_processing();
		emit_signal("finished");
	}
}

Error HandTracker::push_frame(double p_time_s, const Dictionary &p_joints, double p_confidence) {
	if (source != SOURCE_SCRIPT) {
		return refuse_frame("set source to SOURCE_SCRIPT first");
	}
	if (!running) {
		return refuse_frame("start() the tracker first");
	}
	if (!is_usable_time(p_time_s)) {
		return refuse_frame("the time must be finite, and below 1e12 s");
	}
	if (clock_set && p_time_s < time_s) {
		return refuse_frame(String("the time ") + String::num(p_time_s) + String(" s is before ") +
				String::num(time_s) + String(" s"));
	}
	steadyhand::HandFrame frame;
	frame.t_s = p_time_s;
	frame.confidence = std::isfinite(p_confidence) ? std::clamp(p_confidence, 0.0, 1.0) : 0.0;
	const Array keys = p_joints.keys();
	for (int64_t i = 0; i < keys.size(); ++i) {
		const Variant position = p_joints[keys[i]];
		if (keys[i].get_type() != Variant::INT || position.get_type() != Variant::VECTOR3) {
			return refuse_frame("joints must map a Joint to a Vector3");
		}
		const int64_t joint = keys[i];
		if (joint < 0 || joint >= static_cast<int64_t>(steadyhand::JOINT_COUNT)) {
			return refuse_frame(String("there is no joint ") + itos(joint));
		}
		const Vector3 position_m = position;
		if (position_m.is_finite()) {
			frame.set(static_cast<steadyhand::Joint>(joint), to_core(position_m));
		}
	}
	if (!clock_set) {
		start_time_s = p_time_s;
	}
	clock_set = true;
	const uint64_t this_run = run;
	deliver(frame);
	if (run == this_run) {
		time_s = p_time_s;
		duration_s = time_s - start_time_s;
		listeners.call(&FrameListener::on_time_advanced, time_s);
	}
	return OK;
}

Error HandTracker::refuse_frame(const String &p_reason) {
	if (!complained) {
		complained = true;
		ERR_PRINT(String("HandTracker.push_frame: ") + p_reason + String(" (said once a run)"));
	}
	return ERR_INVALID_PARAMETER;
}

void HandTracker::deliver(const steadyhand::HandFrame &p_frame) {
	const uint64_t this_run = run;
	time_s = p_frame.t_s;
	tracked = p_frame.tracked;
	for (std::size_t joint = 0; joint < positions_m.size(); ++joint) {
		if (p_frame.has(static_cast<steadyhand::Joint>(joint))) {
			positions_m[joint] = to_godot(p_frame.positions_m[joint]);
		}
	}
	if (recorder) {
		recorder->write(p_frame);
	}
	if (tracked != 0) {
		hand_seen_s = time_s;
	}
	set_hand_present(tracked != 0);
	if (run == this_run) {
		listeners.call(&FrameListener::on_frame, p_frame);
	}
	if (run == this_run && has_connections(names.frame_received)) {
		emit_signal(names.frame_received, p_frame.t_s);
	}
}

void HandTracker::set_hand_present(bool p_present) {
	if (hand_present != p_present) {
		hand_present = p_present;
		emit_signal(p_present ? names.tracking_found : names.tracking_lost);
	}
}

void HandTracker::update_processing() {
	const bool own_clock = running && playback.has_value() && !finished;
	set_process_internal(own_clock && update_mode == UPDATE_IDLE);
	set_physics_process_internal(own_clock && update_mode == UPDATE_PHYSICS);
}

Vector3 HandTracker::get_joint_position(Joint p_joint) const {
	ERR_FAIL_INDEX_V(static_cast<int>(p_joint), static_cast<int>(steadyhand::JOINT_COUNT), Vector3());
	return positions_m[static_cast<std::size_t>(p_joint)];
}

bool HandTracker::is_joint_tracked(Joint p_joint) const {
	ERR_FAIL_INDEX_V(static_cast<int>(p_joint), static_cast<int>(steadyhand::JOINT_COUNT), false);
	return ((tracked >> static_cast<unsigned>(p_joint)) & 1U) != 0;
}

Error HandTracker::start_recording(const String &p_path) {
	stop_recording();
	auto opened = std::make_unique<TrackRecorder>();
	const Error error = opened->open(p_path);
	if (error == OK) {
		recorder = std::move(opened);
	}
	return error;
}

void HandTracker::stop_recording() {
	recorder.reset();
}

} // namespace godot
