#pragma once

#include <cstdint>

namespace godot {

/// A GestureHMM's motion at an instant, in units of its amplitude: 0 at the start and 1 at the end; its
/// derivatives per s and s^2.
struct MotionInstant {
	double time_s = 0.0;
	double position = 0.0;
	double velocity = 0.0;
	double acceleration = 0.0;
	double correction = 0.0; ///< part of the acceleration that is none of the hand's
	double amplitude_m = 1.0;
	uint32_t gesture = 0;   ///< number of the one under way, or held at its end: each has its own; 0: none
	bool has_ended = false; ///< that gesture, which the motion is synthesised of
};

/// Whoever needs a GestureHMM's motion at each of its control instants.
class MotionListener {
public:
	/// Time starts anew: what follows is not connected to what was before.
	virtual void on_motion_started() = 0;
	virtual void on_motion(const MotionInstant &p_motion) = 0;
	/// All that was due has been told: what is to be expected from now on may be asked for.
	virtual void on_motion_known() = 0;
	/// The GestureHMM is being freed; it must not be called again.
	virtual void on_motion_freed() = 0;

protected:
	~MotionListener() = default;
};

} // namespace godot
