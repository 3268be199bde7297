// Any bytes are a clip or one error, as a .haptic, an .ahap and a WAV file; what was read is finite, plays
// within full scale, and is written and read back the same.

#include "haptics/ahap_file.h"
#include "haptics/haptic_file.h"
#include "haptics/recorded_clip.h"
#include "haptics/wav.h"
#include "require.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

using namespace steadyhand;
using steadyhand::fuzz::require;

namespace {

/// Longer ones take the time that finds more inputs.
constexpr double RENDERED_S = 2.0;
constexpr double RATE_HZ = 8000.0;

bool is_share(double value) {
	return value >= 0.0 && value <= 1.0;
}

void check_clip(const HapticClip &clip) {
	require(clip.duration_s() > 0.0 && clip.duration_s() < HapticClip::LONGEST_S + 0.1,
			"a clip has a length");
	for (int i = -1; i <= 21; ++i) {
		const double time_s = 0.05 * i * clip.duration_s();
		require(is_share(clip.amplitude_at(time_s)), "an amplitude is within 0..1");
		require(is_share(clip.frequency_at(time_s)), "a frequency is within 0..1");
	}
	require(main_frequency_hz(clip) >= 1.0 && main_frequency_hz(clip) <= 1000.0, "its frequency is felt");
	if (clip.duration_s() < RENDERED_S) {
		for (const float sample : waveform_of(clip, RATE_HZ)) {
			require(std::abs(sample) <= 1.0F, "it plays within full scale");
		}
	}
	const std::string text = format_haptic(clip);
	const Result<HapticClip> again = parse_haptic(text, "a.haptic");
	require(again.ok(), "what is written can be read");
	require(format_haptic(again.value()) == text, "what is read back is written the same");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
	const std::string_view text(reinterpret_cast<const char *>(data), size);
	for (const auto parse : { parse_haptic, parse_ahap }) {
		const Result<HapticClip> read = parse(text, "a.clip");
		if (read) {
			check_clip(read.value());
		} else {
			require(read.error().starts_with("a.clip:"), "an error names the source");
		}
	}
	if (const Result<WavSamples> wav = parse_wav(std::as_bytes(std::span(data, size)), "a.wav")) {
		const HapticClip clip = recorded_clip(wav.value().samples, wav.value().format.sample_rate_hz);
		if (clip.duration_s() > 0.0) {
			check_clip(clip);
		}
	} else {
		require(wav.error().starts_with("a.wav:"), "an error names the source");
	}
	return 0;
}
