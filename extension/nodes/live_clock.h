#pragma once

namespace godot {

/// The clock that stamps live devices, s since it was first asked: one for all trackers of the game. It goes
/// on with the game's frames, unscaled by Engine.time_scale. Of a stall, whose duration the engine cuts, it
/// takes the system's clock, so that the hand's motion is not shortened. Under `--fixed-fps` it is the
/// simulated time, which makes a run repeatable. p_frame_s: duration of the present frame, as the node is
/// told it.
double live_time_s(double p_frame_s);

/// The system's clock, s.
double host_time_s();

} // namespace godot
