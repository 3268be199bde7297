#pragma once

#include "tracking/hand_skeleton.h"

#include <godot_cpp/variant/string.hpp>

#include <deque>
#include <limits>
#include <utility>

namespace godot {

/// What moves a tracker's time on.
enum class StreamClock : uint8_t {
	FRAMES, ///< each frame, as a script pushes it
	GAME,   ///< the game's time, from the first frame of a track on
	LIVE    ///< live_time_s(): a device runs whether or not the game does
};

/// News of a stream beside its frames.
struct StreamEvent {
	enum class Kind : uint8_t { READY, FAILED, WARNING } kind = Kind::READY;
	String text; ///< what happened and what to do; empty for READY
};

/// A HandSource while one HandTracker runs it. It opens what it needs in open() and closes it when it is
/// destroyed. Used by the main thread only.
class HandStream {
public:
	HandStream() = default;
	HandStream(const HandStream &) = delete;
	HandStream &operator=(const HandStream &) = delete;
	virtual ~HandStream() = default;

	/// Called once, before all else. Returns why it cannot be opened, or an empty text. A device that may yet
	/// come is no failure of open().
	virtual String open() = 0;
	virtual StreamClock clock() const = 0;
	/// Stamp of the first frame, s, and the time from there to the last one; of a track.
	virtual double start_s() const { return 0.0; }
	virtual double duration_s() const { return 0.0; }
	virtual bool is_looped() const { return false; }
	/// The next frame begins a new round of a loop.
	virtual bool begins_round() const { return false; }
	virtual bool is_finished() const { return false; }
	/// The file that is played, or none.
	virtual String played_file() const { return String(); }

	/// Whether poll() does anything.
	virtual bool is_polled() const { return clock() == StreamClock::LIVE; }
	/// Fetches what the device has sent. p_now_s: live_time_s().
	virtual void poll(double /* p_now_s */) {}
	/// The next frame stamped at or before p_until_s, in order; false where there is none.
	virtual bool next(double p_until_s, steadyhand::DeviceFrame &r_frame) = 0;
	/// All frames stamped before this have come, s. A LIVE stream's time moves on to there.
	virtual double complete_until_s(double p_now_s) const { return p_now_s; }
	/// Takes a frame that a script pushes; false where this stream makes its own.
	virtual bool accept(const steadyhand::DeviceFrame & /* p_frame */) { return false; }
	/// From the hand's motion to its frame, s; not a number where it is unknown.
	virtual double latency_s() const { return std::numeric_limits<double>::quiet_NaN(); }

	virtual bool next_event(StreamEvent &r_event) {
		if (events_.empty()) {
			return false;
		}
		r_event = std::move(events_.front());
		events_.pop_front();
		return true;
	}

protected:
	void announce(StreamEvent::Kind p_kind, const String &p_text = String()) {
		events_.push_back({ p_kind, p_text });
	}

private:
	std::deque<StreamEvent> events_;
};

} // namespace godot
