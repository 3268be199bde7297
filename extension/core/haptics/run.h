#pragma once

#include "haptics/oscillator.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace steadyhand {

/// Samples are made in runs of this fixed length, whose loops the compiler turns into vector code on its own.
/// Within a run the phase counts in 32 bits, which after 64 steps is off by 2^-26 turns at most; each run
/// starts from the 64-bit phase again.
inline constexpr std::size_t RUN = 64;
using Run = std::array<float, RUN>;

/// An amplitude over a run, a cubic of the sample's number.
struct Level {
	float constant = 0.0F, linear = 0.0F, quadratic = 0.0F, cubic = 0.0F;

	/// The one with these values and slopes (a run) at the run's ends. A motion's amplitude differs from it
	/// by at most the run's length to the fourth power x its fourth derivative / 384.
	[[nodiscard]] static Level hermite(double from, double from_slope, double to, double to_slope) {
		constexpr double A = 1.0 / static_cast<double>(RUN);
		return { static_cast<float>(from), static_cast<float>(A * from_slope),
			static_cast<float>(A * A * (3.0 * (to - from) - 2.0 * from_slope - to_slope)),
			static_cast<float>(A * A * A * (2.0 * (from - to) + from_slope + to_slope)) };
	}
	[[nodiscard]] float at(float sample) const {
		return ((cubic * sample + quadratic) * sample + linear) * sample + constant;
	}
	[[nodiscard]] bool is_zero() const {
		return constant == 0.0F && linear == 0.0F && quadratic == 0.0F && cubic == 0.0F;
	}
};

/// Part of a sound that swells from nothing at its first sample (number 0) and dies away to nothing at its
/// last, each over `ramp` samples; nothing outside. The ramps are 3 s^2 - 2 s^3.
struct Window {
	float ramp = 1.0F, length = 0.0F;

	[[nodiscard]] float at(float sample) const {
		const float in = held(sample / ramp);
		const float out = held((length - sample) / ramp);
		return in * in * (3.0F - 2.0F * in) * (out * out * (3.0F - 2.0F * out));
	}

private:
	[[nodiscard]] static float held(float share) {
		const float positive = share > 0.0F ? share : 0.0F;
		return positive < 1.0F ? positive : 1.0F;
	}
};

/// sin(2 pi phase) of a phase in 2^-32 turns; largest error, with its 24-bit rounding: 5e-7. It is sin(pi x)
/// for x in -1..1 as x (1 - x^2) Q(x^2), Q of degree 4 for the least largest error (1.1e-7, found by
/// reweighted least squares). The roots at -1, 0 and 1 are exact, and no case needs a branch.
[[nodiscard]] inline float sine(std::uint32_t phase) {
	// As a signed number the phase lies within half a turn of 0.
	const float x = static_cast<float>(static_cast<std::int32_t>(phase)) * 0x1p-31F;
	const float z = x * x;
	float q = 5.9733399e-3F;
	q = q * z - 7.4459445e-2F;
	q = q * z + 5.2378049e-1F;
	q = q * z - 2.0260838F;
	q = q * z + 3.1415913F;
	return x * (1.0F - z) * q;
}

// Each adds to `out` the samples of one run; the oscillator's phase is that of the run's first sample.

/// level * sine
void add_sine(Run &out, const Oscillator &oscillator, const Level &level);

/// scale * decay[i] * sine, from the sample number `first` of the run on.
void add_decaying_sine(
		Run &out, const Oscillator &oscillator, float scale, const Run &decay, std::int32_t first);

/// level * window * sine; the run's first sample is the window's number `at`, which may be negative.
void add_windowed_sine(
		Run &out, const Oscillator &oscillator, const Level &level, const Window &window, std::int32_t at);

/// values * window
void add_windowed(Run &out, const Run &values, const Window &window, std::int32_t at);

/// Holds to -1..1; adds `other` before.
void hold(Run &out);
void add_held(Run &out, const Run &other);

} // namespace steadyhand
