#include "haptics/haptic_file.h"
#include "near.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

const std::string DOOR = R"({
	"version": { "major": 1, "minor": 0, "patch": 0 },
	"metadata": { "editor": "a hand", "author": "me", "tags": ["door", 5, "wood"], "mood": { "any": 1 } },
	"signals": { "continuous": { "envelopes": {
		"amplitude": [
			{ "time": 0, "amplitude": 0.1 },
			{ "time": 0.25, "amplitude": 0.3, "emphasis": { "amplitude": 0.9, "frequency": 0.75 } },
			{ "time": 0.5, "amplitude": 0.0 }
		],
		"frequency": [ { "time": 0.1, "frequency": 0.2 }, { "time": 0.3, "frequency": 1.0 } ]
	} } }
})";

std::string with(std::string text, const std::string &from, const std::string &to) {
	const std::size_t place = text.find(from);
	REQUIRE(place != std::string::npos);
	return text.replace(place, from.size(), to);
}

std::string error_of(const std::string &text) {
	const Result<HapticClip> read = parse_haptic(text, "door.haptic");
	return read ? "none" : read.error();
}

} // namespace

TEST_CASE("a .haptic file's envelopes are straight between its breakpoints") {
	const Result<HapticClip> read = parse_haptic(DOOR, "door.haptic");
	REQUIRE_MESSAGE(read.ok(), error_of(DOOR));
	const HapticClip &clip = read.value();
	CHECK(clip.duration_s() == 0.5);
	CHECK(clip.amplitude_at(0.125) == near(0.2));
	CHECK(clip.amplitude_at(0.375) == near(0.15));
	CHECK(clip.amplitude_at(0.6) == 0.0);
	CHECK(clip.frequency_at(0.0) == near(0.2));
	CHECK(clip.frequency_at(0.2) == near(0.6));
	CHECK(clip.frequency_at(0.45) == near(1.0));
	REQUIRE(clip.transients.size() == 1);
	CHECK(clip.transients[0].time_s == 0.25);
	CHECK(clip.transients[0].amplitude == 0.9);
	CHECK(clip.transients[0].frequency == 0.75);
	CHECK(clip.author == "me");
	CHECK(clip.tags == std::vector<std::string>{ "door", "wood" });
}

TEST_CASE("frequencies may be missing, null or empty") {
	const std::string list = DOOR.substr(DOOR.find("[ { \"time\": 0.1"), 72);
	for (const char *const none : { "[]", "null" }) {
		const Result<HapticClip> read = parse_haptic(with(DOOR, list, none), "door.haptic");
		REQUIRE_MESSAGE(read.ok(), read.error());
		CHECK(read.value().frequency_at(0.1) == 0.5);
	}
	CHECK(error_of(with(DOOR, "\"frequency\": [", "\"other\": [")) == "none");
}

TEST_CASE("a bad .haptic file gets one error with its line") {
	CHECK(error_of("") == "door.haptic:1: not valid JSON: the file ends here");
	CHECK(error_of(DOOR.substr(0, 200)) == "door.haptic:4: not valid JSON: the file ends here");
	CHECK(error_of("[]") == "door.haptic:1: version: missing");
	CHECK(error_of(with(DOOR, "\"major\": 1", "\"major\": 2")) ==
			"door.haptic:2: version: this program reads .haptic files of version 1");
	CHECK(error_of(with(DOOR, "0.3, \"emph", "1.3, \"emph")) ==
			"door.haptic:7: amplitude: not within 0 .. 1, is 1.3");
	CHECK(error_of(with(DOOR, "0.3, \"emph", "NaN, \"emph")) == "door.haptic:7: not valid JSON");
	CHECK(error_of(with(DOOR, "0.75", "\"high\"")) == "door.haptic:7: frequency: not a number");
	CHECK(error_of(with(DOOR, "\"time\": 0.5", "\"time\": 0.2")) ==
			"door.haptic:8: time: before that of the breakpoint ahead of it; sort them by time");
	CHECK(error_of(with(DOOR, "\"time\": 0.5", "\"time\": 1e6")) ==
			"door.haptic:8: time: not within 0 .. 60, is 1e+06");
	CHECK(error_of(with(DOOR, "\"time\": 0.5", "\"time\": 1e999")).starts_with("door.haptic:8: "));
	CHECK(error_of(with(DOOR, "\"envelopes\"", "\"envelope\"")) == "door.haptic:4: envelopes: missing");
	CHECK(error_of(with(with(DOOR, "0.25", "0"), "\"time\": 0.5", "\"time\": 0")) ==
			"door.haptic:5: amplitude: a clip needs two breakpoints at different times");
	CHECK(error_of(std::string(17U << 20U, ' ')) == "door.haptic: larger than 16 MB: no haptic clip");
}

TEST_CASE("a clip that is written reads back the same, with how it is played") {
	HapticClip clip = parse_haptic(DOOR, "door.haptic").value();
	clip.playback.trigger = Trigger::MOVING;
	clip.playback.drive = Drive::VELOCITY;
	clip.playback.gain = 0.25;
	clip.playback.full_scale = 2.5;
	clip.playback.channels = 2;
	clip.playback.range = { 40.0, 300.0 };
	const std::string text = format_haptic(clip);
	const HapticClip again = parse_haptic(text, "again.haptic").value();
	CHECK(format_haptic(again) == text);
	CHECK(again.playback.trigger == Trigger::MOVING);
	CHECK(again.playback.drive == Drive::VELOCITY);
	CHECK(again.playback.gain == 0.25);
	CHECK(again.playback.full_scale == 2.5);
	CHECK(again.playback.channels == 2);
	CHECK(again.playback.range.highest_hz == 300.0);
	for (double t_s = 0.0; t_s < 0.6; t_s += 0.01) {
		CHECK(again.amplitude_at(t_s) == near(clip.amplitude_at(t_s)));
		CHECK(again.frequency_at(t_s) == near(clip.frequency_at(t_s)));
	}
	CHECK(again.transients.size() == 1);
}

TEST_CASE("what is written keeps the format's rules that a clip need not keep") {
	HapticClip clip;
	clip.amplitude = { { 0.1, 0.5 }, { 0.2, 0.5 } };
	clip.frequency = { { 0.0, 0.3 }, { 5.0, 0.4 } };
	clip.transients = { { 0.15, 0.2, 0.5 }, { 0.3, 1.0, 0.5 } };
	const HapticClip again = parse_haptic(format_haptic(clip), "a.haptic").value();
	CHECK(again.frequency.size() == 1);
	REQUIRE(again.transients.size() == 2);
	CHECK(again.transients[0].amplitude == 0.5); // not below the envelope
	CHECK(again.transients[1].time_s == 0.3);
	CHECK(again.duration_s() == near(clip.duration_s()));
	CHECK(again.amplitude_at(0.05) == 0.0);
	CHECK(again.amplitude_at(0.12) == near(0.5));
	CHECK(again.amplitude_at(0.25) == 0.0);
}
