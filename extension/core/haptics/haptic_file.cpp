#include "haptics/haptic_file.h"

#include "base/version.h"
#include "haptics/clip_json.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {

using namespace json_fields;

namespace {

constexpr double MAJOR_VERSION = 1.0;
constexpr const char *SECTIONS[] = { "signals", "continuous", "envelopes" };

/// A breakpoint, and that it does not come before the one ahead of it.
Breakpoint breakpoint_from_json(const Json &json, const char *value, const std::vector<Breakpoint> &ahead) {
	const Breakpoint point{ within(json, "time", 0.0, HapticClip::LONGEST_S), within(json, value, 0.0, 1.0) };
	if (!ahead.empty() && point.time_s < ahead.back().time_s) {
		throw Fault(json["time"], "time: before that of the breakpoint ahead of it; sort them by time");
	}
	return point;
}

HapticClip clip_from_haptic(const Json &json) {
	if (number(member(json, "version"), "major") != MAJOR_VERSION) {
		throw Fault(json["version"]["major"], "version: this program reads .haptic files of version 1");
	}
	HapticClip clip;
	if (const auto metadata = json.find("metadata"); metadata != json.end() && metadata->is_object()) {
		clip.author = clip_json::optional_text(*metadata, "author");
		clip.project = clip_json::optional_text(*metadata, "project");
		clip.source = clip_json::optional_text(*metadata, "source");
		clip.description = clip_json::optional_text(*metadata, "description");
		if (const auto tags = metadata->find("tags"); tags != metadata->end() && tags->is_array()) {
			for (const Json &tag : *tags) {
				if (tag.is_string()) {
					clip.tags.push_back(tag.get<std::string>());
				}
			}
		}
		clip.playback = clip_json::playback_from_json(*metadata);
	}
	const Json *section = &json;
	for (const char *const name : SECTIONS) {
		section = &member(*section, name);
	}
	const Json &amplitudes = array(*section, "amplitude");
	for (const Json &point : amplitudes) {
		clip.amplitude.push_back(breakpoint_from_json(point, "amplitude", clip.amplitude));
		if (const auto emphasis = point.find("emphasis"); emphasis != point.end() && !emphasis->is_null()) {
			clip.transients.push_back({ clip.amplitude.back().time_s,
					within(*emphasis, "amplitude", 0.0, 1.0), within(*emphasis, "frequency", 0.0, 1.0) });
		}
	}
	if (!(clip.amplitude.back().time_s > clip.amplitude.front().time_s)) {
		throw Fault(amplitudes, "amplitude: a clip needs two breakpoints at different times");
	}
	if (const auto frequencies = section->find("frequency");
			frequencies != section->end() && !frequencies->is_null()) {
		if (!frequencies->is_array()) {
			throw Fault(*frequencies, "frequency: not an array");
		}
		for (const Json &point : *frequencies) {
			clip.frequency.push_back(breakpoint_from_json(point, "frequency", clip.frequency));
		}
	}
	return clip;
}

/// The amplitude's breakpoints, one more for each transient that has none at its time, and silence where
/// transients come before or after them.
std::vector<Breakpoint> with_transients(const HapticClip &clip) {
	std::vector<Breakpoint> points = clip.amplitude;
	const double end_s = clip.duration_s();
	if (!points.empty() && !clip.transients.empty() && clip.transients[0].time_s < points[0].time_s) {
		points.insert(points.begin(), { points[0].time_s, 0.0 });
	}
	if (!points.empty() && end_s > points.back().time_s) {
		points.push_back({ points.back().time_s, 0.0 });
	}
	for (const Transient &transient : clip.transients) {
		const auto after = std::lower_bound(points.begin(), points.end(), transient.time_s,
				[](const Breakpoint &point, double time) { return point.time_s < time; });
		if (after == points.end() || after->time_s > transient.time_s) {
			points.insert(after, { transient.time_s, clip.amplitude_at(transient.time_s) });
		}
	}
	if (points.empty() || end_s > points.back().time_s) {
		points.push_back({ end_s, 0.0 });
	}
	return points;
}

Json amplitude_to_json(const HapticClip &clip) {
	Json json = Json::array();
	auto transient = clip.transients.begin();
	for (const Breakpoint &point : with_transients(clip)) {
		json.push_back({ { "time", point.time_s }, { "amplitude", point.value } });
		if (transient != clip.transients.end() && transient->time_s <= point.time_s) {
			json.back()["emphasis"] = { { "amplitude", std::max(transient->amplitude, point.value) },
				{ "frequency", transient->frequency } };
			++transient;
		}
	}
	return json;
}

Json frequency_to_json(const HapticClip &clip) {
	Json json = Json::array();
	for (const Breakpoint &point : clip.frequency) {
		if (point.time_s <= clip.duration_s()) {
			json.push_back({ { "time", point.time_s }, { "frequency", point.value } });
		}
	}
	return json;
}

} // namespace

Result<HapticClip> parse_haptic(std::string_view text, std::string_view source_name) {
	return clip_json::read_clip(text, source_name, clip_from_haptic);
}

std::string format_haptic(const HapticClip &clip) {
	const Json json = {
		{ "version", { { "major", 1 }, { "minor", 0 }, { "patch", 0 } } },
		{ "metadata",
				{ { "editor", std::string("SteadyHand ") + VERSION }, { "author", clip.author },
						{ "source", clip.source }, { "project", clip.project }, { "tags", clip.tags },
						{ "description", clip.description },
						{ "steadyhand", clip_json::playback_to_json(clip.playback) } } },
		{ "signals",
				{ { "continuous",
						{ { "envelopes",
								{ { "amplitude", amplitude_to_json(clip) },
										{ "frequency", frequency_to_json(clip) } } } } } } },
	};
	return json.dump(1, '\t', false, Json::error_handler_t::replace) + "\n";
}

} // namespace steadyhand
