#include "haptics/ahap_file.h"

#include "haptics/ahap_pattern.h"
#include "haptics/clip_json.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {

using namespace json_fields;

namespace {

/// Far more than a designer makes; the time that a pattern takes grows with events times its length.
constexpr std::size_t MOST_ENTRIES = 4096, MOST_CONTROL_POINTS = 16384;
constexpr double LONGEST_RAMP_S = 1.0;   // of attack, decay and release
constexpr double LONGEST_EVENT_S = 30.0; // of a continuous event

double time_of(const Json &json) {
	return json.contains("Time") ? within(json, "Time", 0.0, HapticClip::LONGEST_S) : 0.0;
}

/// Held to its limits, as Core Haptics does.
double held(const Json &json, const char *key, double smallest, double largest) {
	return std::clamp(number(json, key), smallest, largest);
}

void read_parameter(const Json &json, AhapPattern::Event &r_event) {
	const std::string id = text(json, "ParameterID");
	const auto set = [&](double &r_member, double largest) {
		r_member = held(json, "ParameterValue", 0.0, largest);
	};
	if (id == "HapticIntensity") {
		set(r_event.intensity, 1.0);
	} else if (id == "HapticSharpness") {
		set(r_event.sharpness, 1.0);
	} else if (id == "AttackTime") {
		set(r_event.attack_s, LONGEST_RAMP_S);
	} else if (id == "DecayTime") {
		set(r_event.decay_s, LONGEST_RAMP_S);
	} else if (id == "ReleaseTime") {
		set(r_event.release_s, LONGEST_RAMP_S);
	} else if (id == "Sustained") {
		const Json &value = member(json, "ParameterValue");
		r_event.is_sustained = value.is_boolean() ? value.get<bool>() : number(json, "ParameterValue") != 0.0;
	}
}

void read_event(const Json &json, AhapPattern &r_pattern) {
	const std::string type = text(json, "EventType");
	AhapPattern::Event event;
	event.is_transient = type == "HapticTransient";
	if (!event.is_transient && type != "HapticContinuous") {
		return; // audio
	}
	event.time_s = time_of(json);
	if (!event.is_transient) {
		event.duration_s = held(json, "EventDuration", 0.0, LONGEST_EVENT_S);
	}
	if (const auto parameters = json.find("EventParameters"); parameters != json.end()) {
		if (!parameters->is_array()) {
			throw Fault(*parameters, "EventParameters: not an array");
		}
		for (const Json &parameter : *parameters) {
			read_parameter(parameter, event);
		}
	}
	if (event.end_s() > HapticClip::LONGEST_S) {
		throw Fault(json, "Event: ends after 60 s, the longest clip");
	}
	r_pattern.events.push_back(event);
}

/// Where controls of this kind go; null where they change nothing that is felt here.
std::vector<AhapPattern::Control> *controls_of(const Json &json, AhapPattern &r_pattern, double &r_least) {
	const std::string id = text(json, "ParameterID");
	r_least = id == "HapticIntensityControl" ? 0.0 : -1.0;
	return id == "HapticIntensityControl"    ? &r_pattern.intensity
			: id == "HapticSharpnessControl" ? &r_pattern.sharpness
											 : nullptr;
}

void read_dynamic_parameter(const Json &json, AhapPattern &r_pattern) {
	double least = 0.0;
	if (auto *const controls = controls_of(json, r_pattern, least)) {
		controls->push_back({ time_of(json), { { 0.0, held(json, "ParameterValue", least, 1.0) } } });
	}
}

/// r_points: those of all curves so far.
void read_curve(const Json &json, AhapPattern &r_pattern, std::size_t &r_points) {
	double least = 0.0;
	auto *const controls = controls_of(json, r_pattern, least);
	if (controls == nullptr) {
		return;
	}
	AhapPattern::Control control{ time_of(json), {} };
	const Json &points = array(json, "ParameterCurveControlPoints");
	r_points += points.size();
	if (r_points > MOST_CONTROL_POINTS) {
		throw Fault(points, "Pattern: more than " + std::to_string(MOST_CONTROL_POINTS) + " control points");
	}
	for (const Json &point : points) {
		control.points.push_back({ time_of(point), held(point, "ParameterValue", least, 1.0) });
		if (control.points.size() > 1 &&
				control.points.back().time_s < (control.points.rbegin() + 1)->time_s) {
			throw Fault(point, "Time: before that of the control point ahead of it; sort them by time");
		}
	}
	controls->push_back(std::move(control));
}

HapticClip clip_from_ahap(const Json &json) {
	AhapPattern pattern;
	std::size_t control_points = 0;
	const Json &entries = array(json, "Pattern");
	if (entries.size() > MOST_ENTRIES) {
		throw Fault(entries, "Pattern: more than " + std::to_string(MOST_ENTRIES) + " entries");
	}
	for (const Json &entry : entries) {
		if (!entry.is_object()) {
			throw Fault(entry, "Pattern: an entry is not an object");
		}
		if (entry.contains("Event")) {
			read_event(entry["Event"], pattern);
		} else if (entry.contains("Parameter")) {
			read_dynamic_parameter(entry["Parameter"], pattern);
		} else if (entry.contains("ParameterCurve")) {
			read_curve(entry["ParameterCurve"], pattern, control_points);
		}
	}
	HapticClip clip = pattern.clip();
	if (!(clip.duration_s() > 0.0)) {
		throw Fault(entries, "Pattern: it has no HapticTransient and no HapticContinuous event");
	}
	if (const auto metadata = json.find("Metadata"); metadata != json.end() && metadata->is_object()) {
		clip.project = clip_json::optional_text(*metadata, "Project");
		clip.author = clip_json::optional_text(*metadata, "Created");
		clip.description = clip_json::optional_text(*metadata, "Description");
	}
	return clip;
}

} // namespace

Result<HapticClip> parse_ahap(std::string_view text, std::string_view source_name) {
	return clip_json::read_clip(text, source_name, clip_from_ahap);
}

} // namespace steadyhand
