#pragma once

#include "hand_source.h"
#include "recorded_track.h"

namespace godot {

/// Plays a track CSV.
class RecordedSource : public HandSource {
	GDCLASS(RecordedSource, HandSource)

	String path_;
	Ref<RecordedTrack> recording_;
	bool loop_ = false;

public:
	void set_track(const String &p_path);
	String get_track() const { return path_; }
	/// Played in place of the file `track`, if it is not null.
	void set_recording(const Ref<RecordedTrack> &p_recording);
	Ref<RecordedTrack> get_recording() const { return recording_; }
	void set_loop(bool p_loop) { loop_ = p_loop; }
	bool get_loop() const { return loop_; }

	std::unique_ptr<HandStream> make_stream(HandTracker &p_tracker) override;
	PackedStringArray get_warnings() const override;
	String no_frame_advice() const override;
	String played_file() const override;
	bool is_script() const override { return false; }

protected:
	static void _bind_methods();
};

} // namespace godot
