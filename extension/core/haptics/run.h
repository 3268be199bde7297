#pragma once

#include "haptics/oscillator.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace steadyhand {

/// Samples are made in runs of this fixed length, whose loops the compiler turns into vector code on its own.
inline constexpr std::size_t RUN = 64;
/// A stretch: runs in a row over which every amplitude is one cubic.
inline constexpr std::size_t MOST_RUNS = 8;
using Run = std::array<float, RUN>;

/// A run to which sounds are added.
struct Mix {
	alignas(64) Run samples{};
	bool is_silent = true; ///< nothing has been added
	float level = 0.0F;    ///< amplitudes at the end of the run of all that was added, their sum
};

/// A factor from the first sample of a run to the one after its last, linear in between.
struct Ramp {
	float from = 1.0F, to = 1.0F;
};

/// Of a stretch of so many runs.
inline constexpr std::array<double, MOST_RUNS + 1> A_SAMPLE = [] {
	std::array<double, MOST_RUNS + 1> shares{};
	for (std::size_t runs = 1; runs <= MOST_RUNS; ++runs) {
		shares[runs] = 1.0 / static_cast<double>(RUN * runs);
	}
	return shares;
}();

/// An amplitude over a stretch, a cubic of the sample's number.
struct Level {
	float constant = 0.0F, linear = 0.0F, quadratic = 0.0F, cubic = 0.0F;

	/// The one with these values and slopes (a stretch) at the stretch's ends. A motion's amplitude differs
	/// from it by at most the stretch's length to the fourth power x its fourth derivative / 384.
	[[nodiscard]] static Level hermite(
			double from, double from_slope, double to, double to_slope, std::size_t runs = 1) {
		const double each = A_SAMPLE[runs];
		return { static_cast<float>(from), static_cast<float>(each * from_slope),
			static_cast<float>(each * each * (3.0 * (to - from) - 2.0 * from_slope - to_slope)),
			static_cast<float>(each * each * each * (2.0 * (from - to) + from_slope + to_slope)) };
	}
	[[nodiscard]] float at(float sample) const {
		return ((cubic * sample + quadratic) * sample + linear) * sample + constant;
	}
	/// Where the stretch's run number `run` ends.
	[[nodiscard]] float after_run(std::size_t run) const { return at(static_cast<float>((run + 1) * RUN)); }
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

/// A sine over stretch after stretch, its samples by sin(a + b) = sin a cos b + cos a sin b: a is the phase
/// of the run's first sample, b what the sample is ahead of it, from a table made once for a frequency. From
/// stretch to stretch a turns in double precision, and comes anew from its 64 bits every EXACT_TURNS. Largest
/// error: 2e-7, by the 24-bit rounding of all numbers. Aligned for whole cache lines: not for memory of the
/// engine's.
class Carrier {
public:
	static constexpr int EXACT_TURNS = 64;

	/// Sine and cosine of a run's first sample, in 24 bits.
	struct Start {
		float sine = 0.0F, cosine = 1.0F;
	};

	/// The phase is left where it is. step: of an Oscillator
	void set_step(std::uint64_t step);
	/// Of the stretch's first sample.
	void set_phase(std::uint64_t phase);
	/// The next stretch begins this many runs after the last one.
	void advance(std::uint64_t runs);

	[[nodiscard]] std::uint64_t phase() const { return oscillator_.phase; }
	/// Of the stretch's run number `run`.
	[[nodiscard]] Start start(std::size_t run) const {
		const Phasor start = start_.turned(over_runs_[run]);
		return { static_cast<float>(start.sine), static_cast<float>(start.cosine) };
	}
	/// The sample number i of a run.
	[[nodiscard]] float at(const Start &start, std::size_t i) const {
		return start.sine * cosines_[i] + start.cosine * sines_[i];
	}

private:
	alignas(64) Run sines_{};
	alignas(64) Run cosines_{};
	Oscillator oscillator_;
	std::array<Phasor, MOST_RUNS + 1> over_runs_{};
	Phasor start_;
	int to_exact_ = EXACT_TURNS;
};

/// level * sine, held to -1..1, where nothing else is heard: of one channel, or of two in turn that are
/// alike. From the stretch's run number `first` on.
void write_sine(float *frames, std::size_t channels, const Carrier &carrier, const Level &level,
		std::size_t first, std::size_t runs);

// Each adds to `out` the samples of one run; `run` is its number in the stretch.

/// level * sine
void add_sine(Mix &out, const Carrier &carrier, const Level &level, std::size_t run = 0);

/// scale * decay[i] * sine, from the sample number `from` of the run on.
void add_decaying_sine(Mix &out, const Carrier &carrier, double scale, const Run &decay, std::int32_t from,
		std::size_t run = 0);

/// level * window * sine; the run's first sample is the window's number `at`, which may be negative.
void add_windowed_sine(Mix &out, const Carrier &carrier, const Level &level, const Window &window,
		std::int32_t at, std::size_t run = 0);

/// values * window
void add_windowed(Mix &out, const Run &values, const Window &window, std::int32_t at);

void clear(Mix &mix);
void add(Mix &out, const Mix &other);

/// Writes the run, each channel with its gain, held to -most..most: of one channel, or of two in turn. A NaN
/// may become any number or stay one.
void write_held(float *frames, const Mix &mono, const Ramp &gain, float most);
void write_held(float *frames, const Mix &left, const Ramp &left_gain, const Mix &right,
		const Ramp &right_gain, float most);

} // namespace steadyhand
