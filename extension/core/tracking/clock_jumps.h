#pragma once

#include "tracking/frame.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace steadyhand {

/// A longer step between two rows of a track, s, is a clock that was set anew or a damaged number. Recorders
/// pause for minutes, and no gesture lasts longer than this.
inline constexpr double LONGEST_STEP_S = 3600.0;

/// Closes up each step above LONGEST_STEP_S: the rows behind it follow after the track's median step. So no
/// row is lost, as it would be if the track were cut, and the time between all other rows stays. Where most
/// steps are that long, the times are no seconds: they stay as they are.
///
/// Returns the warnings, each "source:line: t: what": one for each of the first ten jumps, one for all
/// others. Frames have non-decreasing times; the first one is row `first_line` of `source`, and rows follow
/// line by line.
[[nodiscard]] std::vector<std::string> close_clock_jumps(
		std::vector<HandFrame> &r_frames, std::string_view source, std::size_t first_line);

} // namespace steadyhand
