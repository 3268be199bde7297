// Delivery of frames from a HandTracker's source to its listeners.

#include "hand_tracker.h"

#include "conversions.h"
#include "hand_frame.h"
#include "hand_source.h"
#include "live_clock.h"
#include "node_label.h"

#include <algorithm>
#include <cmath>

namespace godot {

namespace {

String explain(steadyhand::FrameFault p_fault) {
	switch (p_fault) {
		case steadyhand::FrameFault::NOT_FINITE:
			return "the source sends positions that are not finite, or beyond 1e9 m. These joints count as "
				   "not "
				   "tracked. Check the source";
		case steadyhand::FrameFault::ZERO:
			return "the source sends all joints at exactly (0, 0, 0). The hand counts as lost. Check the "
				   "source";
	}
	return String();
}

} // namespace

void HandTracker::advance(double p_seconds) {
	const bool is_pushed = stream_ && stream_->clock() == StreamClock::FRAMES;
	if (stream_ && stream_->is_polled()) {
		advance_to(live_s_ + p_seconds);
	} else if (!is_pushed || clock_set_) {
		advance_to(time_s_ + p_seconds);
	}
}

void HandTracker::advance_live() {
	advance_to(std::max(live_s_, live_time_s(get_process_delta_time())));
}

void HandTracker::advance_to(double p_time_s) {
	ERR_FAIL_COND_MSG(!stream_, node_label(*this) + String(": call start() before advance()"));
	ERR_FAIL_COND_MSG(!(std::abs(p_time_s) <= steadyhand::FARTHEST_S),
			refusal(*this, "advance: the time must be finite and below 1e12 s", p_time_s));
	constexpr double LONGEST_LOOPED_STEP_S = 3600.0;
	ERR_FAIL_COND_MSG(stream_->is_looped() && p_time_s - time_s_ > LONGEST_LOOPED_STEP_S,
			node_label(*this) +
					String(": advance() moves a looped track by at most an hour. Call it several times"));
	ERR_FAIL_COND_MSG(advancing_ >= DEEPEST_ADVANCE,
			node_label(*this) +
					String(": advance() calls itself. Do not call it in a signal of the tracker, nor in "
						   "_poll()"));
	const Watch watch(listeners_);
	++advancing_;
	advance_stream(p_time_s, watch);
	if (!watch.is_destroyed()) {
		--advancing_;
	}
}

void HandTracker::advance_stream(double p_time_s, const Watch &p_watch) {
	if (p_time_s < time_s_ && !stream_->is_polled()) {
		return;
	}
	const Watch &watch = p_watch;
	const uint64_t this_run = run_;
	const std::shared_ptr<HandStream> stream = stream_; // a handler may stop the tracker
	double until_s = p_time_s;
	if (stream->is_polled()) {
		live_s_ = std::max(live_s_, p_time_s);
		stream->poll(live_s_);
		if (!report_events(*stream, watch, this_run)) {
			return;
		}
	}
	if (stream->clock() == StreamClock::LIVE) {
		until_s = stream->complete_until_s(live_s_);
	} else if (stream->clock() == StreamClock::FRAMES && stream->is_polled()) {
		return; // the source's script has pushed all frames
	}
	clock_set_ = true;
	deliver_until(until_s);
	if (is_current(watch, this_run) && until_s >= time_s_) {
		report_time(until_s);
	}
	if (is_current(watch, this_run) && stream->is_finished() && !finished_) {
		finished_ = true;
		update_processing();
		emit_signal("finished");
	}
}

void HandTracker::deliver_until(double p_time_s) {
	const Watch watch(listeners_);
	const uint64_t this_run = run_;
	const std::shared_ptr<HandStream> stream = stream_;
	bool new_round = stream->begins_round();
	steadyhand::DeviceFrame frame;
	while (stream->next(p_time_s, frame)) {
		if (new_round) {
			notify(&FrameListener::on_stream_started);
		}
		if (is_current(watch, this_run) && frame.hand.t_s >= time_s_) {
			deliver(frame);
		}
		if (!is_current(watch, this_run)) {
			return;
		}
		new_round = stream->begins_round();
	}
}

/// Does nothing if a listener has already advanced the clock further.
void HandTracker::report_time(double p_time_s) {
	if (p_time_s < time_s_) {
		return;
	}
	const Watch watch(listeners_);
	const uint64_t this_run = run_;
	time_s_ = p_time_s;
	notify(&FrameListener::on_time_advanced, p_time_s);
	if (is_current(watch, this_run) &&
			time_s_ - hand_seen_s_ > (tracked_ != 0 ? NO_FRAME_AFTER_S : LOST_AFTER_S)) {
		set_hand_present(false);
	}
}

void HandTracker::warn_of_frame_faults(uint8_t p_faults) {
	const auto new_faults = static_cast<uint8_t>(p_faults & ~reported_frame_faults_);
	reported_frame_faults_ |= new_faults;
	for (const steadyhand::FrameFault fault :
			{ steadyhand::FrameFault::NOT_FINITE, steadyhand::FrameFault::ZERO }) {
		if ((new_faults >> static_cast<unsigned>(fault) & 1U) != 0) {
			WARN_PRINT(node_label(*this) + String(": ") + explain(fault));
		}
	}
}

void HandTracker::keep_joints(const steadyhand::DeviceFrame &p_frame) {
	const steadyhand::HandSkeleton joints = joints_of(p_frame);
	tracked_ = joints.positioned;
	inferred_ = joints.inferred;
	for (std::size_t i = 0; i < positions_m_.size(); ++i) {
		if (joints.has(static_cast<steadyhand::SkeletonJoint>(i))) {
			positions_m_[i] = to_godot(joints.positions_m[i]);
		}
	}
}

void HandTracker::deliver(steadyhand::DeviceFrame p_frame) {
	const Watch watch(listeners_);
	const uint64_t this_run = run_;
	warn_of_frame_faults(frame_filter_.clean(p_frame));
	const steadyhand::HandFrame &hand = p_frame.hand;
	time_s_ = hand.t_s;
	keep_joints(p_frame);
	statistics_.add(hand);
	if (recorder_) {
		recorder_->write(hand);
	}
	if (publisher_) {
		publisher_->publish(p_frame, stream_->tracking_to_frames());
	}
	if (hand.tracked != 0) {
		hand_seen_s_ = time_s_;
		set_hand_present(true);
	} else if (time_s_ - hand_seen_s_ > LOST_AFTER_S) {
		set_hand_present(false);
	}
	if (is_current(watch, this_run)) {
		notify(&FrameListener::on_frame, hand);
	}
	if (is_current(watch, this_run) && has_connections(names_.frame_received)) {
		Ref<HandFrame> frame;
		frame.instantiate();
		frame->set_frame(p_frame);
		emit_signal(names_.frame_received, frame);
	}
}

void HandTracker::set_hand_present(bool p_present) {
	if (hand_present_ != p_present) {
		hand_present_ = p_present;
		if (publisher_ && !p_present) {
			publisher_->publish_lost();
		}
		emit_signal(p_present ? names_.tracking_restored : names_.tracking_lost);
	}
}

} // namespace godot
