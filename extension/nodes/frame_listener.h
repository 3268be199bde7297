#pragma once

#include "tracking/frame.h"

namespace godot {

/// Gets every frame of a HandTracker in order and at once, without a Variant for each frame.
class FrameListener {
public:
	/// A new stream starts. Its stamps may be before the previous ones.
	virtual void on_stream_started() = 0;
	/// The stream has no more frames.
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
