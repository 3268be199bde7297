// Writes track CSV.

#include "tracking/csv_text.h"
#include "tracking/track_columns.h"
#include "tracking/track_csv.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {

namespace {

void append_cells(std::string &r_out, const HandFrame &frame, const TrackColumns &columns) {
	append_number(r_out, frame.t_s);
	for (std::size_t joint = 0; joint < JOINT_COUNT; ++joint) {
		if ((columns.joints & joint_bit(joint)) == 0) {
			continue;
		}
		const Eigen::Vector3d &position_m = frame.positions_m[joint];
		if ((frame.tracked & joint_bit(joint)) == 0 || !position_m.allFinite()) {
			r_out += ",,,";
			continue;
		}
		for (const double coordinate : position_m) {
			r_out += ',';
			append_number(r_out, coordinate);
		}
	}
	if (columns.confidence) {
		r_out += ',';
		append_number(r_out, std::isfinite(frame.confidence) ? std::clamp(frame.confidence, 0.0, 1.0) : 0.0);
	}
}

void append_metadata(std::string &r_out, const std::vector<std::pair<std::string, std::string>> &metadata) {
	for (const auto &[key, value] : metadata) {
		r_out += "# ";
		append_plain_text(r_out, key);
		r_out += key.empty() ? "" : ": ";
		append_plain_text(r_out, value);
		r_out += '\n';
	}
}

void append_column_names(std::string &r_out, const TrackColumns &columns) {
	r_out += 't';
	for (std::size_t joint = 0; joint < JOINT_COUNT; ++joint) {
		for (std::size_t axis = 0; (columns.joints & joint_bit(joint)) != 0 && axis < AXES.size(); ++axis) {
			r_out += ',' + coordinate_name(joint, axis);
		}
	}
	r_out += columns.confidence ? ",confidence" : "";
}

} // namespace

std::string format_track_csv(const Track &track) {
	const TrackColumns columns{ track.joints, track.has_confidence };
	std::string out;
	append_metadata(out, track.metadata);
	append_column_names(out, columns);
	for (const UnknownColumn &column : track.unknown_columns) {
		out += ',';
		append_cell(out, column.name);
	}
	out += '\n';
	for (std::size_t i = 0; i < track.frames.size(); ++i) {
		append_cells(out, track.frames[i], columns);
		for (const UnknownColumn &column : track.unknown_columns) {
			out += ',';
			append_cell(out, i < column.cells.size() ? column.cells[i] : "");
		}
		out += '\n';
	}
	return out;
}

std::string track_csv_header(
		const TrackColumns &columns, const std::vector<std::pair<std::string, std::string>> &metadata) {
	std::string out;
	append_metadata(out, metadata);
	append_column_names(out, columns);
	out += '\n';
	return out;
}

void append_track_csv_row(std::string &r_out, const HandFrame &frame, const TrackColumns &columns) {
	append_cells(r_out, frame, columns);
	r_out += '\n';
}

} // namespace steadyhand
