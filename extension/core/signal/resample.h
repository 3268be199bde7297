#pragma once

#include <cstddef>
#include <span>

namespace steadyhand {

/// Instants t0_s, t0_s + 1 / rate_hz, ... Computed from the index, so that the millionth is as exact as the
/// first.
struct UniformGrid {
	double t0_s = 0.0;
	double rate_hz = 1000.0;

	[[nodiscard]] double time_s(std::size_t index) const {
		return t0_s + static_cast<double>(index) / rate_hz;
	}
};

// Both read the samples (times_s[i], values[i]) in order. A sample that is not usable (NaN, infinite) or
// whose stamp lies before an earlier one's is left out; of several at one instant the last counts.

/// What is known at each instant: the last sample stamped at or before it. `before` until the first one.
/// Causal.
void resample_hold(std::span<const double> times_s, std::span<const double> values, double before,
		const UniformGrid &grid, std::span<double> out);

/// Straight lines between samples, and the first and last one's value outside them; 0 where there is no
/// sample. Looks ahead by one sample: for references, never for what a program could have put out.
void resample_linear(std::span<const double> times_s, std::span<const double> values, const UniformGrid &grid,
		std::span<double> out);

} // namespace steadyhand
