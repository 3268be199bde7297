#pragma once

namespace steadyhand {

// What several rules take for granted of hands, and of frames that show them. Speeds in amplitudes but
// where they are in m/s.

/// A slower hand may be at rest, or stop from one frame to the next.
inline constexpr double RESTING_PER_S = 0.25;
/// A hand that stops is slower before than this share of its greatest speed, which is remembered for so long.
inline constexpr double BRAKED = 0.6, BRAKES_S = 0.15;
/// Without news for longer nothing is known of what a hand does.
inline constexpr double BLIND_S = 0.05;
/// Frames closer together than this see every hand brake, and set out.
inline constexpr double SPARSE_S = 0.015;
/// Longer than any camera takes to look again: 15 Hz.
inline constexpr double LONGEST_FRAME_S = 0.07;
/// No gesture is as fast: the quickest strokes that are studied, 19 cm in 0.2 s, peak at 1.8 m/s.
inline constexpr double FASTEST_M_S = 3.0;

} // namespace steadyhand
