#include "devices/liberty_protocol.h"

#include <array>
#include <cstddef>

namespace steadyhand {

namespace {

constexpr std::size_t CODE_COUNT = 25;

/// Manual 2.4, in the order of the codes.
constexpr std::array<std::string_view, CODE_COUNT> CODE_TEXTS = { "no error", "invalid command",
	"invalid station", "invalid parameter", "too few parameters", "too many parameters",
	"parameter below its limit", "parameter above its limit", "communication with a sensor processor failed",
	"sensor processor 1 failed to start", "sensor processor 2 failed to start",
	"sensor processor 3 failed to start", "sensor processor 4 failed to start",
	"no sensor processor was found", "the source processor failed to start", "memory error",
	"the command is too long", "the tracker must leave UTH mode first",
	"the source's memory could not be read, so defaults are used", "the command can only read a value",
	"a message that is no error", "the map of the distortion could not be loaded",
	"the sensors are not synchronised", "the firmware parts do not fit together",
	"the firmware of the I/O processor is outdated" };

/// Letters 'a' to 'g': bit 0 of the distance from '`' is the x axis, bit 1 y, bit 2 z.
constexpr std::array<std::string_view, 7> SOURCE_TEXTS = { "the source fails in axis x",
	"the source fails in axis y", "the source fails in axes x and y", "the source fails in axis z",
	"the source fails in axes x and z", "the source fails in axes y and z", "the source fails in all axes" };

constexpr std::array<std::string_view, 7> SOURCE_AND_TEST_TEXTS = {
	"the source fails in axis x and the start-up self-test failed",
	"the source fails in axis y and the start-up self-test failed",
	"the source fails in axes x and y and the start-up self-test failed",
	"the source fails in axis z and the start-up self-test failed",
	"the source fails in axes x and z and the start-up self-test failed",
	"the source fails in axes y and z and the start-up self-test failed",
	"the source fails in all axes and the start-up self-test failed"
};

/// The command in readable form: "'O'", "'^U'", "byte 0".
std::string command_name(char command) {
	const auto byte = static_cast<unsigned char>(command);
	if (byte > 0x20 && byte < 0x7F) {
		return std::string("'") + command + "'";
	}
	constexpr unsigned char LAST_CONTROL = 0x1A;
	if (byte >= 1 && byte <= LAST_CONTROL) {
		return std::string("'^") + static_cast<char>('A' + byte - 1) + "'";
	}
	return "byte " + std::to_string(byte);
}

} // namespace

bool is_liberty_record_fault(std::uint8_t code) {
	return (code >= 'a' && code <= 'g') || (code >= 'A' && code <= 'G') || code == 'I' || code == 'u';
}

std::string_view liberty_error_text(std::uint8_t code) {
	if (code < CODE_COUNT) {
		return CODE_TEXTS[code];
	}
	if (code >= 'a' && code <= 'g') {
		return SOURCE_TEXTS[static_cast<std::size_t>(code - 'a')];
	}
	if (code >= 'A' && code <= 'G') {
		return SOURCE_AND_TEST_TEXTS[static_cast<std::size_t>(code - 'A')];
	}
	if (code == 'I') {
		return "the start-up self-test failed";
	}
	if (code == 'u') {
		return "the sensor is outside the mapped area";
	}
	return "unknown error";
}

std::string liberty_message_text(const LibertyMessage &message) {
	switch (message.kind) {
		case LibertyMessage::Kind::WRONG_RECORD:
			return "Liberty station " + std::to_string(message.record.station) + ": a record has " +
					std::to_string(message.body_size) + " bytes, must have " +
					std::to_string(LIBERTY_RECORD_SIZE) +
					". Another program changed the output list. Close it, then start the tracker again.";
		case LibertyMessage::Kind::REFUSAL: {
			std::string text = "Liberty: command " + command_name(message.command) + " failed with error " +
					std::to_string(message.code) + ": " + std::string(liberty_error_text(message.code)) + ".";
			if (!message.text.empty()) {
				text += " The tracker says \"" + std::string(message.text) + "\".";
			}
			return text + " Switch the tracker off and on if this comes again.";
		}
		case LibertyMessage::Kind::TEXT:
			return "Liberty: the tracker says \"" + std::string(message.text) + "\".";
		case LibertyMessage::Kind::RECORD:
		case LibertyMessage::Kind::STATION_MAP:
			break;
	}
	return {};
}

} // namespace steadyhand
