#pragma once

namespace godot {

/// The clock that stamps live devices, s, the same for all trackers of the game. It goes on with the game's
/// frames, unscaled by Engine.time_scale, and is never more than 0.1 s behind the system's clock, so that a
/// stall of the game does not shorten the hand's motion. Under `--fixed-fps` it is the simulated time, which
/// makes a test repeatable. p_frame_s: duration of the present frame, as the node is told it.
double live_time_s(double p_frame_s);

/// The system's clock, s.
double host_time_s();

} // namespace godot
