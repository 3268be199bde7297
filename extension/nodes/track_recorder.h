#pragma once

#include "written_file.h"

#include "tracking/frame.h"

#include <godot_cpp/classes/file_access.hpp>

#include <limits>
#include <optional>
#include <string>

namespace godot {

/// Writes frames to a track CSV when they arrive. Rows are written to the disk at least once a second by the
/// frames' time, and in the destructor. If the disk is full, the file ends with a whole row.
class TrackRecorder {
public:
	/// If the file cannot be opened, the log gets an error. p_owner must outlive this object.
	Error open(const Node &p_owner, const String &p_path);
	/// Skips a frame that is older than the last one, because a track's time never decreases. Reports this
	/// once.
	void write(const steadyhand::HandFrame &p_frame);
	~TrackRecorder();
	const String &path() const { return path_; }

private:
	static constexpr double FLUSH_EVERY_S = 1.0;
	/// Rows of a second at 240 Hz. Rows of a faster sensor are flushed more often, without allocation.
	static constexpr std::size_t CAPACITY_BYTES = 1U << 17U;
	static constexpr std::size_t ROW_BYTES_MAX = 1024;

	Ref<FileAccess> file_;
	String path_;
	std::optional<WrittenFile> written_;
	std::string rows_; ///< not written yet
	double last_s_ = -std::numeric_limits<double>::infinity();
	double flushed_s_ = -std::numeric_limits<double>::infinity();
	bool is_fault_reported_ = false;

	void flush();
	void keep_whole_rows(std::uint64_t p_begin);
	void report_once(const char *p_what);
};

} // namespace godot
