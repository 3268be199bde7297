#include "hand_tracker.h"

#include "conversions.h"
#include "node_label.h"

#include <godot_cpp/classes/os.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

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

/// The first number among joints that were pushed which is no Joint's.
std::optional<int64_t> unknown_joint(const Dictionary &p_joints) {
	const Array keys = p_joints.keys();
	for (int64_t i = 0; i < keys.size(); ++i) {
		if (keys[i].get_type() == Variant::INT) {
			const int64_t joint = keys[i];
			if (joint < 0 || joint >= static_cast<int64_t>(steadyhand::JOINT_COUNT)) {
				return joint;
			}
		}
	}
	return std::nullopt;
}

uint8_t bit(unsigned p_number) {
	return static_cast<uint8_t>(1U << p_number);
}

bool is_main_thread() {
	const OS *const os = OS::get_singleton();
	return os->get_thread_caller_id() == os->get_main_thread_id();
}

String explain(steadyhand::StreamDoubt p_doubt) {
	switch (p_doubt) {
		case steadyhand::StreamDoubt::TIME_STANDS:
			return "the hand moves and the time stands still: give each frame its own";
		case steadyhand::StreamDoubt::TOO_RARE:
			return "more than a second lies between frames: times are in seconds";
		case steadyhand::StreamDoubt::TOO_FAST:
			return "the hand is faster than 10 m/s for long: positions are in metres, in a space that goes "
				   "with the player";
	}
	return String();
}

} // namespace

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
	if (!is_main_thread()) {
		return refuse_frame(
				Refusal::OTHER_THREAD, "call it from the main thread, as by push_frame.call_deferred(...)");
	}
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
		return refuse_older(p_time_s);
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
		const std::optional<int64_t> unknown = unknown_joint(p_joints);
		return unknown ? refuse_frame(Refusal::UNKNOWN_JOINT, String("there is no joint ") + itos(*unknown))
					   : refuse_frame(Refusal::NO_JOINTS, "joints must map a Joint to a Vector3");
	}
	if (!clock_set_) {
		start_time_s_ = p_time_s;
	}
	clock_set_ = true;
	refused_from_s_.reset();
	duration_s_ = p_time_s - start_time_s_;
	const Watch watch(listeners_);
	const uint64_t this_run = run_;
	doubt(frame);
	deliver(frame);
	if (goes_on(watch, this_run)) {
		tell_time(p_time_s);
	}
	return OK;
}

/// Of such frames alone a hand is lost, as it is where none come.
Error HandTracker::refuse_older(double p_time_s) {
	const Error refused = refuse_frame(Refusal::OLDER,
			String("the time ") + String::num(p_time_s) + String(" s is before ") + String::num(time_s_) +
					String(" s; call start() where a device's clock begins anew"));
	refused_from_s_ = std::min(p_time_s, refused_from_s_.value_or(p_time_s));
	if (p_time_s - *refused_from_s_ > LOST_AFTER_S) {
		set_hand_present(false);
	}
	return refused;
}

Error HandTracker::refuse_frame(Refusal p_refusal, const String &p_reason) {
	const uint8_t this_one = bit(static_cast<unsigned>(p_refusal));
	if ((complained_.fetch_or(this_one) & this_one) == 0) {
		// No other thread may ask a node in the tree for its path.
		const String label = p_refusal == Refusal::OTHER_THREAD ? String("HandTracker") : node_label(*this);
		ERR_PRINT(label + String(": push_frame: ") + p_reason + String(" (said once a run)"));
	}
	return ERR_INVALID_PARAMETER;
}

/// Said once a run, as of such frames nothing is ever recognised.
void HandTracker::doubt(const steadyhand::HandFrame &p_frame) {
	const std::optional<steadyhand::StreamDoubt> doubt = doubts_.look(p_frame);
	if (!doubt) {
		return;
	}
	const uint8_t this_one = bit(static_cast<unsigned>(*doubt));
	if ((doubted_ & this_one) == 0) {
		doubted_ |= this_one;
		WARN_PRINT(node_label(*this) + String(": push_frame: ") + explain(*doubt));
	}
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

} // namespace godot
