#include "devices/liberty_sequence.h"

#include "devices/liberty_protocol.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace steadyhand {

namespace {

using Then = LibertyStep::Then;

/// s. A streaming tracker sends at least every 8.3 ms. After this time without data it has stopped.
constexpr double SILENCE_S = 0.1;
/// s. The tracker's own buffer empties within 0.2 s; a tracker that still streams after this did not receive
/// the command.
constexpr double DISCARD_TIMEOUT_S = 1.5;
/// s. A refusal comes within a few milliseconds; a command that is accepted has no answer.
constexpr double CHECK_S = 0.05;
/// s. Three attempts at an answer, each as long as the longest read time-out of the known drivers.
constexpr double ANSWER_S = 1.0;
constexpr double ANSWER_TIMEOUT_S = 3.0;
/// s. A sensor's data starts about 1 s after it was plugged in.
constexpr double FIRST_RECORD_TIMEOUT_S = 3.0;

LibertyStep setting(std::string bytes, std::string_view aim) {
	return { std::move(bytes), Then::CHECK, CHECK_S, CHECK_S, aim };
}

std::string hemisphere_command(const Eigen::Vector3d &vector) {
	// Four digits turn the vector by less than 0.01 degrees. "%.4f" follows the locale, which may write
	// commas.
	std::string command = "h*";
	for (const double coordinate : vector.norm() > 0.0 ? Eigen::Vector3d(vector.normalized()) : vector) {
		const long scaled = std::lround(coordinate * 1e4);
		std::array<char, 32> text{};
		std::snprintf(text.data(), text.size(), ",%s%ld.%04ld", scaled < 0 ? "-" : "",
				std::labs(scaled) / 10000, std::labs(scaled) % 10000);
		command += text.data();
	}
	return command + "\r";
}

} // namespace

std::optional<Error> check(const LibertySettings &settings) {
	if (settings.rate_hz != 120 && settings.rate_hz != 240) {
		return Error{ "Liberty: the rate must be 120 or 240 Hz, is " + std::to_string(settings.rate_hz) +
			"." };
	}
	if (!settings.hemisphere.allFinite()) {
		return Error{ "Liberty: the hemisphere must be a vector of finite numbers." };
	}
	return std::nullopt;
}

std::vector<LibertyStep> liberty_start_steps(const LibertySettings &settings) {
	std::vector<LibertyStep> steps;
	// A program that crashed may have left a stream, or half a command that the carriage return ends. "p"
	// stops a stream and needs no carriage return. A tracker that does not stream answers with one record.
	steps.push_back({ "\rp", Then::DISCARD, SILENCE_S, DISCARD_TIMEOUT_S, "stop the stream of before" });
	// Binary records are short and exact, and contain their length. This step is the first, because it
	// changes the form of answers.
	steps.push_back(setting("f1\r", "switch to binary records"));
	// The first command with an answer. It shows that the tracker responds, and which sensors are plugged in.
	steps.push_back({ std::string("\x15") + "0\r", Then::STATION_MAP, ANSWER_S, ANSWER_TIMEOUT_S,
			"read which sensors are plugged in" });
	// The parser expects centimetres. The default is inches.
	steps.push_back(setting("U1\r", "switch to centimetres"));
	// The rate is always set, because another than the default of 240 Hz may be stored in the tracker.
	steps.push_back(setting(settings.rate_hz == 120 ? "R3\r" : "R4\r", "set the rate"));
	// Without it the tracker may report the mirror image of a position.
	steps.push_back(setting(hemisphere_command(settings.hemisphere), "set the hemisphere"));
	if (settings.filters_off) {
		// The recogniser has its own filter with a known latency. The tracker's filters are adaptive.
		steps.push_back(setting("X0,1,0,0\r", "switch the position filter off"));
		steps.push_back(setting("Y0,1,0,0\r", "switch the attitude filter off"));
	}
	// Feedback needs only the newest record. The tracker's buffer would delay records by 0.2 s after an
	// overload. Without it, an overload leaves a gap in the frame count.
	steps.push_back(setting("@B0\r", "switch the output buffer off"));
	// The frame count is the exact clock, and the time stamp verifies it. The distortion level reports metal.
	steps.push_back(setting(std::string(LIBERTY_OUTPUT_LIST) + "\r", "set the output list"));
	// The counts start near 0, so that they roll over after months and not during a session.
	steps.push_back(setting("Q0\r", "set the clock to zero"));
	steps.push_back({ "c\r", Then::STREAM, 0.0, FIRST_RECORD_TIMEOUT_S, "start the stream" });
	return steps;
}

std::vector<LibertyStep> liberty_stop_steps() {
	// A tracker that still streams would send old records to the next program.
	return { { "p", Then::DISCARD, SILENCE_S, DISCARD_TIMEOUT_S, "stop the stream" } };
}

} // namespace steadyhand
