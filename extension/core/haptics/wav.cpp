#include "haptics/wav.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
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

Result<WavSamples> parse_wav(std::span<const std::byte> bytes, std::string_view source_name) {
	const auto refused = [&](const char *what) {
		return Error{ std::string(source_name) + ": " + what +
			"; save it as 16-bit PCM WAV at 8 to 192 kHz" };
	};
	const auto number = [&](std::size_t at, std::size_t size) {
		std::uint32_t value = 0;
		for (std::size_t i = 0; i < size; ++i) {
			value |= std::to_integer<std::uint32_t>(bytes[at + i]) << (8 * i);
		}
		return value;
	};
	const auto has_name = [&](std::size_t at, std::string_view name) {
		return at + name.size() <= bytes.size() &&
				std::equal(name.begin(), name.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
						[](char letter, std::byte byte) { return static_cast<std::byte>(letter) == byte; });
	};
	if (!has_name(0, "RIFF") || !has_name(8, "WAVE")) {
		return refused("no WAV file");
	}
	WavSamples wav;
	wav.format.channels = 0;
	constexpr std::size_t CHUNK_HEADER_BYTES = 8, FORMAT_BYTES = 16;
	for (std::size_t at = 12; at + CHUNK_HEADER_BYTES <= bytes.size();) {
		const std::size_t size = number(at + 4, 4), content = at + CHUNK_HEADER_BYTES;
		if (has_name(at, "fmt ") && content + FORMAT_BYTES <= bytes.size()) {
			constexpr std::uint32_t PCM = 1;
			if (number(content, 2) != PCM || number(content + 14, 2) != 8 * WAV_SAMPLE_BYTES) {
				return refused("its samples are not 16-bit PCM");
			}
			wav.format.channels = static_cast<std::uint16_t>(number(content + 2, 2));
			wav.format.sample_rate_hz = number(content + 4, 4);
		} else if (has_name(at, "data") && wav.format.channels > 0) {
			const std::size_t frame = WAV_SAMPLE_BYTES * std::size_t{ wav.format.channels };
			const std::size_t end = content + std::min(size, bytes.size() - content);
			constexpr float LARGEST = 32767.0F; // as wav_encode() writes
			for (std::size_t place = content; place + frame <= end; place += frame) {
				const auto value = static_cast<std::int16_t>(number(place, WAV_SAMPLE_BYTES));
				wav.samples.push_back(std::max(static_cast<float>(value) / LARGEST, -1.0F));
			}
			break;
		}
		at = content + size + size % 2;
	}
	constexpr std::uint32_t LOWEST_HZ = 8000, HIGHEST_HZ = 192000;
	if (wav.samples.empty()) {
		return refused("it has no samples");
	}
	if (wav.format.sample_rate_hz < LOWEST_HZ || wav.format.sample_rate_hz > HIGHEST_HZ) {
		return refused("its sample rate is not within 8 to 192 kHz");
	}
	return wav;
}

} // namespace steadyhand
