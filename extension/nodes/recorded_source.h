#pragma once

#include "hand_source.h"

namespace godot {

/// Plays a track CSV.
class RecordedSource : public HandSource {
	GDCLASS(RecordedSource, HandSource)

	String path_;
	bool loop_ = false;

public:
	void set_track(const String &p_path);
	String get_track() const { return path_; }
	void set_loop(bool p_loop) { loop_ = p_loop; }
	bool get_loop() const { return loop_; }

	std::unique_ptr<HandStream> make_stream(HandTracker &p_tracker) override;
	PackedStringArray get_warnings() const override;
	String no_frame_advice() const override;
	String played_file() const override { return path_; }
	bool is_script() const override { return false; }

protected:
	static void _bind_methods();
};

} // namespace godot
