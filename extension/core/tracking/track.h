#pragma once

#include "tracking/frame.h"

#include <string>
#include <utility>
#include <vector>

namespace steadyhand {

/// A column that the track format does not know: carried along so that nothing recorded is lost, never
/// interpreted.
struct UnknownColumn {
	std::string name;
	std::vector<std::string> cells; ///< one per frame
};

/// A recorded hand: frames in non-decreasing time, and what the file said about them.
struct Track {
	std::vector<HandFrame> frames;
	std::uint8_t joints = 0;     ///< bit i set: the file has columns for joint i
	bool has_confidence = false; ///< the file has a confidence column
	std::vector<std::pair<std::string, std::string>> metadata; ///< `# key: value` lines, in file order
	std::vector<UnknownColumn> unknown_columns;
};

} // namespace steadyhand
