#pragma once

#include "base/result.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace steadyhand {

struct WavFormat {
	std::uint32_t sample_rate_hz = 48000;
	std::uint16_t channels = 1;
};

inline constexpr std::size_t WAV_HEADER_BYTES = 44;
inline constexpr std::uint16_t WAV_SAMPLE_BYTES = 2;

/// The bytes before the samples (RIFF WAVE, little endian on any machine). To stream: write the header for 0
/// frames, then frames as they come, and at the end the header for all of them in its place; a file that was
/// cut off still opens. A frame is one sample a channel. What does not fit the format's 4 GiB is left out of
/// the count.
[[nodiscard]] std::array<std::byte, WAV_HEADER_BYTES> wav_header(
		const WavFormat &format, std::uint64_t frames);

/// Samples (channels interleaved) as the file holds them, 16-bit PCM: -1..1 to -32767..32767, rounded, beyond
/// that held; NaN is silence. `out` must have samples.size() * WAV_SAMPLE_BYTES bytes.
void wav_encode(std::span<const float> samples, std::span<std::byte> out);

struct WavSamples {
	WavFormat format;
	std::vector<float> samples; ///< -1..1, of the first channel
};

/// Reads a file of 16-bit PCM at 8 to 192 kHz. One that was cut off ends where it does. The error names
/// source_name.
[[nodiscard]] Result<WavSamples> parse_wav(std::span<const std::byte> bytes, std::string_view source_name);

} // namespace steadyhand
