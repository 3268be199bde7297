#pragma once

#include "tracking/track.h"

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/variant/string.hpp>

namespace godot {

/// The frames of a track CSV in memory, so that several users read the file once. It has at least one frame.
class RecordedTrack : public RefCounted {
	GDCLASS(RecordedTrack, RefCounted)

	String path_;
	steadyhand::Track track_;

protected:
	static void _bind_methods();

public:
	const steadyhand::Track &core() const { return track_; }
	String get_path() const { return path_; }
	double get_start_time() const;
	double get_duration() const;

	/// Null, and one error in the log, if the file cannot be read or has no frames.
	static Ref<RecordedTrack> load_file(const String &p_path);
};

} // namespace godot
