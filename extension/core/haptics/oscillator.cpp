#include "haptics/oscillator.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace steadyhand {

std::uint64_t phase_step(double frequency_hz, double sample_rate_hz) {
	if (!(frequency_hz > 0.0) || !(sample_rate_hz > 0.0) || !std::isfinite(sample_rate_hz)) {
		return 0;
	}
	// The quotient and what its rounding lost, so that the step is exact to its last bit: half a unit of
	// 2^-64 turns a sample is 1e-8 rad in a week at 192 kHz, the rounding of a double alone would be 1e-7.
	const double held_hz = std::min(frequency_hz, 0.5 * sample_rate_hz);
	const double turns = held_hz / sample_rate_hz;
	const double lost_turns = std::fma(-turns, sample_rate_hz, held_hz) / sample_rate_hz;
	const double units = std::ldexp(turns, 64);
	const double whole = std::floor(units);
	const double rest = (units - whole) + std::ldexp(lost_turns, 64);
	return static_cast<std::uint64_t>(whole) + static_cast<std::uint64_t>(std::llround(rest));
}

Phasor phasor_of(std::uint64_t phase) {
	constexpr double RAD = 2.0 * std::numbers::pi * 0x1p-64;
	// As a signed number the phase lies within half a turn of 0.
	const double rad = RAD * static_cast<double>(static_cast<std::int64_t>(phase));
	return { std::sin(rad), std::cos(rad) };
}

} // namespace steadyhand
