#include "recorded_track.h"

#include "conversions.h"
#include "track_file.h"

#include <godot_cpp/core/class_db.hpp>

#include <utility>

namespace godot {

double RecordedTrack::get_start_time() const {
	return track_.frames.empty() ? 0.0 : track_.frames.front().t_s;
}

double RecordedTrack::get_duration() const {
	return track_.frames.empty() ? 0.0 : track_.frames.back().t_s - track_.frames.front().t_s;
}

Ref<RecordedTrack> RecordedTrack::load_file(const String &p_path) {
	steadyhand::Result<steadyhand::Track> track = read_recording(p_path);
	ERR_FAIL_COND_V_MSG(!track, Ref<RecordedTrack>(), to_godot(track.error()));
	Ref<RecordedTrack> loaded;
	loaded.instantiate();
	loaded->path_ = p_path;
	loaded->track_ = std::move(track).value();
	return loaded;
}

void RecordedTrack::_bind_methods() {
	ClassDB::bind_method(D_METHOD("get_path"), &RecordedTrack::get_path);
	ClassDB::bind_method(D_METHOD("get_start_time"), &RecordedTrack::get_start_time);
	ClassDB::bind_method(D_METHOD("get_duration"), &RecordedTrack::get_duration);
	ClassDB::bind_static_method("RecordedTrack", D_METHOD("load_file", "path"), &RecordedTrack::load_file);
}

} // namespace godot
