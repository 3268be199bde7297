#include "tracking/trial_set.h"

#include "tracking/csv_text.h"
#include "tracking/frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>

namespace steadyhand {

namespace {

enum ColumnIndex : std::size_t {
	TRIAL,
	GESTURE,
	POSITION,
	SUBJECT,
	START_S,
	END_S,
	START_X,
	START_Y,
	START_Z,
	AXIS_X,
	AXIS_Y,
	AXIS_Z,
	AMPLITUDE_M,
	COLUMN_COUNT
};

constexpr std::array<std::string_view, COLUMN_COUNT> COLUMN_NAMES = { "trial", "gesture", "position",
	"subject", "start_s", "end_s", "start_x", "start_y", "start_z", "axis_x", "axis_y", "axis_z",
	"amplitude_m" };

constexpr double UNIT_LENGTH_TOLERANCE = 0.05; // files print axes to a few decimals
constexpr double AS_UNIT_LENGTH = 1e-5;        // within this an axis is not normalised
constexpr std::size_t FILE_NAME_MAX = 200;     // leaves room for ".reference.csv" in the usual 255 bytes

/// Which of the seven task cells a row has.
enum class TaskCells : std::uint8_t { NONE, RADIUS, AXIS };

bool is_filled_by(std::size_t column, TaskCells cells) {
	return cells == TaskCells::AXIS ||
			(cells == TaskCells::RADIUS && (column == START_X || column == AMPLITUDE_M));
}

class TableReader {
public:
	TableReader(std::string_view text, std::string_view source_name) : lines_(text), source_(source_name) {}

	Result<TrialTable> read() {
		std::string_view line;
		while (lines_.next(line)) {
			if (trim(line).empty() || (names_.empty() && line.starts_with('#'))) {
				continue;
			}
			if (names_.empty()) {
				if (auto wrong = read_header(line)) {
					return *std::move(wrong);
				}
			} else if (const auto wrong = read_row(line)) {
				table_.faults.push_back(wrong->message);
			}
		}
		if (names_.empty()) {
			return error_at(
					source_, std::max<std::size_t>(lines_.line_number(), 1), "trial", "no header line");
		}
		return std::move(table_);
	}

private:
	[[nodiscard]] Error error(ColumnIndex column, std::string_view what) const {
		return error_at(source_, lines_.line_number(), COLUMN_NAMES[column], what);
	}
	[[nodiscard]] std::string_view cell(std::size_t column) const { return cells_[place_[column]]; }

	std::optional<Error> read_header(std::string_view line) {
		split_cells(line, cells_, unescaped_);
		if (auto wrong = check_header(source_, lines_.line_number(), cells_)) {
			return wrong;
		}
		for (std::size_t column = 0; column < COLUMN_COUNT; ++column) {
			const auto found = std::find(cells_.begin(), cells_.end(), COLUMN_NAMES[column]);
			if (found == cells_.end()) {
				return error(static_cast<ColumnIndex>(column), "the header has no such column");
			}
			place_[column] = static_cast<std::size_t>(found - cells_.begin());
		}
		names_.assign(cells_.begin(), cells_.end());
		return std::nullopt;
	}

	std::optional<Error> read_row(std::string_view line) {
		split_cells(line, cells_, unescaped_);
		if (auto wrong = check_row(source_, lines_.line_number(), line, cells_, names_)) {
			return wrong;
		}
		Trial trial;
		if (auto wrong = read_identity(trial)) {
			return wrong;
		}
		if (auto wrong = read_times(trial)) {
			return wrong;
		}
		if (auto wrong = read_task(trial)) {
			return wrong;
		}
		table_.trials.push_back(std::move(trial));
		return std::nullopt;
	}

	std::optional<Error> read_identity(Trial &r_trial) {
		r_trial.trial = cell(TRIAL);
		if (const std::string_view fault = file_name_fault(r_trial.trial); !fault.empty()) {
			return error(TRIAL, quoted(r_trial.trial) + ' ' + std::string(fault));
		}
		if (!seen_.insert(r_trial.trial).second) {
			return error(TRIAL, quoted(r_trial.trial) + " comes twice");
		}
		r_trial.gesture = cell(GESTURE);
		if (const std::string_view fault = file_name_fault(r_trial.gesture); !fault.empty()) {
			return error(GESTURE, quoted(r_trial.gesture) + ' ' + std::string(fault));
		}
		for (const HandPosition position : { HandPosition::STABLE, HandPosition::UNSTABLE }) {
			if (cell(POSITION) == position_name(position)) {
				r_trial.position = position;
				r_trial.subject = cell(SUBJECT);
				return std::nullopt;
			}
		}
		return error(POSITION, quoted(cell(POSITION)) + " is neither stable nor unstable");
	}

	std::optional<Error> read_number(ColumnIndex column, double magnitude_max, double &r_number) {
		if (cell(column).empty()) {
			return error(column, "empty");
		}
		const Result<double> number = parse_number(cell(column), magnitude_max);
		if (!number) {
			return error(column, number.error());
		}
		r_number = number.value();
		return std::nullopt;
	}

	std::optional<Error> read_times(Trial &r_trial) {
		if (r_trial.gesture == "none" && cell(START_S).empty() && cell(END_S).empty()) {
			return std::nullopt;
		}
		if (auto wrong = read_number(START_S, FARTHEST_S, r_trial.start_s)) {
			return wrong;
		}
		if (auto wrong = read_number(END_S, FARTHEST_S, r_trial.end_s)) {
			return wrong;
		}
		const bool takes_time = r_trial.gesture != "none";
		if (r_trial.end_s < r_trial.start_s || (takes_time && r_trial.end_s == r_trial.start_s)) {
			return error(
					END_S, std::string(cell(END_S)) + " is not after start_s " + std::string(cell(START_S)));
		}
		return std::nullopt;
	}

	/// Known gestures define their cells. For others the filled cells of the row decide.
	[[nodiscard]] TaskCells task_cells(std::string_view gesture) const {
		if (gesture == "none") {
			return TaskCells::NONE;
		}
		if (gesture == "zoom") {
			return TaskCells::RADIUS;
		}
		if (gesture == "horizontal_drag" || gesture == "vertical_drag" || gesture == "tap" ||
				!cell(AXIS_X).empty()) {
			return TaskCells::AXIS;
		}
		return cell(AMPLITUDE_M).empty() ? TaskCells::NONE : TaskCells::RADIUS;
	}

	std::optional<Error> read_task(Trial &r_trial) {
		const TaskCells cells = task_cells(r_trial.gesture);
		const std::array<double *, 7> numbers = { &r_trial.start_m.x(), &r_trial.start_m.y(),
			&r_trial.start_m.z(), &r_trial.axis.x(), &r_trial.axis.y(), &r_trial.axis.z(),
			&r_trial.amplitude_m };
		for (std::size_t i = 0; i < numbers.size(); ++i) {
			const auto column = static_cast<ColumnIndex>(START_X + i);
			if (is_filled_by(column, cells)) {
				if (auto wrong = read_number(column, FARTHEST_M, *numbers[i])) {
					return wrong;
				}
			} else if (!cell(column).empty()) {
				return error(column, quoted(cell(column)) + " where " + r_trial.gesture + " has none");
			}
		}
		if (cells == TaskCells::AXIS) {
			const double off = std::abs(r_trial.axis.norm() - 1.0);
			if (off > UNIT_LENGTH_TOLERANCE) {
				std::string message = "the axis is no unit vector, its length is ";
				append_number(message, r_trial.axis.norm());
				return error(AXIS_X, message);
			}
			if (off > AS_UNIT_LENGTH) {
				r_trial.axis.normalize();
			}
		}
		if (cells != TaskCells::NONE && r_trial.amplitude_m <= 0.0) {
			return error(AMPLITUDE_M, quoted(cell(AMPLITUDE_M)) + " is not positive");
		}
		if (cells == TaskCells::RADIUS && r_trial.start_m.x() < 0.0) {
			return error(START_X, quoted(cell(START_X)) + " is no radius");
		}
		return std::nullopt;
	}

	CsvLines lines_;
	std::string_view source_;
	std::vector<std::string> names_;
	std::array<std::size_t, COLUMN_COUNT> place_{};
	std::vector<std::string_view> cells_;
	std::string unescaped_; ///< buffer of split_cells()
	std::set<std::string, std::less<>> seen_;
	TrialTable table_;
};

void append_trial(std::string &r_out, const Trial &trial) {
	for (const std::string_view text : { std::string_view(trial.trial), std::string_view(trial.gesture),
				 position_name(trial.position), std::string_view(trial.subject) }) {
		append_cell(r_out, text);
		r_out += ',';
	}
	append_number(r_out, trial.start_s);
	r_out += ',';
	append_number(r_out, trial.end_s);
	const std::array<double, 7> numbers = { trial.start_m.x(), trial.start_m.y(), trial.start_m.z(),
		trial.axis.x(), trial.axis.y(), trial.axis.z(), trial.amplitude_m };
	const TaskCells cells = trial.has_axis() ? TaskCells::AXIS
			: trial.amplitude_m != 0.0       ? TaskCells::RADIUS
											 : TaskCells::NONE;
	for (std::size_t i = 0; i < numbers.size(); ++i) {
		r_out += ',';
		if (is_filled_by(START_X + i, cells)) {
			append_number(r_out, numbers[i]);
		}
	}
	r_out += '\n';
}

} // namespace

Result<TrialTable> parse_trials_csv(std::string_view text, std::string_view source_name) {
	return TableReader(text, source_name).read();
}

std::string format_trials_csv(const std::vector<Trial> &trials) {
	std::string out;
	for (const std::string_view name : COLUMN_NAMES) {
		out += out.empty() ? "" : ",";
		out += name;
	}
	out += '\n';
	for (const Trial &trial : trials) {
		append_trial(out, trial);
	}
	return out;
}

std::string_view position_name(HandPosition position) {
	return position == HandPosition::STABLE ? "stable" : "unstable";
}

std::string_view file_name_fault(std::string_view name) {
	if (name.empty()) {
		return "is empty";
	}
	if (name.size() > FILE_NAME_MAX) {
		return "is too long for a file name";
	}
	if (name.find_first_of("/\\:*?\"<>|,") != std::string_view::npos || find_not_text(name) ||
			name.find('\t') != std::string_view::npos) {
		return "has a character that no file name may have";
	}
	if (name.front() == '.' || name.back() == '.' || name.front() == ' ' || name.back() == ' ') {
		return "starts or ends with a dot or space, which no file name may";
	}
	return {};
}

} // namespace steadyhand
