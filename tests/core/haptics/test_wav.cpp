#include "haptics/wav.h"

#include <doctest/doctest.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

using namespace steadyhand;

namespace {

std::uint32_t number_at(std::span<const std::byte> bytes, std::size_t offset, std::size_t size) {
	std::uint32_t value = 0;
	for (std::size_t i = 0; i < size; ++i) {
		value |= std::to_integer<std::uint32_t>(bytes[offset + i]) << (8 * i);
	}
	return value;
}

std::string hex(std::span<const std::byte> bytes) {
	std::string text;
	for (const std::byte byte : bytes) {
		text += "0123456789abcdef"[std::to_integer<int>(byte) >> 4];
		text += "0123456789abcdef"[std::to_integer<int>(byte) & 15];
	}
	return text;
}

} // namespace

TEST_CASE("the header of a mono 16-bit file is the one that Python's wave module writes") {
	// wave.open(...); setnchannels(1); setsampwidth(2); setframerate(44100); writeframes of 1000 frames.
	CHECK(hex(wav_header({ 44100, 1, WavSample::PCM16 }, 1000)) ==
			"52494646f407000057415645666d7420100000000100"
			"010044ac0000885801000200100064617461d0070000");
	CHECK(hex(wav_header({ 192000, 2, WavSample::PCM16 }, 7)) ==
			"524946464000000057415645666d7420100000000100"
			"020000ee020000b80b0004001000646174611c000000");
}

TEST_CASE("a float header names IEEE float and its sizes") {
	const auto header = wav_header({ 48000, 2, WavSample::FLOAT32 }, 10);
	CHECK(number_at(header, 4, 4) == 36 + 80);
	CHECK(number_at(header, 20, 2) == 3);
	CHECK(number_at(header, 22, 2) == 2);
	CHECK(number_at(header, 24, 4) == 48000);
	CHECK(number_at(header, 28, 4) == 48000 * 8);
	CHECK(number_at(header, 32, 2) == 8);
	CHECK(number_at(header, 34, 2) == 32);
	CHECK(number_at(header, 40, 4) == 80);
}

TEST_CASE("a stream's first header says no frames, and one beyond 4 GiB whole frames only") {
	CHECK(number_at(wav_header({}, 0), 40, 4) == 0);
	CHECK(number_at(wav_header({}, 0), 4, 4) == 36);
	const auto header =
			wav_header({ 48000, 2, WavSample::FLOAT32 }, std::numeric_limits<std::uint64_t>::max());
	const std::uint64_t data_bytes = number_at(header, 40, 4);
	CHECK(data_bytes % 8 == 0);
	CHECK(number_at(header, 4, 4) == data_bytes + 36); // not wrapped around
	CHECK(data_bytes > 0xFFFFFF00U);
	CHECK(number_at(wav_header({ 48000, 0, WavSample::PCM16 }, 10), 40, 4) == 0);
}

TEST_CASE("16-bit samples are rounded, held to full scale, and silent where there is no number") {
	const float infinity = std::numeric_limits<float>::infinity();
	const std::vector<float> samples{ 0.0F, 1.0F, -1.0F, 0.5F, 2.0F, -infinity, infinity,
		std::numeric_limits<float>::quiet_NaN(), 1.0F / 32767.0F };
	std::vector<std::byte> bytes(samples.size() * 2);
	wav_encode(samples, WavSample::PCM16, bytes);
	const int expected[] = { 0, 32767, -32767, 16384, 32767, -32767, 32767, 0, 1 };
	for (std::size_t i = 0; i < samples.size(); ++i) {
		CHECK(static_cast<std::int16_t>(number_at(bytes, 2 * i, 2)) == expected[i]);
	}
}

TEST_CASE("float samples are kept to the bit, but for what is no number") {
	const std::vector<float> samples{ 0.1F, -3.5F, std::numeric_limits<float>::quiet_NaN(), 1e-40F };
	std::vector<std::byte> bytes(samples.size() * 4);
	wav_encode(samples, WavSample::FLOAT32, bytes);
	CHECK(std::bit_cast<float>(number_at(bytes, 0, 4)) == 0.1F);
	CHECK(std::bit_cast<float>(number_at(bytes, 4, 4)) == -3.5F);
	CHECK(number_at(bytes, 8, 4) == 0);
	CHECK(std::bit_cast<float>(number_at(bytes, 12, 4)) == 1e-40F);
}
