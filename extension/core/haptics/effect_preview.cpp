#include "haptics/effect_preview.h"

#include "gesture/task.h"
#include "haptics/vibration.h"
#include "signal/minimum_jerk.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace steadyhand {

namespace {

constexpr double PERIOD_S = 0.01;
/// Where a start is recognised, in amplitudes.
constexpr double START_LEVEL = 0.1;

MotionSnapshot::Knot knot_at(double t_s) {
	const Polynomial::Point point = minimum_jerk(t_s / PREVIEW_MOVEMENT_S);
	return { point.value, point.first / PREVIEW_MOVEMENT_S,
		point.second / (PREVIEW_MOVEMENT_S * PREVIEW_MOVEMENT_S), point.value < END_LEVEL };
}

MotionSnapshot snapshot_at(double from_s) {
	MotionSnapshot snapshot;
	snapshot.time_s = from_s;
	snapshot.period_s = PERIOD_S;
	snapshot.count = MotionSnapshot::MOST_KNOTS;
	snapshot.amplitude_m = PREVIEW_AMPLITUDE_M;
	for (std::size_t i = 0; i < snapshot.count; ++i) {
		snapshot.knots[i] = knot_at(from_s + PERIOD_S * static_cast<double>(i));
	}
	return snapshot;
}

} // namespace

std::vector<float> preview_of(const Effect &effect, double sample_rate_hz) {
	Vibration vibration(sample_rate_hz, 1);
	EffectSet effects;
	effects.add(effect);
	vibration.set_effects(effects);
	vibration.seek(0.0);
	std::vector<float> samples(
			static_cast<std::size_t>(std::lround(PREVIEW_LENGTH_S * vibration.sample_rate_hz())));
	Arrival arrival, onset;
	std::span<float> left(samples);
	while (!left.empty()) {
		MotionSnapshot snapshot = snapshot_at(vibration.time_s());
		if (const double time_s = snapshot.reaches_s(END_LEVEL, snapshot.time_s);
				arrival.number == 0 && std::isfinite(time_s)) {
			arrival = { 1, time_s, PREVIEW_AMPLITUDE_M * snapshot.at(time_s).velocity };
		}
		if (const double time_s = snapshot.reaches_s(START_LEVEL, snapshot.time_s);
				onset.number == 0 && std::isfinite(time_s)) {
			onset = { 1, time_s, PREVIEW_AMPLITUDE_M * snapshot.at(time_s).velocity };
		}
		snapshot.arrival = arrival;
		snapshot.onset = onset;
		vibration.set_motion(snapshot);
		const std::span<float> run = left.first(std::min(left.size(), RUN));
		vibration.render(run);
		left = left.subspan(run.size());
	}
	return samples;
}

std::vector<float> spectrum_of(
		std::span<const float> samples, double sample_rate_hz, std::span<const float> frequencies_hz) {
	std::vector<float> amplitudes(frequencies_hz.size());
	const double turn = 2.0 * std::numbers::pi;
	std::vector<double> windowed(samples.size());
	for (std::size_t i = 0; i < samples.size(); ++i) {
		const double share = static_cast<double>(i) / static_cast<double>(samples.size());
		windowed[i] = static_cast<double>(samples[i]) * 0.5 * (1.0 - std::cos(turn * share));
	}
	for (std::size_t f = 0; f < frequencies_hz.size(); ++f) {
		const double step = turn * static_cast<double>(frequencies_hz[f]) / sample_rate_hz;
		if (samples.empty() || !(step >= 0.0) || !(step < std::numbers::pi)) {
			continue;
		}
		const double factor = 2.0 * std::cos(step);
		double last = 0.0, before = 0.0;
		for (const double sample : windowed) {
			const double next = sample + factor * last - before;
			before = last;
			last = next;
		}
		const double power = last * last + before * before - factor * last * before;
		// The window's mean is a half.
		amplitudes[f] = static_cast<float>(
				4.0 * std::sqrt(std::max(power, 0.0)) / static_cast<double>(samples.size()));
	}
	return amplitudes;
}

} // namespace steadyhand
