#include "haptics/ahap_file.h"
#include "near.h"

#include <doctest/doctest.h>

#include <string>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

std::string pattern_of(const std::string &entries) {
	return "{ \"Version\": 1.0,\n\"Metadata\": { \"Project\": \"Doors\" },\n\"Pattern\": [\n" + entries +
			"] }";
}

HapticClip clip_of(const std::string &entries) {
	Result<HapticClip> read = parse_ahap(pattern_of(entries), "a.ahap");
	REQUIRE_MESSAGE(read.ok(), read.error());
	return std::move(read).value();
}

std::string error_of(const std::string &text) {
	const Result<HapticClip> read = parse_ahap(text, "a.ahap");
	return read ? "none" : read.error();
}

const std::string HUM = R"({ "Event": { "Time": 0.1, "EventType": "HapticContinuous", "EventDuration": 0.4,
	"EventParameters": [ { "ParameterID": "HapticIntensity", "ParameterValue": 0.5 },
		{ "ParameterID": "HapticSharpness", "ParameterValue": 0.6 } ] } })";

constexpr double ERROR = 0.005; // of the envelopes: AhapPattern::clip

} // namespace

TEST_CASE("an event is an amplitude of its intensity squared, at its sharpness squared") {
	const HapticClip clip = clip_of(HUM);
	CHECK(clip.project == "Doors");
	CHECK(clip.duration_s() == near(0.5).epsilon(1e-6));
	for (const double t_s : { 0.0, 0.05, 0.0999, 0.5001 }) {
		CHECK(clip.amplitude_at(t_s) == 0.0);
	}
	for (const double t_s : { 0.1, 0.3, 0.4999 }) {
		CHECK(clip.amplitude_at(t_s) == near(0.25));
		CHECK(clip.frequency_at(t_s) == near(0.36));
	}
}

TEST_CASE("controls multiply intensities and add to sharpnesses, from their time on") {
	const HapticClip clip = clip_of(HUM + R"(, { "ParameterCurve": { "ParameterID": "HapticIntensityControl",
		"Time": 0.1, "ParameterCurveControlPoints": [ { "Time": 0, "ParameterValue": 0 },
		{ "Time": 0.2, "ParameterValue": 1 } ] } },
		{ "Parameter": { "ParameterID": "HapticSharpnessControl", "Time": 0.3, "ParameterValue": 0.2 } },
		{ "Parameter": { "ParameterID": "HapticIntensityControl", "Time": 0.4, "ParameterValue": 0.8 } })");
	for (const double t_s : { 0.12, 0.15, 0.2, 0.27, 0.299 }) {
		CAPTURE(t_s);
		const double factor = (t_s - 0.1) / 0.2;
		CHECK(std::abs(clip.amplitude_at(t_s) - 0.25 * factor * factor) <= ERROR);
		CHECK(std::abs(clip.frequency_at(t_s) - 0.36) <= ERROR);
	}
	CHECK(std::abs(clip.amplitude_at(0.39) - 0.25) <= ERROR);
	CHECK(std::abs(clip.frequency_at(0.31) - 0.64) <= ERROR);
	CHECK(std::abs(clip.amplitude_at(0.41) - 0.16) <= ERROR);
}

TEST_CASE("a transient is at its time, changed by the controls of that time") {
	const HapticClip clip = clip_of(R"(
		{ "Parameter": { "ParameterID": "HapticIntensityControl", "Time": 0.2, "ParameterValue": 0.5 } },
		{ "Event": { "Time": 0.3, "EventType": "HapticTransient", "EventParameters": [
			{ "ParameterID": "HapticIntensity", "ParameterValue": 0.8 } ] } },
		{ "Event": { "Time": 0.1, "EventType": "HapticTransient", "EventParameters": [
			{ "ParameterID": "HapticIntensity", "ParameterValue": 7 },
			{ "ParameterID": "HapticSharpness", "ParameterValue": -3 } ] } })");
	REQUIRE(clip.transients.size() == 2);
	CHECK(clip.transients[0].time_s == 0.1);
	CHECK(clip.transients[0].amplitude == near(1.0)); // held, as Core Haptics does
	CHECK(clip.transients[0].frequency == near(0.0));
	CHECK(clip.transients[1].time_s == 0.3);
	CHECK(clip.transients[1].amplitude == near(0.16));
	CHECK(clip.transients[1].frequency == near(0.25));
}

TEST_CASE("attack, release and decay are ramps of the intensity") {
	const auto event = [](const std::string &parameters) {
		return R"({ "Event": { "EventType": "HapticContinuous", "EventDuration": 0.4, "EventParameters": [)" +
				parameters + "] } }";
	};
	const HapticClip sustained = clip_of(event(R"({ "ParameterID": "AttackTime", "ParameterValue": 0.2 },
			{ "ParameterID": "ReleaseTime", "ParameterValue": 0.1 })"));
	CHECK(sustained.duration_s() == near(0.5).epsilon(1e-6));
	CHECK(std::abs(sustained.amplitude_at(0.1) - 0.25) <= ERROR);
	CHECK(std::abs(sustained.amplitude_at(0.3) - 1.0) <= ERROR);
	CHECK(std::abs(sustained.amplitude_at(0.45) - 0.25) <= ERROR);
	const HapticClip decaying = clip_of(event(R"({ "ParameterID": "Sustained", "ParameterValue": 0 },
			{ "ParameterID": "DecayTime", "ParameterValue": 0.2 })"));
	CHECK(std::abs(decaying.amplitude_at(0.1) - 0.25) <= ERROR);
	CHECK(decaying.amplitude_at(0.3) == 0.0);
}

TEST_CASE("events at one time add up, and are held to full amplitude") {
	const HapticClip two = clip_of(HUM + "," + HUM);
	CHECK(two.amplitude_at(0.3) == near(0.5));
	CHECK(two.frequency_at(0.3) == near(0.36));
	std::string many = HUM;
	for (int i = 0; i < 9; ++i) {
		many += "," + HUM;
	}
	CHECK(clip_of(many).amplitude_at(0.3) == 1.0);
}

TEST_CASE("audio and unknown entries are left out") {
	const HapticClip clip = clip_of(HUM + R"(, { "Event": { "Time": 0, "EventType": "AudioCustom",
		"EventWaveformPath": "a.wav" } }, { "Future": {} }, { "ParameterCurve": { "Time": 0,
		"ParameterID": "AudioVolumeControl", "ParameterCurveControlPoints": [] } })");
	CHECK(clip.amplitude_at(0.3) == near(0.25));
}

TEST_CASE("a bad .ahap file gets one error with its line") {
	CHECK(error_of("{ \"Version\": 1.0 }") == "a.ahap:1: Pattern: missing");
	CHECK(error_of(pattern_of("5")) == "a.ahap:4: Pattern: an entry is not an object");
	CHECK(error_of(pattern_of("{ \"Event\": { \"EventType\": \"HapticContinuous\" } }")) ==
			"a.ahap:4: EventDuration: missing");
	CHECK(error_of(pattern_of("{ \"Event\": {} }")) == "a.ahap:4: EventType: missing");
	CHECK(error_of(pattern_of("\n{ \"Event\": { \"EventType\": \"HapticTransient\", \"Time\": 61 } }")) ==
			"a.ahap:5: Time: not within 0 .. 60, is 61");
	CHECK(error_of(pattern_of("{}")) ==
			"a.ahap:3: Pattern: it has no HapticTransient and no HapticContinuous event");
	CHECK(error_of(pattern_of(R"({ "Event": { "Time": 59, "EventType": "HapticContinuous",
		"EventDuration": 2 } })")) == "a.ahap:4: Event: ends after 60 s, the longest clip");
	CHECK(error_of(pattern_of(R"({ "ParameterCurve": { "ParameterID": "HapticIntensityControl",
		"ParameterCurveControlPoints": [ { "Time": 1, "ParameterValue": 1 },
		{ "Time": 0, "ParameterValue": 1 } ] } })")) ==
			"a.ahap:6: Time: before that of the control point ahead of it; sort them by time");
}
