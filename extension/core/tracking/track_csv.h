#pragma once

#include "base/result.h"
#include "tracking/track.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace steadyhand {

// Track CSV: `# key: value` lines, a header, and a row for each frame. Columns in any order: `t` in s, not
// decreasing; `thumb_x thumb_y thumb_z`, `index_*` ... in metres; `confidence` 0..1. A joint is tracked in a
// frame if its three cells are filled. Other columns are kept.

/// Columns of a track, in addition to `t`.
struct TrackColumns {
	std::uint8_t joints = 0; ///< bit i set: joint i
	bool confidence = false;
};

/// Result of reading a track: the frames before the first invalid line, and the error there.
struct TrackReading {
	Track track;
	std::optional<Error> error;
	bool is_cut_off = false;           ///< the invalid line is the last one and has no line break
	std::vector<std::string> warnings; ///< of close_clock_jumps(), or of wrong units or names
};

/// Reads a recording that may be cut off, and keeps all frames before the cut. source_name: for messages.
/// Closes clock jumps by close_clock_jumps().
[[nodiscard]] TrackReading read_track_csv(std::string_view text, std::string_view source_name);

/// Returns the whole track, or the first error as "source:line: column: what". A file without rows gives a
/// track without frames. Closes clock jumps without a warning, unlike read_track_csv().
[[nodiscard]] Result<Track> parse_track_csv(std::string_view text, std::string_view source_name);

/// Writes a track. It reads back with equal bits.
[[nodiscard]] std::string format_track_csv(const Track &track);

// A live recorder writes the header once, and each frame when it arrives. A crash loses at most one row.

/// Metadata lines and header, each with a line break. A pair with an empty key becomes a comment.
[[nodiscard]] std::string track_csv_header(
		const TrackColumns &columns, const std::vector<std::pair<std::string, std::string>> &metadata = {});

/// Appends a row with its line break. frame.t_s must be finite. The cells of a joint are empty if it is not
/// tracked or not finite.
void append_track_csv_row(std::string &r_out, const HandFrame &frame, const TrackColumns &columns);

} // namespace steadyhand
