#include "haptics/wav.h"

#include <doctest/doctest.h>

#include <cmath>
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
	CHECK(hex(wav_header({ 44100, 1 }, 1000)) ==
			"52494646f407000057415645666d7420100000000100"
			"010044ac0000885801000200100064617461d0070000");
	CHECK(hex(wav_header({ 192000, 2 }, 7)) ==
			"524946464000000057415645666d7420100000000100"
			"020000ee020000b80b0004001000646174611c000000");
}

TEST_CASE("a stream's first header says no frames, and one beyond 4 GiB whole frames only") {
	CHECK(number_at(wav_header({}, 0), 40, 4) == 0);
	CHECK(number_at(wav_header({}, 0), 4, 4) == 36);
	const auto header = wav_header({ 48000, 2 }, std::numeric_limits<std::uint64_t>::max());
	const std::uint64_t data_bytes = number_at(header, 40, 4);
	CHECK(data_bytes % 4 == 0);
	CHECK(number_at(header, 4, 4) == data_bytes + 36); // not wrapped around
	CHECK(data_bytes > 0xFFFFFF00U);
	CHECK(number_at(wav_header({ 48000, 0 }, 10), 40, 4) == 0);
}

TEST_CASE("16-bit samples are rounded, held to full scale, and silent where there is no number") {
	const float infinity = std::numeric_limits<float>::infinity();
	const std::vector<float> samples{ 0.0F, 1.0F, -1.0F, 0.5F, 2.0F, -infinity, infinity,
		std::numeric_limits<float>::quiet_NaN(), 1.0F / 32767.0F };
	std::vector<std::byte> bytes(samples.size() * 2);
	wav_encode(samples, bytes);
	const int expected[] = { 0, 32767, -32767, 16384, 32767, -32767, 32767, 0, 1 };
	for (std::size_t i = 0; i < samples.size(); ++i) {
		CHECK(static_cast<std::int16_t>(number_at(bytes, 2 * i, 2)) == expected[i]);
	}
}

TEST_CASE("a WAV file reads back what was written, to half a step of 16 bits") {
	const std::vector<float> samples{ 0.0F, 0.5F, -0.25F, 1.0F, -1.0F };
	const auto header = wav_header({ 44100, 1 }, samples.size());
	std::vector<std::byte> bytes(header.begin(), header.end());
	bytes.resize(bytes.size() + samples.size() * WAV_SAMPLE_BYTES);
	wav_encode(samples, std::span(bytes).subspan(WAV_HEADER_BYTES));
	const Result<WavSamples> read = parse_wav(bytes, "a.wav");
	REQUIRE(read.ok());
	CHECK(read.value().format.sample_rate_hz == 44100);
	REQUIRE(read.value().samples.size() == samples.size());
	for (std::size_t i = 0; i < samples.size(); ++i) {
		CHECK(std::abs(read.value().samples[i] - samples[i]) <= 0.5F / 32767.0F);
	}
	bytes.resize(bytes.size() - 3);
	CHECK(parse_wav(bytes, "a.wav").value().samples.size() == 3);
	bytes.resize(20);
	CHECK(parse_wav(bytes, "a.wav").error() ==
			"a.wav: it has no samples; save it as 16-bit PCM WAV at 8 to 192 kHz");
	CHECK(parse_wav({}, "a.wav").error().starts_with("a.wav: no WAV file; "));
}
