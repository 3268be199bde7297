#include "haptics/recorded_clip.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace steadyhand {
namespace {

constexpr double ENVELOPE_ERROR = 0.02;
/// Weaker than this is silence: some thirty steps of a 16-bit file.
constexpr double SILENT = 1e-3;
/// Slower than this is no vibration: what hands feel begins at about 20 Hz.
constexpr double SLOWEST_HZ = 20.0;
constexpr double HALVED_S = 0.015;
constexpr double LONGEST_BURST_S = 0.06;

/// From one change of sign to the next.
struct HalfWave {
	double begin_s = 0.0, end_s = 0.0;
	double peak_s = 0.0, peak = 0.0;

	[[nodiscard]] double frequency_hz() const { return 0.5 / (end_s - begin_s); }
	[[nodiscard]] bool is_silent() const { return peak < SILENT || frequency_hz() < SLOWEST_HZ; }
};

/// The top of the parabola through the largest sample and its neighbours.
void set_peak(HalfWave &r_wave, std::span<const float> samples, std::size_t largest, double sample_rate_hz) {
	const auto size_at = [&](std::size_t i) { return std::abs(static_cast<double>(samples[i])); };
	r_wave.peak = size_at(largest);
	r_wave.peak_s = static_cast<double>(largest) / sample_rate_hz;
	if (largest == 0 || largest + 1 >= samples.size()) {
		return;
	}
	const double before = size_at(largest - 1), after = size_at(largest + 1);
	const double bend = before - 2.0 * r_wave.peak + after;
	if (bend < 0.0) {
		const double shift = std::clamp(0.5 * (before - after) / bend, -0.5, 0.5);
		r_wave.peak_s += shift / sample_rate_hz;
		r_wave.peak = std::min(r_wave.peak - 0.25 * (before - after) * shift, 1.0);
	}
}

std::vector<HalfWave> half_waves(std::span<const float> samples, double sample_rate_hz) {
	std::vector<HalfWave> waves;
	HalfWave wave;
	std::size_t largest = 0;
	const auto end_wave = [&](double end_s) {
		wave.end_s = end_s;
		set_peak(wave, samples, largest, sample_rate_hz);
		wave.peak_s = std::clamp(wave.peak_s, wave.begin_s, std::max(wave.begin_s, wave.end_s));
		if (wave.end_s > wave.begin_s && !wave.is_silent()) {
			waves.push_back(wave);
		}
		wave.begin_s = end_s;
	};
	for (std::size_t i = 1; i < samples.size(); ++i) {
		const auto from = static_cast<double>(samples[i - 1]), to = static_cast<double>(samples[i]);
		if (from == 0.0 || (from < 0.0) != (to < 0.0)) {
			const double share = from == 0.0 ? 0.0 : from / (from - to);
			end_wave((static_cast<double>(i - 1) + share) / sample_rate_hz);
			largest = i;
		} else if (std::abs(to) > std::abs(static_cast<double>(samples[largest]))) {
			largest = i;
		}
	}
	if (!samples.empty()) {
		end_wave(static_cast<double>(samples.size() - 1) / sample_rate_hz);
	}
	return waves;
}

/// Half waves without silence between them.
using Sound = std::span<const HalfWave>;

std::size_t sound_length(Sound waves) {
	std::size_t length = 1;
	while (length < waves.size() && waves[length].begin_s - waves[length - 1].end_s < 0.5 / SLOWEST_HZ) {
		++length;
	}
	return length;
}

Sound::iterator strongest_of(Sound sound) {
	return std::max_element(sound.begin(), sound.end(),
			[](const HalfWave &one, const HalfWave &other) { return one.peak < other.peak; });
}

bool is_impulse(Sound sound) {
	const auto strongest = strongest_of(sound);
	const double begin_s = sound.front().begin_s;
	return strongest - sound.begin() <= 1 && sound.back().end_s - begin_s <= LONGEST_BURST_S &&
			std::all_of(sound.begin(), sound.end(), [&](const HalfWave &wave) {
				return wave.peak_s - begin_s < HALVED_S || wave.peak < 0.5 * strongest->peak;
			});
}

} // namespace

HapticClip recorded_clip(std::span<const float> samples, double sample_rate_hz, const FrequencyRange &range) {
	const auto most = static_cast<std::size_t>(HapticClip::LONGEST_S * sample_rate_hz);
	std::vector<float> finite(
			samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(std::min(samples.size(), most)));
	for (float &sample : finite) {
		sample = std::isfinite(sample) ? std::clamp(sample, -1.0F, 1.0F) : 0.0F;
	}
	const std::vector<HalfWave> waves = half_waves(finite, sample_rate_hz);
	const double end_s = static_cast<double>(finite.size()) / sample_rate_hz;
	std::vector<Breakpoint> amplitude{ { 0.0, 0.0 } }, frequency;
	HapticClip clip;
	clip.playback.range = range;
	for (Sound left(waves); !left.empty();) {
		const Sound sound = left.first(sound_length(left));
		left = left.subspan(sound.size());
		if (is_impulse(sound)) {
			clip.transients.push_back({ sound.front().begin_s, strongest_of(sound)->peak,
					range.normalised(sound.front().frequency_hz()) });
			continue;
		}
		amplitude.push_back({ sound.front().begin_s, 0.0 });
		for (const HalfWave &wave : sound) {
			amplitude.push_back({ wave.peak_s, wave.peak });
			frequency.push_back({ wave.peak_s, range.normalised(wave.frequency_hz()) });
		}
		amplitude.push_back({ sound.back().end_s, 0.0 });
	}
	amplitude.push_back({ end_s, 0.0 });
	clip.amplitude = simplified(amplitude, ENVELOPE_ERROR);
	clip.frequency = simplified(frequency, ENVELOPE_ERROR);
	return clip;
}

} // namespace steadyhand
