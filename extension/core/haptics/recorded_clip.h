#pragma once

#include "haptics/haptic_clip.h"

#include <span>

namespace steadyhand {

/// A clip that feels like these samples (-1..1, of one channel): amplitude and frequency of each half wave,
/// in as few breakpoints as differ from them by at most 0.02 (the frequency: 0.02 of the range). A burst that
/// starts at its peak and has halved within 15 ms, as an impulse does, becomes a transient. Of sounds at one
/// time it has their common envelope only. What lasts longer than HapticClip::LONGEST_S is cut off.
[[nodiscard]] HapticClip recorded_clip(
		std::span<const float> samples, double sample_rate_hz, const FrequencyRange &range = {});

} // namespace steadyhand
