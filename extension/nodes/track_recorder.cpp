#include "track_recorder.h"

#include "node_label.h"
#include "text_file.h"

#include "tracking/track_csv.h"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>

namespace godot {

namespace {

/// All columns, because the joints of later frames are unknown when the header is written.
constexpr steadyhand::TrackColumns COLUMNS{ (1U << steadyhand::JOINT_COUNT) - 1U, true };

} // namespace

Error TrackRecorder::open(const Node &p_owner, const String &p_path) {
	path_ = p_path;
	file_ = FileAccess::open(p_path, FileAccess::WRITE);
	ERR_FAIL_COND_V_MSG(file_.is_null(), FileAccess::get_open_error(),
			node_label(p_owner) + String(": cannot record to ") +
					cannot_open(p_path, FileAccess::get_open_error()));
	written_.emplace(p_owner, p_path);
	rows_.reserve(CAPACITY_BYTES + ROW_BYTES_MAX);
	rows_ = steadyhand::track_csv_header(COLUMNS, { { "origin", "SteadyHand HandTracker" } });
	flush();
	return OK;
}

void TrackRecorder::write(const steadyhand::HandFrame &p_frame) {
	if (p_frame.t_s < last_s_) {
		report_once(
				": frames that are older than the last one are left out. Record each run of a HandTracker "
				"to its own "
				"file");
		return;
	}
	last_s_ = p_frame.t_s;
	steadyhand::append_track_csv_row(rows_, p_frame, COLUMNS);
	if (p_frame.t_s > flushed_s_ + FLUSH_EVERY_S || rows_.size() > CAPACITY_BYTES) {
		flush();
		flushed_s_ = p_frame.t_s;
	}
}

void TrackRecorder::flush() {
	PackedByteArray bytes;
	bytes.resize(static_cast<int64_t>(rows_.size()));
	std::copy(rows_.begin(), rows_.end(), bytes.ptrw());
	const std::uint64_t begin = file_->get_position();
	file_->store_buffer(bytes);
	if (is_written(file_)) {
		rows_.clear();
	} else {
		report_once(": frames cannot be written and are lost. Is the disk full?");
		keep_whole_rows(begin);
	}
}

/// After a failed write of rows_ at p_begin: cuts the file after its last whole row. The other rows stay in
/// rows_ for the next attempt, unless they are too many.
void TrackRecorder::keep_whole_rows(std::uint64_t p_begin) {
	const std::uint64_t end = file_->get_length();
	std::size_t held = end > p_begin ? static_cast<std::size_t>(end - p_begin) : 0;
	held = held > 0 ? rows_.rfind('\n', held - 1) + 1 : 0; // npos + 1 is 0
	rows_.erase(0, rows_.size() > CAPACITY_BYTES ? rows_.size() : held);
	file_->resize(static_cast<int64_t>(p_begin + held));
	file_->seek(p_begin + held);
}

void TrackRecorder::report_once(const char *p_what) {
	if (!is_fault_reported_) {
		is_fault_reported_ = true;
		ERR_PRINT(path_ + String(p_what));
	}
}

TrackRecorder::~TrackRecorder() {
	if (file_.is_valid()) {
		flush();
	}
}

} // namespace godot
