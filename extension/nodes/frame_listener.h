#pragma once

#include "tracking/frame.h"

namespace godot {

/// Whoever needs every frame of a HandTracker in order, at once, and with no Variant made for it.
class FrameListener {
public:
	/// A new stream: its time stamps may lie before those so far.
	virtual void on_stream_started() = 0;
	/// No frame comes of the stream any more.
	virtual void on_stream_ended() = 0;
	virtual void on_frame(const steadyhand::HandFrame &p_frame) = 0;
	/// All frames stamped at or before p_time_s have been delivered.
	virtual void on_time_advanced(double p_time_s) = 0;
	/// The tracker is being freed; it must not be called again.
	virtual void on_tracker_freed() = 0;

protected:
	~FrameListener() = default;
};

} // namespace godot
