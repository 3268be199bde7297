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
	RecordedStream(const String &p_path, bool p_loop) : TrackStream(p_loop), path_(p_path) {}

	String open() override {
		if (path_.is_empty()) {
			return "set \"track\" of the RecordedSource to a recording (*.csv)";
		}
		steadyhand::Result<steadyhand::Track> track = read_track_file(path_);
		if (!track) {
			return to_godot(track.error());
		}
		if (track.value().frames.empty()) {
			return path_ + String(": this track has no frames; record it again");
		}
		play(std::move(track.value().frames));
		return String();
	}
	String played_file() const override { return path_; }

private:
	String path_;
};

} // namespace

std::unique_ptr<HandStream> RecordedSource::make_stream(HandTracker &) {
	return std::make_unique<RecordedStream>(path_, loop_);
}

void RecordedSource::set_track(const String &p_path) {
	path_ = p_path;
	emit_changed();
}

PackedStringArray RecordedSource::get_warnings() const {
	PackedStringArray warnings;
	if (path_.is_empty()) {
		warnings.push_back("Set \"track\" of the RecordedSource to the track (*.csv) to be played.");
	} else if (!FileAccess::file_exists(path_)) {
		warnings.push_back(String("Set \"track\" of the RecordedSource to a file that exists: there is no ") +
				path_ + String("."));
	}
	return warnings;
}

String RecordedSource::no_frame_advice() const {
	return String("Record a hand to ") + path_ + String(": all of its frames are empty");
}

void RecordedSource::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_track", "path"), &RecordedSource::set_track);
	ClassDB::bind_method(D_METHOD("get_track"), &RecordedSource::get_track);
	ClassDB::bind_method(D_METHOD("set_loop", "loop"), &RecordedSource::set_loop);
	ClassDB::bind_method(D_METHOD("get_loop"), &RecordedSource::get_loop);

	ADD_PROPERTY(
			PropertyInfo(Variant::STRING, "track", PROPERTY_HINT_FILE, "*.csv"), "set_track", "get_track");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "loop"), "set_loop", "get_loop");
}

} // namespace godot
