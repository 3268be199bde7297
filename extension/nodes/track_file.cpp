#include "track_file.h"

#include "conversions.h"
#include "text_file.h"

#include <godot_cpp/core/error_macros.hpp>

#include <string>

namespace godot {

steadyhand::Result<steadyhand::Track> read_track_file(const String &p_path) {
	const steadyhand::Result<std::string> text = read_text_file(p_path);
	if (!text) {
		return steadyhand::Error{ text.error() };
	}
	steadyhand::TrackReading reading = steadyhand::read_track_csv(text.value(), to_core(p_path));
	if (reading.error && !reading.is_cut_off) {
		return *std::move(reading.error);
	}
	for (const std::string &warning : reading.warnings) {
		WARN_PRINT(to_godot(warning));
	}
	if (reading.error) {
		WARN_PRINT(to_godot(reading.error->message) +
				String(": this last row is cut off and left out. The ") +
				itos(static_cast<int64_t>(reading.track.frames.size())) + String(" rows before it are read"));
	}
	return std::move(reading.track);
}

steadyhand::Result<steadyhand::Track> read_recording(const String &p_path) {
	steadyhand::Result<steadyhand::Track> track = read_track_file(p_path);
	if (track && track.value().frames.empty()) {
		return steadyhand::Error{ to_core(p_path) + ": this track has no frames; record it again" };
	}
	return track;
}

} // namespace godot
