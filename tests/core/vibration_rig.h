#pragma once

#include "haptics/vibration.h"
#include "signal/minimum_jerk.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

namespace steadyhand::test {

inline constexpr long double TURN = 2.0L * std::numbers::pi_v<long double>;
/// Sine polynomial, 24-bit rounding of phase, level and products, together.
inline constexpr double SAMPLE_ERROR = 1e-6;
inline constexpr double SAMPLE_RATES_HZ[] = { 8000.0, 11025.0, 44100.0, 48000.0, 96000.0, 192000.0 };
inline constexpr double AMPLITUDE_M = 0.2;

/// A minimum-jerk movement from 0 to 1 that begins at 0 s; a gesture until it is at 95 %.
struct Movement {
	double duration_s;

	[[nodiscard]] MotionPoint at(double t_s) const {
		const double rate = 1.0 / duration_s;
		const Polynomial::Point point = minimum_jerk(t_s * rate);
		return { point.value, point.first * rate, point.second * rate * rate, 0.0 };
	}
	[[nodiscard]] MotionSnapshot::Knot knot(double t_s) const {
		const MotionPoint point = at(t_s);
		return { point.position, point.velocity, point.acceleration, point.position < 0.95 };
	}
	/// When it is at 95 %, by bisection.
	[[nodiscard]] double end_s() const {
		double low = 0.0, high = duration_s;
		for (int i = 0; i < 60; ++i) {
			const double middle = 0.5 * (low + high);
			(at(middle).position < 0.95 ? low : high) = middle;
		}
		return high;
	}
	/// From from_s on; 10 ms between its knots.
	[[nodiscard]] MotionSnapshot snapshot(double from_s) const {
		MotionSnapshot snapshot;
		snapshot.time_s = from_s;
		snapshot.period_s = 0.01;
		snapshot.count = 11;
		snapshot.amplitude_m = AMPLITUDE_M;
		for (std::size_t i = 0; i < snapshot.count; ++i) {
			snapshot.knots[i] = knot(from_s + 0.01 * static_cast<double>(i));
		}
		return snapshot;
	}
};

/// One that stays at a place.
inline MotionSnapshot still(double from_s, double position) {
	MotionSnapshot snapshot;
	snapshot.time_s = from_s;
	snapshot.period_s = 0.05;
	snapshot.count = 2;
	snapshot.amplitude_m = AMPLITUDE_M;
	snapshot.knots[0] = snapshot.knots[1] = { position, 0.0, 0.0, true };
	return snapshot;
}

inline EffectSet set_of(const Effect &effect) {
	EffectSet set;
	set.add(effect);
	return set;
}

inline std::vector<float> render(Vibration &vibration, std::size_t samples) {
	std::vector<float> out(samples);
	vibration.render(out);
	return out;
}

inline constexpr double RATE_HZ = 48000.0;
inline constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();

/// From a snapshot each 384 samples of a movement, as it is played on the motion's own clock. Knots are at
/// whole hundredths of a second, where the movement may begin and end.
inline std::vector<float> play(Vibration &vibration, const Movement &movement, std::size_t samples,
		std::size_t block = 384, const Arrival &expected = {}) {
	std::vector<float> out(samples);
	vibration.seek(0.0);
	for (std::size_t done = 0; done < samples; done += 384) {
		const double now_s = static_cast<double>(done) / vibration.sample_rate_hz();
		MotionSnapshot snapshot = movement.snapshot(0.01 * std::floor(100.0 * now_s));
		snapshot.expected = expected;
		vibration.set_motion(snapshot);
		const std::span<float> part =
				std::span(out).subspan(done, std::min<std::size_t>(384, samples - done));
		for (std::size_t at = 0; at < part.size(); at += block) {
			vibration.render(part.subspan(at, std::min(block, part.size() - at)));
		}
	}
	return out;
}

inline double sine_at(double frequency_hz, double t_s) {
	return static_cast<double>(std::sin(TURN * frequency_hz * static_cast<long double>(t_s)));
}

/// Largest difference from a function of the sample's time.
template <class Truth>
double largest_error(std::span<const float> samples, double rate_hz, Truth truth, std::size_t from = 0) {
	double largest = 0.0;
	for (std::size_t i = from; i < samples.size(); ++i) {
		const double t_s = static_cast<double>(i) / rate_hz;
		largest = std::max(largest, std::abs(static_cast<double>(samples[i]) - truth(t_s)));
	}
	return largest;
}

inline double largest_step(std::span<const float> samples) {
	double largest = 0.0;
	for (std::size_t i = 1; i < samples.size(); ++i) {
		largest = std::max(
				largest, std::abs(static_cast<double>(samples[i]) - static_cast<double>(samples[i - 1])));
	}
	return largest;
}

/// Of a full-scale sine.
inline double step_bound(double frequency_hz, double rate_hz) {
	return 2.0 * std::sin(std::numbers::pi * std::min(frequency_hz / rate_hz, 0.5));
}

inline Arrival at(std::uint32_t number, double time_s) {
	return { number, time_s, 0.6 };
}

} // namespace steadyhand::test
