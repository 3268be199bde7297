#include "tracking/track_csv.h"

#include "tracking/clock_jumps.h"
#include "tracking/csv_text.h"
#include "tracking/stream_check.h"
#include "tracking/track_columns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace steadyhand {

namespace {

enum class ColumnKind : std::uint8_t { TIME, COORDINATE, CONFIDENCE, UNKNOWN };

struct Column {
	ColumnKind kind = ColumnKind::UNKNOWN;
	std::size_t joint = 0;
	Eigen::Index axis = 0;
	std::size_t unknown = 0; ///< index into Track::unknown_columns
};

struct Header {
	std::vector<std::string> names;
	std::vector<Column> columns;
};

Column column_of(std::string_view name) {
	if (name == "t") {
		return { .kind = ColumnKind::TIME };
	}
	if (name == "confidence") {
		return { .kind = ColumnKind::CONFIDENCE };
	}
	for (std::size_t joint = 0; joint < JOINT_COUNT; ++joint) {
		for (std::size_t axis = 0; axis < AXES.size(); ++axis) {
			if (name == coordinate_name(joint, axis)) {
				return {
					.kind = ColumnKind::COORDINATE, .joint = joint, .axis = static_cast<Eigen::Index>(axis)
				};
			}
		}
	}
	return {};
}

std::pair<std::string, std::string> parse_metadata(std::string_view line) {
	const std::string_view text = trim(line.substr(1));
	for (std::size_t colon = text.find(':'); colon != std::string_view::npos;
			colon = text.find(':', colon + 1)) {
		const bool is_separator =
				colon + 1 == text.size() || text[colon + 1] == ' ' || text[colon + 1] == '\t';
		if (is_separator && colon > 0) { // a line without a key is a comment
			return { std::string(trim(text.substr(0, colon))), std::string(trim(text.substr(colon + 1))) };
		}
	}
	return { "", std::string(text) };
}

class TrackReader {
public:
	TrackReader(std::string_view text, std::string_view source_name) :
			lines_(text), source_(source_name), ends_in_line_(!text.ends_with('\n')) {}

	TrackReading read() {
		reading_.error = read_metadata_and_header();
		std::string_view line;
		while (!reading_.error && lines_.next(line)) {
			if (trim(line).empty()) {
				reading_.error = check_only_blank_lines_follow();
				break;
			}
			reading_.error = read_row(line);
			reading_.is_cut_off = reading_.error && ends_in_line_ && lines_.are_over();
		}
		reading_.warnings = close_clock_jumps(reading_.track.frames, source_, header_line_ + 1);
		if (reading_.warnings.empty()) {
			check_units();
		}
		check_joints();
		return std::move(reading_);
	}

private:
	[[nodiscard]] Error error(std::string_view column, std::string_view what) const {
		return error_at(source_, lines_.line_number(), column, what);
	}

	/// Frames without a joint are a lost hand. If no column is named after a joint, names are the cause.
	void check_joints() {
		const bool is_header_read = !reading_.error || !reading_.track.frames.empty();
		if (is_header_read && reading_.track.joints == 0 && !reading_.track.unknown_columns.empty()) {
			const std::string_view fix =
					"no column is named after a joint, so no hand is seen. Name those of "
					"the index fingertip index_x, index_y, index_z";
			reading_.warnings.push_back(error_at(source_, header_line_, fix).message);
		}
	}

	/// Warns of the first fault only: others often have the same cause.
	void check_units() {
		StreamCheck check;
		const std::vector<HandFrame> &frames = reading_.track.frames;
		for (std::size_t i = 0; i < frames.size(); ++i) {
			if (const std::optional<StreamFault> fault = check.push(frames[i])) {
				const std::string_view column = *fault == StreamFault::TOO_FAST ? "positions" : "t";
				reading_.warnings.push_back(
						error_at(source_, header_line_ + 1 + i, column, explain(*fault)).message);
				return;
			}
		}
	}

	std::optional<Error> read_metadata_and_header() {
		std::string_view line;
		while (lines_.next(line)) {
			if (line.starts_with('#')) {
				if (find_not_text(line)) {
					return error("metadata", quoted(line) + " is not text");
				}
				reading_.track.metadata.push_back(parse_metadata(line));
			} else if (!trim(line).empty()) {
				header_line_ = lines_.line_number();
				return read_header(line);
			}
		}
		return error_at(source_, std::max<std::size_t>(lines_.line_number(), 1), "no header line");
	}

	std::optional<Error> read_header(std::string_view line) {
		split_cells(line, cells_, unescaped_);
		if (auto wrong = check_header(source_, lines_.line_number(), cells_)) {
			return wrong;
		}
		std::array<unsigned, JOINT_COUNT> axes_seen{};
		for (const std::string_view name : cells_) {
			Column column = column_of(name);
			if (column.kind == ColumnKind::COORDINATE) {
				axes_seen[column.joint] |= 1U << column.axis;
			} else if (column.kind == ColumnKind::CONFIDENCE) {
				reading_.track.has_confidence = true;
			} else if (column.kind == ColumnKind::UNKNOWN) {
				column.unknown = reading_.track.unknown_columns.size();
				reading_.track.unknown_columns.push_back({ std::string(name), {} });
			}
			header_.names.emplace_back(name);
			header_.columns.push_back(column);
		}
		if (std::find(cells_.begin(), cells_.end(), "t") == cells_.end()) {
			return error("t", "the header has no such column. Rename the column of times in seconds to 't'");
		}
		for (std::size_t joint = 0; joint < JOINT_COUNT; ++joint) {
			for (std::size_t axis = 0; axes_seen[joint] != 0 && axis < AXES.size(); ++axis) {
				if (((axes_seen[joint] >> axis) & 1U) == 0) {
					return error(coordinate_name(joint, axis),
							"the header has no such column. Add it, because a joint needs x, y and z");
				}
			}
			if (axes_seen[joint] != 0) {
				reading_.track.joints |= joint_bit(joint);
			}
		}
		return std::nullopt;
	}

	std::optional<Error> read_row(std::string_view line) {
		split_cells(line, cells_, unescaped_);
		if (auto wrong = check_row(source_, lines_.line_number(), line, cells_, header_.names)) {
			return wrong;
		}
		HandFrame frame;
		std::array<unsigned, JOINT_COUNT> axes_filled{};
		for (std::size_t i = 0; i < cells_.size(); ++i) {
			const Column &column = header_.columns[i];
			if (column.kind == ColumnKind::UNKNOWN ||
					(cells_[i].empty() && column.kind != ColumnKind::TIME)) {
				continue;
			}
			const bool is_time = column.kind == ColumnKind::TIME;
			const Result<double> number = parse_number(cells_[i], is_time ? FARTHEST_S : FARTHEST_M);
			if (!number) {
				return error(header_.names[i], number.error());
			}
			if (is_time) {
				frame.t_s = number.value();
				if (frame.t_s < previous_t_s_) {
					return error("t", std::string(cells_[i]) + " is before the row above");
				}
			} else if (column.kind == ColumnKind::CONFIDENCE) {
				frame.confidence = number.value();
				if (frame.confidence < 0.0 || frame.confidence > 1.0) {
					return error("confidence", quoted(cells_[i]) + " is not within 0..1");
				}
			} else {
				frame.positions_m[column.joint][column.axis] = number.value();
				axes_filled[column.joint] |= 1U << column.axis;
			}
		}
		for (std::size_t joint = 0; joint < JOINT_COUNT; ++joint) {
			if (axes_filled[joint] == 0b111U) {
				frame.tracked |= joint_bit(joint);
			} else {
				frame.positions_m[joint].setZero();
			}
		}
		previous_t_s_ = frame.t_s;
		reading_.track.frames.push_back(frame);
		for (std::size_t i = 0; i < cells_.size(); ++i) {
			if (header_.columns[i].kind == ColumnKind::UNKNOWN) {
				reading_.track.unknown_columns[header_.columns[i].unknown].cells.emplace_back(cells_[i]);
			}
		}
		return std::nullopt;
	}

	std::optional<Error> check_only_blank_lines_follow() {
		const std::size_t blank_line = lines_.line_number();
		std::string_view line;
		while (lines_.next(line)) {
			if (!trim(line).empty()) {
				return error_at(source_, blank_line, "t", "a blank line among the rows");
			}
		}
		return std::nullopt;
	}

	CsvLines lines_;
	std::string_view source_;
	bool ends_in_line_;
	std::size_t header_line_ = 0;
	Header header_;
	TrackReading reading_;
	std::vector<std::string_view> cells_;
	std::string unescaped_; ///< buffer of split_cells()
	double previous_t_s_ = -std::numeric_limits<double>::infinity();
};

} // namespace

TrackReading read_track_csv(std::string_view text, std::string_view source_name) {
	return TrackReader(text, source_name).read();
}

Result<Track> parse_track_csv(std::string_view text, std::string_view source_name) {
	TrackReading reading = read_track_csv(text, source_name);
	if (reading.error) {
		return *std::move(reading.error);
	}
	return std::move(reading.track);
}

} // namespace steadyhand
