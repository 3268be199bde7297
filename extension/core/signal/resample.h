#pragma once

#include <cstddef>
#include <span>

namespace steadyhand {

/// Times t0_s, t0_s + 1 / rate_hz, ... They are computed from the index, so that errors do not accumulate.
struct UniformGrid {
	double t0_s = 0.0;
	double rate_hz = 1000.0;

	[[nodiscard]] double time_s(std::size_t index) const {
		return t0_s + static_cast<double>(index) / rate_hz;
	}
};

// Both functions read the samples (times_s[i], values[i]) in order. A sample that is not usable (NaN,
// infinite) or has an earlier time than one before it is ignored. Of several samples at one time the last one
// is used.

/// Sample and hold: the last sample at or before each time; `before` until the first one. Causal.
void resample_hold(std::span<const double> times_s, std::span<const double> values, double before,
		const UniformGrid &grid, std::span<double> out);

/// Linear interpolation, constant before the first and after the last sample; 0 without samples. It looks
/// ahead by one sample: use it for references, not for outputs of a program.
void resample_linear(std::span<const double> times_s, std::span<const double> values, const UniformGrid &grid,
		std::span<double> out);

} // namespace steadyhand
