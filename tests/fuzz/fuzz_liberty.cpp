// Any bytes of a Liberty, however they are cut, give messages of finite poses, and all bytes are accounted
// for.

#include "devices/liberty_protocol.h"
#include "require.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

using namespace steadyhand;
using steadyhand::fuzz::require;

namespace {

void check_record(const LibertyRecord &record) {
	require(record.station >= 1 && record.station <= LIBERTY_STATION_COUNT, "a station is 1..16");
	if (record.is_tracked) {
		require(record.position_m.allFinite() && record.source_position_m.allFinite(),
				"a tracked position is finite");
		require(std::abs(record.rotation.norm() - 1.0) < 1e-3, "a tracked rotation is of unit length");
	}
}

void check_message(const LibertyMessage &message) {
	if (message.kind == LibertyMessage::Kind::RECORD) {
		check_record(message.record);
	}
	if (message.kind == LibertyMessage::Kind::STATION_MAP) {
		require(message.stations < (1U << LIBERTY_STATION_COUNT), "there are 16 stations at most");
	}
	require(message.body_size <= LibertyParser::BODY_SIZE_MAX, "a body is no longer than its limit");
	const std::string text = liberty_message_text(message);
	require(text.size() < 2 * LibertyParser::BODY_SIZE_MAX, "a message's text stays short");
}

} // namespace

/// The first byte says how long the transfers are.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
	if (size == 0) {
		return 0;
	}
	static LibertyParser parser;
	parser = LibertyParser();
	const std::size_t transfer = 1 + 4 * std::size_t{ data[0] };
	std::span<const std::uint8_t> left(data + 1, size - 1);
	std::size_t messages = 0;
	while (!left.empty()) {
		const std::size_t length = std::min(transfer, left.size());
		parser.feed(left.first(length));
		left = left.subspan(length);
		LibertyMessage message;
		while (parser.next(message)) {
			check_message(message);
			require(++messages <= size, "a message takes at least a byte");
		}
		require(parser.waiting_bytes() <= LibertyParser::CAPACITY,
				"no more bytes wait than there is room for");
	}
	require(parser.skipped_bytes() + parser.waiting_bytes() + messages <= size,
			"no more bytes are skipped than came");
	return 0;
}
