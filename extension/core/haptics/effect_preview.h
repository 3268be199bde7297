#pragma once

#include "haptics/effect.h"

#include <span>
#include <vector>

namespace steadyhand {

/// The movement that effects are shown with: 20 cm in 0.8 s, minimum jerk, then rest.
inline constexpr double PREVIEW_AMPLITUDE_M = 0.2;
inline constexpr double PREVIEW_MOVEMENT_S = 0.8;
inline constexpr double PREVIEW_LENGTH_S = 1.2;

/// What that movement feels like with this effect alone; the first sample is that of the movement's start.
[[nodiscard]] std::vector<float> preview_of(const Effect &effect, double sample_rate_hz);

/// Amplitude of the sine at each frequency, under a Hann window over all samples (Goertzel 1958, doi
/// 10.2307/2310304). 0 where the frequency is not below half the sample rate.
[[nodiscard]] std::vector<float> spectrum_of(
		std::span<const float> samples, double sample_rate_hz, std::span<const float> frequencies_hz);

} // namespace steadyhand
