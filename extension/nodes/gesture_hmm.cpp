#include "gesture_hmm.h"

#include "conversions.h"
#include "gesture_task.h"
#include "node_label.h"

#include "recognition/gesture_recogniser.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/core/class_db.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace godot {

namespace {

/// The paper controls the vibration at 1 kHz.
constexpr double CONTROL_RATE_HZ = 1000.0;
/// After a longer gap between stamps the recogniser restarts.
constexpr double LONGEST_GAP_S = 10.0;
/// After this number of gaps in a row the times probably have another unit.
constexpr int LONG_GAPS_WARNED = 3;

} // namespace

void GestureHMM::_notification(int p_what) {
	if (p_what == NOTIFICATION_ENTER_TREE && !Engine::get_singleton()->is_editor_hint()) {
		follow_parent();
	} else if (p_what == NOTIFICATION_EXIT_TREE && follows_parent_) {
		set_tracker(nullptr);
	} else if (p_what == NOTIFICATION_READY) {
		// A parent's script may still set the tracker in its _ready(), which is later.
		set_process_internal(!Engine::get_singleton()->is_editor_hint());
	} else if (p_what == NOTIFICATION_INTERNAL_PROCESS) {
		watch_tracker(get_process_delta_time());
	}
}

void GestureHMM::reset() {
	recognised_ = StringName();
	end_motion();
}

void GestureHMM::end_motion() {
	const Watch watch(listeners_);
	outdated_ = true;
	listeners_.call(&MotionListener::on_motion_ended);
	if (!watch.is_destroyed()) {
		abort_shown(get_gesture(), get_current_task());
	}
}

void GestureHMM::abort_shown(const StringName &p_gesture, GestureTask *p_task) {
	const Watch watch(listeners_);
	const steadyhand::ShownGesture before = std::exchange(shown_, {});
	const bool is_start_reported = !std::exchange(is_start_unreported_, false);
	const bool has_ended = before.has_ended && !std::exchange(is_end_unreported_, false);
	if (before.gesture >= 0 && !has_ended && is_start_reported) {
		emit_signal(names_.gesture_aborted, p_gesture, p_task);
	}
	if (!watch.is_destroyed() && shown_.state < 0 && std::exchange(reported_state_, -1) >= 0) {
		emit_signal(names_.state_changed, -1);
	}
}

void GestureHMM::on_stream_started() {
	++stream_;
	reset();
}

void GestureHMM::on_stream_ended() {
	++stream_;
	end_motion();
}

bool GestureHMM::prepare(double p_time_s) {
	const Watch watch(listeners_);
	const uint64_t this_stream = stream_;
	const auto is_over = [&] { return watch.is_destroyed() || stream_ != this_stream; };
	if (recogniser_ && std::abs(p_time_s - time_s_) > LONGEST_GAP_S) {
		reset();
		if (is_over()) {
			return false;
		}
		if (++long_gaps_ == LONG_GAPS_WARNED) {
			WARN_PRINT(node_label(*this) +
					": the times of successive frames are more than 10 s apart, and no gesture is recognised "
					"across such a gap. Give the source's times in seconds");
		}
	} else if (p_time_s > time_s_ && long_gaps_ < LONG_GAPS_WARNED) {
		long_gaps_ = 0; // the warning comes once
	}
	if (!outdated_ && is_task_freed()) {
		update_expected();
	}
	if (is_over()) {
		return false;
	}
	if (!outdated_) {
		return true;
	}
	outdated_ = false;
	++build_;
	build_recogniser();
	next_instant_ = static_cast<int64_t>(std::ceil(p_time_s * CONTROL_RATE_HZ));
	time_s_ = p_time_s;
	return true;
}

bool GestureHMM::run_clock(double p_time_s, bool p_up_to_and_including) {
	const Watch watch(listeners_);
	const uint64_t this_stream = stream_;
	uint64_t this_build = build_;
	// A signal handler may change settings, or push the next frame.
	while (!watch.is_destroyed() && build_ == this_build && !outdated_) {
		const double instant_s = static_cast<double>(next_instant_) / CONTROL_RATE_HZ;
		if (instant_s > p_time_s || (instant_s == p_time_s && !p_up_to_and_including)) {
			break;
		}
		++next_instant_;
		recogniser_->advance(instant_s);
		time_s_ = instant_s;
		publish();
		if (!watch.is_destroyed() && build_ == this_build && expected_changed_ && !outdated_) {
			update_expected();
			this_build = watch.is_destroyed() ? 0 : build_;
		}
	}
	return !watch.is_destroyed() && stream_ == this_stream;
}

void GestureHMM::on_frame(const steadyhand::HandFrame &p_frame) {
	has_frame_ = true;
	// Instants before this frame must not depend on it.
	if (!prepare(p_frame.t_s) || !run_clock(p_frame.t_s, false) || !prepare(p_frame.t_s)) {
		return;
	}
	recogniser_->push(p_frame);
	watch_joints(p_frame.tracked);
	watch_tasks(p_frame);
	time_s_ = std::max(time_s_, p_frame.t_s);
}

void GestureHMM::on_time_advanced(double p_time_s) {
	if (prepare(p_time_s) && run_clock(p_time_s, true) && !outdated_) {
		recogniser_->advance(p_time_s);
		time_s_ = std::max(time_s_, p_time_s);
		listeners_.call(&MotionListener::on_motion_known);
	}
}

void GestureHMM::publish() {
	const steadyhand::ShownGesture before = std::exchange(shown_, steadyhand::shown_gesture(*recogniser_));
	const steadyhand::GestureChanges changes = steadyhand::changes_between(before, shown_);
	gestures_started_ += changes.started ? 1 : 0;
	if (changes.started) {
		task_watch_.gesture_started();
	}
	task_changes_ = changes.ended ? 0 : task_changes_;
	// Copies, because the signal handlers may change the members.
	const double instant_s = time_s_;
	const int state = shown_.state;
	const double reached = changes.ended ? recogniser_->session()->fraction(recogniser_->time_s()) : 0.0;
	const StringName gesture = changes.started || changes.ended ? gesture_name(shown_.gesture) : StringName();
	GestureTask *const aborted_task = changes.aborted ? task_of(before.gesture) : nullptr;
	const StringName aborted_gesture = changes.aborted ? gesture_name(before.gesture) : StringName();
	if (changes.ended) {
		recognised_ = gesture;
	}
	if (!listeners_.empty()) {
		listeners_.call(&MotionListener::on_motion, motion_at(instant_s));
	}
	// If a handler changes settings, the remaining signals of this instant are invalid.
	const Watch watch(listeners_);
	const uint64_t this_build = build_;
	// Changes of models or tasks wait until after this instant.
	const auto is_valid = [&] { return !watch.is_destroyed() && build_ == this_build && !outdated_; };
	++emitting_;
	is_start_unreported_ = changes.started;
	is_end_unreported_ = changes.ended;
	if (changes.aborted) {
		emit_signal(names_.gesture_aborted, aborted_gesture, aborted_task);
	}
	if (changes.started && is_valid()) {
		is_start_unreported_ = false;
		emit_signal(names_.gesture_started, gesture, task_of(shown_.gesture));
	}
	if (changes.state_changed && is_valid()) {
		reported_state_ = state;
		emit_signal(names_.state_changed, state);
	}
	if (changes.ended && is_valid()) {
		is_end_unreported_ = false;
		emit_signal(names_.gesture_ended, gesture, instant_s, task_of(shown_.gesture), reached);
	}
	if (is_valid() && has_connections(names_.motion_updated)) {
		emit_signal(names_.motion_updated, instant_s);
	}
	if (!watch.is_destroyed()) {
		--emitting_;
	}
}

steadyhand::Motion GestureHMM::current(Motion p_motion, double p_time_s) const {
	if (!recogniser_ || outdated_) {
		return {};
	}
	const double now_s = recogniser_->time_s();
	return recogniser_->motion(static_cast<steadyhand::MotionSource>(p_motion),
			std::isfinite(p_time_s) ? std::max(now_s, p_time_s) : now_s);
}

MotionInstant GestureHMM::motion_at(double p_time_s) const {
	if (!recogniser_ || outdated_) {
		return { .time_s = p_time_s };
	}
	const steadyhand::Motion motion =
			recogniser_->motion(static_cast<steadyhand::MotionSource>(motion_), p_time_s);
	const double per_amplitude = 1.0 / amplitude_m();
	return { p_time_s, motion.value_m * per_amplitude, motion.velocity_m_s * per_amplitude,
		motion.acceleration_m_s2 * per_amplitude, motion.correction_m_s2 * per_amplitude, amplitude_m(),
		shown_.gesture >= 0 ? gestures_started_ : 0, shown_.has_ended && motion_ == MOTION_SYNTHESISED };
}

/// Amplitude of the shown motion. Without a gesture it is that of the nearest task.
double GestureHMM::amplitude_m() const {
	if (expected_.empty()) {
		return 1.0;
	}
	const Expected &shown = expected_[recogniser_->shown()];
	return shown.place.value_or(shown.model->typical_task).amplitude_m;
}

StringName GestureHMM::gesture_name(int p_expected) const {
	return p_expected >= 0 ? expected_[static_cast<std::size_t>(p_expected)].gesture : StringName();
}

double GestureHMM::get_value() const {
	return current(motion_).value_m;
}

double GestureHMM::get_value_at(double p_time_s) const {
	return current(motion_, p_time_s).value_m;
}

double GestureHMM::get_velocity() const {
	return current(motion_).velocity_m_s;
}

double GestureHMM::get_acceleration() const {
	const steadyhand::Motion now = current(motion_);
	return now.acceleration_m_s2 - now.correction_m_s2;
}

double GestureHMM::get_progress() const {
	// Corrections by frames are blended in, so the value may exceed the end slightly for some ms.
	return std::clamp(current(motion_).progress, 0.0, 1.0);
}

double GestureHMM::get_confidence() const {
	return recogniser_ && !outdated_ && shown_.gesture >= 0 ? recogniser_->confidence() : 0.0;
}

double GestureHMM::get_motion_value(Motion p_motion) const {
	ERR_FAIL_COND_V_MSG(!is_enumerator(p_motion, MOTION_KALMAN), 0.0,
			refusal(*this, "get_motion_value: motion must be one of MOTION_*", p_motion));
	return current(p_motion).value_m;
}

} // namespace godot
