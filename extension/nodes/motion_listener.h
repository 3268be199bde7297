#pragma once

#include <cstdint>

namespace godot {

/// A GestureHMM's motion at an instant, in amplitudes: 0 at the start and 1 at the end. Derivatives are per s
/// and s^2.
struct MotionInstant {
	double time_s = 0.0;
	double position = 0.0;
	double velocity = 0.0;
	double acceleration = 0.0;
	double correction = 0.0; ///< part of the acceleration that comes from corrections, not from the hand
	double amplitude_m = 1.0;
	uint32_t gesture = 0;   ///< unique number of the active or ended gesture; 0: none
	bool has_ended = false; ///< the gesture has ended, and the motion is synthesised
};

/// Gets a GestureHMM's motion at each of its control instants.
class MotionListener {
public:
	/// The motion ends. The next one has no connection to it.
	virtual void on_motion_ended() = 0;
	virtual void on_motion(const MotionInstant &p_motion) = 0;
	/// All instants that are due were reported. The listener may now predict by motion_at().
	virtual void on_motion_known() = 0;
	/// The GestureHMM is being freed; it must not be called again.
	virtual void on_motion_freed() = 0;

protected:
	~MotionListener() = default;
};

} // namespace godot
