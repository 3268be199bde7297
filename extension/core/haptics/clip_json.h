#pragma once

#include "gesture/json_fields.h"
#include "haptics/haptic_clip.h"

namespace steadyhand::clip_json {

/// A file may have so many bytes: a minute of breakpoints a millisecond apart has a fifth of it.
inline constexpr std::size_t MOST_BYTES = std::size_t{ 1 } << 24;

/// The member as text; empty where it is missing or something else, as nothing depends on it.
[[nodiscard]] std::string optional_text(const json_fields::Json &object, const char *key);

/// From the metadata of a file of either format; the defaults where nothing is said.
[[nodiscard]] ClipPlayback playback_from_json(const json_fields::Json &metadata);
[[nodiscard]] json_fields::Json playback_to_json(const ClipPlayback &playback);

/// Reads a whole file by `read`, as json_fields::read_text; a huge one is refused before it is looked at.
template <class Read>
[[nodiscard]] Result<HapticClip> read_clip(std::string_view text, std::string_view source, Read read) {
	if (text.size() > MOST_BYTES) {
		return Error{ std::string(source) + ": larger than 16 MB: no haptic clip" };
	}
	return json_fields::read_text<HapticClip>(text, source, read);
}

} // namespace steadyhand::clip_json
