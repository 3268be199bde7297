#pragma once

namespace godot {

/// Clock of live devices, in s since the first call. All trackers of the game share it. It advances with the
/// game's frames, without Engine.time_scale. The engine limits the reported duration of a stall; then this
/// clock uses the system's clock. With `--fixed-fps` it is the simulated time, which makes a run repeatable.
/// p_frame_s: delta time of the present frame.
double live_time_s(double p_frame_s);

/// The system's clock, s.
double host_time_s();

} // namespace godot
