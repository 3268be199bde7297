#pragma once

#include "written_file.h"

#include "tracking/frame.h"

#include <godot_cpp/classes/file_access.hpp>

#include <limits>
#include <optional>
#include <string>

namespace godot {

/// Writes frames to a track CSV as they come. What has been written stays readable whatever happens: rows
/// reach the disk at least once a second of the frames' own time, and when the recorder goes; of a disk that
/// is full the file has whole rows.
class TrackRecorder {
public:
	/// Reports in the log why it cannot write there. p_owner outlives it.
	Error open(const Node &p_owner, const String &p_path);
	/// A frame that is older than the one before is left out, which is said once: a track's time never
	/// decreases.
	void write(const steadyhand::HandFrame &p_frame);
	~TrackRecorder();
	const String &path() const { return path_; }

private:
	static constexpr double FLUSH_EVERY_S = 1.0;
	/// Rows of a second at 240 Hz; a faster sensor is flushed more often, so that nothing is allocated.
	static constexpr std::size_t CAPACITY_BYTES = 1U << 17U;
	static constexpr std::size_t ROW_BYTES_MAX = 1024;

	Ref<FileAccess> file_;
	String path_;
	std::optional<WrittenFile> written_;
	std::string rows_; ///< not written yet
	double last_s_ = -std::numeric_limits<double>::infinity();
	double flushed_s_ = -std::numeric_limits<double>::infinity();
	bool complained_ = false;

	void flush();
	void keep_whole_rows(std::uint64_t p_begin);
	void complain(const char *p_what);
};

} // namespace godot
