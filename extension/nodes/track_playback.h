#pragma once

#include "tracking/frame.h"

#include <utility>
#include <vector>

namespace godot {

/// Plays recorded frames by a clock. In a loop the stamps of each round continue those of the last round, so
/// that time never goes back.
class TrackPlayback {
public:
	/// p_frames: at least one, in non-decreasing time.
	TrackPlayback(std::vector<steadyhand::HandFrame> p_frames, bool p_loop) :
			frames_(std::move(p_frames)), loop_(p_loop) {}

	double start_s() const { return frames_.front().t_s; }
	double duration_s() const { return frames_.back().t_s - start_s(); }
	bool is_looped() const { return loop_; }
	/// No more frames follow.
	bool finished() const { return next_ == frames_.size() && !loop_; }
	/// The next frame is the first of a new round.
	bool begins_round() const { return next_ == frames_.size() && loop_; }

	/// False if no frame has a stamp up to p_time_s.
	bool next(double p_time_s, steadyhand::HandFrame &r_frame) {
		if (begins_round()) {
			if (!(frames_.front().t_s + offset_s_ + period_s() <= p_time_s)) {
				return false;
			}
			offset_s_ += period_s();
			next_ = 0;
		}
		if (next_ == frames_.size() || !(frames_[next_].t_s + offset_s_ <= p_time_s)) {
			return false;
		}
		r_frame = frames_[next_++];
		r_frame.t_s += offset_s_;
		return true;
	}

private:
	/// Time from the end of a round to the start of the next one. So a track without duration also has a
	/// period.
	static constexpr double PAUSE_S = 0.01;

	std::vector<steadyhand::HandFrame> frames_;
	bool loop_;
	std::size_t next_ = 0;
	double offset_s_ = 0.0;

	double period_s() const { return duration_s() + PAUSE_S; }
};

} // namespace godot
