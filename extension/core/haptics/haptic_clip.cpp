#include "haptics/haptic_clip.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace steadyhand {
namespace {

constexpr double RADIANS_A_TURN = 2.0 * std::numbers::pi;
constexpr double DEFAULT_FREQUENCY = 0.5; // "typically 0.5": the .haptic specification
constexpr double TRANSIENT_LOWEST_HZ = 55.0, TRANSIENT_HIGHEST_HZ = 165.0;
constexpr double TRANSIENT_PERIODS = 2.0;
constexpr double DUCKED = 0.5;
/// What ends loud dies away within this time: half a period of 250 Hz, so that it does not click.
constexpr double FADE_S = 0.002;

} // namespace

double FrequencyRange::normalised(double frequency_hz) const {
	const double width_hz = highest_hz - lowest_hz;
	return width_hz == 0.0 ? DEFAULT_FREQUENCY : std::clamp((frequency_hz - lowest_hz) / width_hz, 0.0, 1.0);
}

double HapticClip::duration_s() const {
	double end_s = amplitude.empty() ? 0.0 : amplitude.back().time_s;
	for (const Transient &transient : transients) {
		end_s = std::max(end_s, transient.time_s + transient_s(transient));
	}
	return end_s;
}

double HapticClip::amplitude_at(double time_s) const {
	return amplitude.empty() || time_s > amplitude.back().time_s ? 0.0 : value_at(amplitude, time_s, 0.0);
}

double HapticClip::frequency_at(double time_s) const {
	return value_at(frequency, time_s, frequency.empty() ? DEFAULT_FREQUENCY : frequency.front().value);
}

double transient_hz(const Transient &transient) {
	return TRANSIENT_LOWEST_HZ + transient.frequency * (TRANSIENT_HIGHEST_HZ - TRANSIENT_LOWEST_HZ);
}

double transient_s(const Transient &transient) {
	return TRANSIENT_PERIODS / transient_hz(transient);
}

std::vector<float> waveform_of(const HapticClip &clip, double sample_rate_hz) {
	const double end_s = clip.amplitude.empty() ? 0.0 : clip.amplitude.back().time_s;
	const auto count = static_cast<std::size_t>(std::ceil(clip.duration_s() * sample_rate_hz)) + 1;
	std::vector<double> samples(count);
	double turns = 0.0;
	for (std::size_t i = 0; i < count; ++i) {
		const double time_s = static_cast<double>(i) / sample_rate_hz;
		const double fade = std::clamp((end_s - time_s) / FADE_S, 0.0, 1.0);
		samples[i] = fade * clip.amplitude_at(time_s) * std::sin(RADIANS_A_TURN * turns);
		turns += clip.playback.range.hz(clip.frequency_at(time_s)) / sample_rate_hz;
		turns -= std::floor(turns);
	}
	// A click ends where the next one begins, as one actuator plays one at a time.
	for (std::size_t n = 0; n < clip.transients.size(); ++n) {
		const Transient &transient = clip.transients[n];
		const double next_s = n + 1 < clip.transients.size() ? clip.transients[n + 1].time_s : INFINITY;
		const double until_s = std::min(transient.time_s + transient_s(transient), next_s);
		const auto first = static_cast<std::size_t>(std::ceil(transient.time_s * sample_rate_hz));
		for (std::size_t i = first; i < count && static_cast<double>(i) < until_s * sample_rate_hz; ++i) {
			const double since_s = static_cast<double>(i) / sample_rate_hz - transient.time_s;
			samples[i] = DUCKED * samples[i] +
					transient.amplitude * std::sin(RADIANS_A_TURN * transient_hz(transient) * since_s);
		}
	}
	std::vector<float> held(count);
	std::transform(samples.begin(), samples.end(), held.begin(),
			[](double sample) { return static_cast<float>(std::clamp(sample, -1.0, 1.0)); });
	return held;
}

double main_frequency_hz(const HapticClip &clip) {
	double weight = 0.0, sum = 0.0;
	for (std::size_t i = 0; i + 1 < clip.amplitude.size(); ++i) {
		const Breakpoint &from = clip.amplitude[i], &to = clip.amplitude[i + 1];
		const double area = 0.5 * (from.value + to.value) * (to.time_s - from.time_s);
		weight += area;
		sum += area * clip.playback.range.hz(clip.frequency_at(0.5 * (from.time_s + to.time_s)));
	}
	for (const Transient &transient : clip.transients) {
		const double area = transient.amplitude * transient_s(transient);
		weight += area;
		sum += area * transient_hz(transient);
	}
	return weight > 0.0 ? sum / weight : clip.playback.range.hz(DEFAULT_FREQUENCY);
}

} // namespace steadyhand
