#include "haptics/wav.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

namespace steadyhand {

namespace {

/// Puts fields one after the other.
class ByteWriter {
public:
	explicit ByteWriter(std::span<std::byte> out) : out_(out) {}

	void text(std::string_view characters) {
		for (const char character : characters) {
			out_[position_++] = static_cast<std::byte>(character);
		}
	}

	/// Little endian.
	template <class Unsigned> void number(Unsigned value) {
		for (std::size_t i = 0; i < sizeof(Unsigned); ++i) {
			out_[position_++] = static_cast<std::byte>((value >> (8 * i)) & 0xFFU);
		}
	}

private:
	std::span<std::byte> out_;
	std::size_t position_ = 0;
};

constexpr std::uint32_t FMT_CHUNK_BYTES = 16;
/// Of the header, what the RIFF chunk's own size counts: all but "RIFF" and the size.
constexpr std::uint32_t RIFF_OVERHEAD_BYTES = WAV_HEADER_BYTES - 8;

} // namespace

std::array<std::byte, WAV_HEADER_BYTES> wav_header(const WavFormat &format, std::uint64_t frames) {
	const auto frame_bytes = static_cast<std::uint16_t>(format.channels * WAV_SAMPLE_BYTES);
	const std::uint64_t most_bytes = std::numeric_limits<std::uint32_t>::max() - RIFF_OVERHEAD_BYTES;
	const std::uint64_t most_frames = frame_bytes > 0 ? most_bytes / frame_bytes : 0;
	const auto data_bytes = static_cast<std::uint32_t>(std::min(frames, most_frames) * frame_bytes);
	constexpr std::uint16_t TAG_PCM = 1;

	std::array<std::byte, WAV_HEADER_BYTES> header{};
	ByteWriter writer(header);
	writer.text("RIFF");
	writer.number(data_bytes + RIFF_OVERHEAD_BYTES);
	writer.text("WAVEfmt ");
	writer.number(FMT_CHUNK_BYTES);
	writer.number(TAG_PCM);
	writer.number(format.channels);
	writer.number(format.sample_rate_hz);
	writer.number(format.sample_rate_hz * frame_bytes);
	writer.number(frame_bytes);
	writer.number(static_cast<std::uint16_t>(8 * WAV_SAMPLE_BYTES));
	writer.text("data");
	writer.number(data_bytes);
	return header;
}

void wav_encode(std::span<const float> samples, std::span<std::byte> out) {
	ByteWriter writer(out);
	for (const float raw : samples) {
		const float sample = std::isnan(raw) ? 0.0F : raw;
		const long rounded = std::lround(std::clamp(sample, -1.0F, 1.0F) * 32767.0F);
		writer.number(static_cast<std::uint16_t>(rounded));
	}
}

} // namespace steadyhand
