#pragma once

#include "tracking/frame.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace steadyhand {

/// A longer step between two rows of a track, s, is a jump of the clock or a damaged number. Recorders pause
/// for minutes at most, and no gesture lasts longer.
inline constexpr double LONGEST_STEP_S = 3600.0;

/// Replaces each step above LONGEST_STEP_S by the track's median step, and shifts all later rows. Other steps
/// do not change. If most steps are above LONGEST_STEP_S, the times are not in seconds, and nothing changes.
///
/// Returns warnings "source:line: t: what": one for each of the first ten jumps, and one for all others.
/// Times of frames must not decrease. Frame i is on line first_line + i of `source`.
[[nodiscard]] std::vector<std::string> close_clock_jumps(
		std::vector<HandFrame> &r_frames, std::string_view source, std::size_t first_line);

} // namespace steadyhand
