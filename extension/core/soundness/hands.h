#pragma once

namespace steadyhand {

/// A hand that stops is slower before than this share of its greatest speed, which is remembered for so long.
inline constexpr double BRAKED = 0.6, BRAKES_S = 0.15;
/// Longer than any camera takes to look again: 15 Hz.
inline constexpr double LONGEST_FRAME_S = 0.07;
/// No gesture is as fast: the quickest strokes that are studied, 19 cm in 0.2 s, peak at 1.8 m/s.
inline constexpr double FASTEST_M_S = 3.0;

} // namespace steadyhand
