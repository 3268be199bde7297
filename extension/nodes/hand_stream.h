#pragma once

#include "tracking_space.h"

#include "tracking/hand_skeleton.h"

#include <godot_cpp/variant/string.hpp>

#include <deque>
#include <limits>
#include <utility>

namespace godot {

/// What advances a tracker's time.
enum class StreamClock : uint8_t {
	FRAMES, ///< each frame, as a script pushes it
	GAME,   ///< the game's time, from the first frame of a track
	LIVE    ///< live_time_s(): a device also runs while the game is paused
};

/// An event of a stream, besides its frames.
struct StreamEvent {
	enum class Kind : uint8_t { READY, FAILED, WARNING } kind = Kind::READY;
	String text; ///< what happened and what to do; empty for READY
};

/// A running HandSource of one HandTracker. It opens its resources in open() and closes them in its
/// destructor. Used by the main thread only.
class HandStream {
public:
	HandStream() = default;
	HandStream(const HandStream &) = delete;
	HandStream &operator=(const HandStream &) = delete;
	virtual ~HandStream() = default;

	/// Called once, first. Returns why it cannot be opened, or an empty text. A device that is not connected
	/// yet is no failure.
	virtual String open() = 0;
	virtual StreamClock clock() const = 0;
	/// Of a track: stamp of the first frame, s, and the time from it to the last frame.
	virtual double start_s() const { return 0.0; }
	virtual double duration_s() const { return 0.0; }
	virtual bool is_looped() const { return false; }
	/// Whether the next frame begins a new round of a loop.
	virtual bool begins_round() const { return false; }
	virtual bool is_finished() const { return false; }
	/// The played file; empty if there is none.
	virtual String played_file() const { return String(); }

	/// Whether poll() must be called.
	virtual bool is_polled() const { return clock() == StreamClock::LIVE; }
	/// Fetches the device's data. p_now_s: live_time_s().
	virtual void poll(double /* p_now_s */) {}
	/// Gets the next frame with a stamp up to p_until_s. False if there is none.
	virtual bool next(double p_until_s, steadyhand::DeviceFrame &r_frame) = 0;
	/// All frames before this time have arrived, s. The time of a LIVE stream advances to it.
	virtual double complete_until_s(double p_now_s) const { return p_now_s; }
	/// Accepts a frame that a script pushes; false if this stream makes its own frames.
	virtual bool accept(const steadyhand::DeviceFrame & /* p_frame */) { return false; }
	/// From the hand's motion to its frame, s; NaN if it is unknown.
	virtual double latency_s() const { return std::numeric_limits<double>::quiet_NaN(); }
	/// From the tracking space of Godot's XR nodes to the space of the frames: the world, unless the source
	/// has another space.
	virtual Eigen::Affine3d tracking_to_frames() const { return tracking_to_world(); }

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
