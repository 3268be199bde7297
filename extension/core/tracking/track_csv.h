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

// Track CSV: `# key: value` lines, a header, one row a frame. Columns in any order: `t` in s, non-decreasing;
// `thumb_x thumb_y thumb_z`, `index_*` ... in metres; `confidence` 0..1. A joint is tracked in a frame whose
// three cells are all filled. Columns of other names are carried along.

/// Which columns a track has beside `t`.
struct TrackColumns {
	std::uint8_t joints = 0; ///< bit i set: joint i
	bool confidence = false;
};

/// As much of a track as could be read: the frames before the first bad line, and what is wrong there.
struct TrackReading {
	Track track;
	std::optional<Error> error;
	bool is_cut_off = false; ///< that is the last line, and has no line break
	/// What was read otherwise than it is written, each "source:line: column: what". The first ten clock
	/// jumps have one each, all others one together.
	std::vector<std::string> warnings;
};

/// For a recording that may be cut off: keeps every frame before the cut. `source_name` stands in the error
/// message. Clock jumps are closed up, as close_clock_jumps() says.
[[nodiscard]] TrackReading read_track_csv(std::string_view text, std::string_view source_name);

/// The whole track, or the first error as "source:line: column: what". A file without rows is a track of no
/// frames. Clock jumps are closed up without a word; read_track_csv() warns of them.
[[nodiscard]] Result<Track> parse_track_csv(std::string_view text, std::string_view source_name);

/// Reads back as the same track, to the last bit of every number.
[[nodiscard]] std::string format_track_csv(const Track &track);

// A live recorder writes the header once and each frame as it comes, so that a crash costs one row at most.

/// Metadata lines and header, each ended by a line break. A pair with an empty key is a plain comment.
[[nodiscard]] std::string track_csv_header(
		const TrackColumns &columns, const std::vector<std::pair<std::string, std::string>> &metadata = {});

/// One row with its line break. `frame.t_s` must be finite; a joint that is not tracked, not among the
/// columns or not finite leaves its cells empty.
void append_track_csv_row(std::string &r_out, const HandFrame &frame, const TrackColumns &columns);

} // namespace steadyhand
