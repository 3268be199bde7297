#pragma once

namespace godot {

/// Whoever needs a GestureHMM's motion at each of its control instants.
class MotionListener {
public:
	/// Time starts anew: what follows is not connected to what was before.
	virtual void on_motion_started() = 0;
	/// p_displacement: the motion in units of the amplitude, 0 at the start and 1 at the end.
	virtual void on_motion(double p_time_s, double p_displacement) = 0;
	/// The GestureHMM is being freed; it must not be called again.
	virtual void on_motion_freed() = 0;

protected:
	~MotionListener() = default;
};

} // namespace godot
