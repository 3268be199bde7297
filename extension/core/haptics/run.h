#pragma once

#include "haptics/oscillator.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace steadyhand {

/// Samples are made in runs of this fixed length, whose loops the compiler turns into vector code on its own.
inline constexpr std::size_t RUN = 64;
using Run = std::array<float, RUN>;

/// A run to which sounds are added.
struct Mix {
	alignas(64) Run samples{};
	bool is_silent = true; ///< nothing has been added
};

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

	/// From the sample number `from` up to `to`.
	[[nodiscard]] bool is_full(float from, float to) const { return from >= ramp && length - to >= ramp; }
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

/// A sine from run to run, its samples by sin(a + b) = sin a cos b + cos a sin b: a is the phase of the run's
/// first sample, b what the sample is ahead of it, from a table made once for a frequency. From run to run a
/// turns by a run in double precision, and comes anew from its 64 bits every EXACT_RUNS. Largest error: 2e-7,
/// by the 24-bit rounding of all numbers. Aligned for whole cache lines: not for memory of the engine's.
class Carrier {
public:
	static constexpr int EXACT_RUNS = 64;

	/// The phase is left where it is. step: of an Oscillator
	void set_step(std::uint64_t step);
	/// Of the next run's first sample.
	void set_phase(std::uint64_t phase);
	/// By this many runs.
	void advance(std::uint64_t runs) {
		oscillator_.advance(RUN * runs);
		if (runs == 1 && --to_exact_ > 0) {
			start_ = start_.turned(over_run_);
		} else if (runs > 0) {
			set_phase(oscillator_.phase);
		}
	}

	[[nodiscard]] std::uint64_t phase() const { return oscillator_.phase; }
	[[nodiscard]] const Phasor &start() const { return start_; }
	/// The sample number i of `start` in 24 bits.
	[[nodiscard]] float at(float sine, float cosine, std::size_t i) const {
		return sine * cosines_[i] + cosine * sines_[i];
	}

private:
	alignas(64) Run sines_{};
	alignas(64) Run cosines_{};
	Oscillator oscillator_;
	Phasor start_, over_run_;
	int to_exact_ = EXACT_RUNS;
};

// Each adds to `out` the samples of one run.

/// level * sine
void add_sine(Mix &out, const Carrier &carrier, const Level &level);

/// scale * decay[i] * sine, from the sample number `first` of the run on.
void add_decaying_sine(Mix &out, const Carrier &carrier, double scale, const Run &decay, std::int32_t first);

/// level * window * sine; the run's first sample is the window's number `at`, which may be negative.
void add_windowed_sine(
		Mix &out, const Carrier &carrier, const Level &level, const Window &window, std::int32_t at);

/// values * window
void add_windowed(Mix &out, const Run &values, const Window &window, std::int32_t at);

void clear(Mix &mix);
void add(Mix &out, const Mix &other);

/// Writes `count` samples from the number `first` on, held to -1..1: of one channel, or of two in turn.
/// A NaN may become any number or stay one.
void write_held(float *frames, const Mix &mono, std::size_t first, std::size_t count);
void write_held(float *frames, const Mix &left, const Mix &right, std::size_t first, std::size_t count);

} // namespace steadyhand
