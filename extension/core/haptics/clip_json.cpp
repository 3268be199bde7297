#include "haptics/clip_json.h"

#include <cmath>

namespace steadyhand::clip_json {

using namespace json_fields;

namespace {

constexpr const char *PLAYBACK = "steadyhand";
constexpr double MOST_HZ = 1000.0;
constexpr double MOST_FULL_SCALE = 1e9;

/// The member, or `otherwise` where it is missing.
double within_or(const Json &object, const char *key, double smallest, double largest, double otherwise) {
	return object.contains(key) ? within(object, key, smallest, largest) : otherwise;
}

} // namespace

std::string optional_text(const Json &object, const char *key) {
	const auto found = object.find(key);
	return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

ClipPlayback playback_from_json(const Json &metadata) {
	ClipPlayback playback;
	if (!metadata.contains(PLAYBACK)) {
		return playback;
	}
	const Json &json = metadata[PLAYBACK];
	if (!json.is_object()) {
		throw Fault(json, "steadyhand: not an object");
	}
	const auto whole = [&json](const char *key, int most, int otherwise) {
		return static_cast<int>(within_or(json, key, 0.0, most, otherwise));
	};
	playback.trigger = static_cast<Trigger>(
			whole("trigger", static_cast<int>(Trigger::START), static_cast<int>(playback.trigger)));
	playback.drive = static_cast<Drive>(
			whole("drive", static_cast<int>(Drive::ACCELERATION), static_cast<int>(playback.drive)));
	playback.gain = within_or(json, "gain", 0.0, 1.0, playback.gain);
	playback.full_scale = within_or(json, "full_scale", 1e-9, MOST_FULL_SCALE, playback.full_scale);
	playback.channels = static_cast<int>(within_or(json, "channels", 1.0, 3.0, playback.channels));
	FrequencyRange &range = playback.range;
	range.lowest_hz = within_or(json, "lowest_hz", 1.0, MOST_HZ, range.lowest_hz);
	range.highest_hz = within_or(json, "highest_hz", 1.0, MOST_HZ, range.highest_hz);
	return playback;
}

Json playback_to_json(const ClipPlayback &playback) {
	return { { "trigger", static_cast<int>(playback.trigger) }, { "drive", static_cast<int>(playback.drive) },
		{ "gain", playback.gain }, { "full_scale", playback.full_scale }, { "channels", playback.channels },
		{ "lowest_hz", playback.range.lowest_hz }, { "highest_hz", playback.range.highest_hz } };
}

} // namespace steadyhand::clip_json
