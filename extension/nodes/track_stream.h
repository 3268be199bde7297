#pragma once

#include "hand_stream.h"
#include "track_playback.h"

#include <memory>
#include <utility>
#include <vector>

namespace godot {

/// Plays the frames of a recording or a simulation, which are all known from the start.
class TrackStream : public HandStream {
public:
	explicit TrackStream(bool p_loop) : loop_(p_loop) {}

	StreamClock clock() const override { return StreamClock::GAME; }
	double start_s() const override { return playback_->start_s(); }
	double duration_s() const override { return playback_->duration_s(); }
	bool is_looped() const override { return loop_; }
	bool begins_round() const override { return playback_->begins_round(); }
	bool is_finished() const override { return playback_->finished(); }
	bool next(double p_until_s, steadyhand::DeviceFrame &r_frame) override {
		r_frame.skeleton.clear();
		const bool has_next = playback_->next(p_until_s, r_frame.hand);
		r_frame.device_time_s = r_frame.hand.t_s;
		return has_next;
	}

protected:
	/// p_frames: at least one.
	void play(std::vector<steadyhand::HandFrame> p_frames) {
		playback_ = std::make_unique<TrackPlayback>(std::move(p_frames), loop_);
		announce(StreamEvent::Kind::READY);
	}

private:
	bool loop_;
	std::unique_ptr<TrackPlayback> playback_; ///< null before open()
};

} // namespace godot
