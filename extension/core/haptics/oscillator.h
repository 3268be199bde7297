#pragma once

#include <cstdint>

namespace steadyhand {

/// Phase of a sine as a 64-bit count of 2^-64 turns: after a week at 180 Hz it is off by less than 1e-6 rad
/// at any sample rate. A change of frequency or sample rate leaves it where it is, so that neither makes a
/// step.
struct Oscillator {
	std::uint64_t phase = 0; ///< of the next sample
	std::uint64_t step = 0;  ///< a sample

	void advance(std::uint64_t samples) { phase += step * samples; }
};

/// 2^-64 turns a sample; of a frequency above half the sample rate, that. 0 where either is not above 0 and
/// finite.
[[nodiscard]] std::uint64_t phase_step(double frequency_hz, double sample_rate_hz);

/// Sine and cosine of a phase.
struct Phasor {
	double sine = 0.0, cosine = 1.0;

	/// Of the sum of both phases.
	[[nodiscard]] Phasor turned(const Phasor &by) const {
		return { sine * by.cosine + cosine * by.sine, cosine * by.cosine - sine * by.sine };
	}
};

[[nodiscard]] Phasor phasor_of(std::uint64_t phase);

} // namespace steadyhand
