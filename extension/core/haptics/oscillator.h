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

} // namespace steadyhand
