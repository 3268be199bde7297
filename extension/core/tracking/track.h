#pragma once

#include "tracking/frame.h"

#include <string>
#include <utility>
#include <vector>

namespace steadyhand {

/// A column that is not part of the track format. It is kept and written again, but not interpreted.
struct UnknownColumn {
	std::string name;
	std::vector<std::string> cells; ///< one for each frame
};

/// A recorded hand: frames whose times do not decrease, and metadata of the file.
struct Track {
	std::vector<HandFrame> frames;
	std::uint8_t joints = 0;     ///< bit i set: the file has columns for joint i
	bool has_confidence = false; ///< the file has a confidence column
	std::vector<std::pair<std::string, std::string>> metadata; ///< `# key: value` lines, in file order
	std::vector<UnknownColumn> unknown_columns;
};

} // namespace steadyhand
