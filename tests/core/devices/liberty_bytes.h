#pragma once

#include "devices/liberty_protocol.h"

#include <bit>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Bytes as the Liberty's manual writes them, made without the parser's code.
namespace steadyhand::liberty_bytes {

using Bytes = std::vector<std::uint8_t>;

/// "4c 59" as two bytes.
inline Bytes from_hex(std::string_view hex) {
	Bytes bytes;
	for (std::size_t i = 0; i + 1 < hex.size(); i += 3) {
		bytes.push_back(static_cast<std::uint8_t>(std::stoi(std::string(hex.substr(i, 2)), nullptr, 16)));
	}
	return bytes;
}

inline Bytes from_text(std::string_view text) {
	return { text.begin(), text.end() };
}

inline Bytes operator+(Bytes left, const Bytes &right) {
	left.insert(left.end(), right.begin(), right.end());
	return left;
}

template <class Number> Bytes little_endian(Number number) {
	Bytes bytes;
	for (std::size_t i = 0; i < sizeof number; ++i) {
		bytes.push_back(static_cast<std::uint8_t>(number >> (8 * i) & 0xFFU));
	}
	return bytes;
}

inline Bytes float_bytes(float number) {
	return little_endian(std::bit_cast<std::uint32_t>(number));
}

inline Bytes header(std::uint8_t station, std::uint8_t command, std::uint8_t fault, std::size_t size) {
	return Bytes{ 'L', 'Y', station, command, fault, 0 } + little_endian(static_cast<std::uint16_t>(size));
}

/// A streamed record at (x, y, z) cm with the identity quaternion.
inline Bytes record(std::uint8_t station, std::uint32_t frame, float x, float y, float z,
		std::uint8_t fault = 0, float w = 1.0F) {
	return header(station, 'C', fault, 40) + little_endian(frame * 1000U / 240U) + little_endian(frame) +
			little_endian(std::uint32_t{ 0 }) + float_bytes(x) + float_bytes(y) + float_bytes(z) +
			float_bytes(w) + float_bytes(0) + float_bytes(0) + float_bytes(0);
}

/// The worked example: station 1, frame 3000, position (10, -2.5, 30) cm.
inline Bytes worked_record() {
	return from_hex("4c 59 01 43 00 00 28 00 d4 30 00 00 b8 0b 00 00 00 00 00 00 00 00 20 41 00 00 20 c0 "
					"00 00 f0 41 00 00 80 3f 00 00 00 00 00 00 00 00 00 00 00 00");
}

/// A message that owns its text.
struct Read : LibertyMessage {
	explicit Read(const LibertyMessage &message) : LibertyMessage(message), owned(message.text) {}
	std::string owned;
};

/// All messages of `bytes`, fed in pieces of `piece` bytes.
inline std::vector<Read> read_all(
		LibertyParser &parser, std::span<const std::uint8_t> bytes, std::size_t piece) {
	std::vector<Read> messages;
	for (std::size_t i = 0; i < bytes.size(); i += piece) {
		parser.feed(bytes.subspan(i, std::min(piece, bytes.size() - i)));
		LibertyMessage message;
		while (parser.next(message)) {
			messages.emplace_back(message);
		}
	}
	return messages;
}

inline std::vector<Read> read_all(const Bytes &bytes) {
	LibertyParser parser;
	return read_all(parser, bytes, bytes.size());
}

} // namespace steadyhand::liberty_bytes
