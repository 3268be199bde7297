// Any bytes are a track or one error; a track that was read and written reads back as itself, to the last
// bit.

#include "require.h"
#include "tracking/track_csv.h"

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

using namespace steadyhand;
using steadyhand::fuzz::require;

namespace {

constexpr std::string_view SOURCE = "a.csv:";

bool is_same(double left, double right) {
	return std::bit_cast<std::uint64_t>(left) == std::bit_cast<std::uint64_t>(right);
}

void check_frame(const HandFrame &frame, const Track &track) {
	require(std::abs(frame.t_s) <= FARTHEST_S, "a time is finite and in range");
	require(frame.confidence >= 0.0 && frame.confidence <= 1.0, "a confidence is within 0..1");
	require((frame.tracked & ~track.joints) == 0, "a tracked joint has columns");
	for (const Eigen::Vector3d &position_m : frame.positions_m) {
		require(is_place(position_m), "a position is finite and in range");
	}
}

void check_track(const Track &track) {
	for (std::size_t i = 0; i < track.frames.size(); ++i) {
		check_frame(track.frames[i], track);
		require(i == 0 || track.frames[i].t_s >= track.frames[i - 1].t_s, "time does not go back");
	}
	for (const UnknownColumn &column : track.unknown_columns) {
		require(column.cells.size() == track.frames.size(), "an unknown column has a cell for each frame");
	}
}

void check_same(const Track &left, const Track &right) {
	require(left.joints == right.joints && left.has_confidence == right.has_confidence &&
					left.metadata == right.metadata,
			"columns and metadata read back");
	require(left.unknown_columns.size() == right.unknown_columns.size(), "unknown columns read back");
	for (std::size_t i = 0; i < left.unknown_columns.size(); ++i) {
		require(left.unknown_columns[i].name == right.unknown_columns[i].name &&
						left.unknown_columns[i].cells == right.unknown_columns[i].cells,
				"an unknown column reads back");
	}
	require(left.frames.size() == right.frames.size(), "all frames read back");
	for (std::size_t i = 0; i < left.frames.size(); ++i) {
		const HandFrame &one = left.frames[i], &other = right.frames[i];
		require(is_same(one.t_s, other.t_s) && is_same(one.confidence, other.confidence) &&
						one.tracked == other.tracked,
				"time, confidence and joints read back");
		for (std::size_t joint = 0; joint < JOINT_COUNT; ++joint) {
			for (Eigen::Index axis = 0; axis < 3; ++axis) {
				require(is_same(one.positions_m[joint][axis], other.positions_m[joint][axis]),
						"a position reads back");
			}
		}
	}
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
	const std::string_view text(reinterpret_cast<const char *>(data), size);
	const TrackReading reading = read_track_csv(text, "a.csv");
	for (const std::string &warning : reading.warnings) {
		require(warning.starts_with(SOURCE), "a warning names the source");
	}
	if (reading.error) {
		require(reading.error->message.starts_with(SOURCE), "an error names the source");
	}
	if (reading.error && reading.track.frames.empty()) {
		return 0; // the header may be read in part
	}
	check_track(reading.track);
	const TrackReading again = read_track_csv(format_track_csv(reading.track), "a.csv");
	require(!again.error, "what is written can be read");
	// Times that are no seconds stay, and closing up rounds: a step of an hour may be longer afterwards.
	if (again.warnings.empty() || reading.warnings.empty()) {
		require(again.warnings.empty(), "what is written gives no warning");
		check_same(reading.track, again.track);
	}
	return 0;
}
