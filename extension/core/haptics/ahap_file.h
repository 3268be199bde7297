#pragma once

#include "base/result.h"
#include "haptics/haptic_clip.h"

#include <string_view>

namespace steadyhand {

/// Reads an Apple Haptic and Audio Pattern ("Representing haptic patterns in AHAP files", Core Haptics) of up
/// to HapticClip::LONGEST_S. As Core Haptics does, it leaves out audio and what it does not know, and holds
/// values to their limits. Continuous events become one envelope: their sum, held to 1, and the mean of their
/// frequencies.
///
/// An amplitude is the square of an intensity, a frequency the square of a sharpness: the inverse of what
/// Meta's converter to AHAP does (meta-haptics-sdk, core/haptic_data/src/ahap.rs), as Apple publishes
/// neither. Attack, decay and release are straight. The error names source_name and the line.
[[nodiscard]] Result<HapticClip> parse_ahap(std::string_view text, std::string_view source_name);

} // namespace steadyhand
