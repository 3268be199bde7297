#pragma once

#include "base/result.h"
#include "haptics/haptic_clip.h"

#include <string>
#include <string_view>

namespace steadyhand {

/// Reads a `.haptic` file, version 1 (meta-haptics-sdk, resources/haptic-file-spec.md), of up to
/// HapticClip::LONGEST_S. A transient may be weaker than the amplitude there, and frequencies may go on after
/// the last amplitude, which the specification forbids: both are played all the same. The error names
/// source_name and the line.
[[nodiscard]] Result<HapticClip> parse_haptic(std::string_view text, std::string_view source_name);

/// The content of a `.haptic` file, which every reader of version 1 takes: two breakpoints at least, a
/// transient no weaker than the amplitude there, no frequency after the last amplitude. How the clip is
/// played stands in the metadata, where others ignore it.
[[nodiscard]] std::string format_haptic(const HapticClip &clip);

} // namespace steadyhand
