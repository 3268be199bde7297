#pragma once

#include "haptics/vibration.h"
#include "signal/minimum_jerk.h"

#include <cmath>
#include <cstddef>
#include <numbers>
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

} // namespace steadyhand::test
