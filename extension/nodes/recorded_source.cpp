#include "recorded_source.h"

#include "conversions.h"
#include "track_file.h"
#include "track_stream.h"

#include <godot_cpp/classes/file_access.hpp>
#include <godot_cpp/core/class_db.hpp>

namespace godot {

namespace {

class RecordedStream : public TrackStream {
public:
	RecordedStream(const String &p_path, const Ref<RecordedTrack> &p_recording, bool p_loop) :
			TrackStream(p_loop), path_(p_path), recording_(p_recording) {}

	String open() override {
		if (recording_.is_valid()) {
			play(recording_->core().frames);
			return String();
		}
		if (path_.is_empty()) {
			return "set \"track\" of the RecordedSource to a recording (*.csv)";
		}
		steadyhand::Result<steadyhand::Track> track = read_recording(path_);
		if (!track) {
			return to_godot(track.error());
		}
		play(std::move(track.value().frames));
		return String();
	}
	String played_file() const override { return path_; }

private:
	String path_;
	Ref<RecordedTrack> recording_;
};

} // namespace

std::unique_ptr<HandStream> RecordedSource::make_stream(HandTracker &) {
	return std::make_unique<RecordedStream>(played_file(), recording_, loop_);
}

void RecordedSource::set_track(const String &p_path) {
	path_ = p_path;
	emit_changed();
}

void RecordedSource::set_recording(const Ref<RecordedTrack> &p_recording) {
	ERR_FAIL_COND_MSG(p_recording.is_valid() && p_recording->core().frames.empty(),
			"RecordedSource: recording has no frames: take it from RecordedTrack.load_file()");
	recording_ = p_recording;
	emit_changed();
}

String RecordedSource::played_file() const {
	return recording_.is_valid() ? recording_->get_path() : path_;
}

PackedStringArray RecordedSource::get_warnings() const {
	PackedStringArray warnings;
	if (recording_.is_valid()) {
		return warnings;
	}
	if (path_.is_empty()) {
		warnings.push_back("Set \"track\" of the RecordedSource to the track (*.csv) to be played.");
	} else if (!FileAccess::file_exists(path_)) {
		warnings.push_back(String("Set \"track\" of the RecordedSource to a file that exists: there is no ") +
				path_ + String("."));
	}
	return warnings;
}

String RecordedSource::no_frame_advice() const {
	return String("Record a hand to ") + played_file() + String(": all of its frames are empty");
}

void RecordedSource::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_track", "path"), &RecordedSource::set_track);
	ClassDB::bind_method(D_METHOD("get_track"), &RecordedSource::get_track);
	ClassDB::bind_method(D_METHOD("set_recording", "recording"), &RecordedSource::set_recording);
	ClassDB::bind_method(D_METHOD("get_recording"), &RecordedSource::get_recording);
	ClassDB::bind_method(D_METHOD("set_loop", "loop"), &RecordedSource::set_loop);
	ClassDB::bind_method(D_METHOD("get_loop"), &RecordedSource::get_loop);

	ADD_PROPERTY(
			PropertyInfo(Variant::STRING, "track", PROPERTY_HINT_FILE, "*.csv"), "set_track", "get_track");
	constexpr uint32_t FOR_SCRIPTS = PROPERTY_USAGE_NONE;
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "recording", PROPERTY_HINT_RESOURCE_TYPE, "RecordedTrack",
						 FOR_SCRIPTS),
			"set_recording", "get_recording");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "loop"), "set_loop", "get_loop");
}

} // namespace godot
