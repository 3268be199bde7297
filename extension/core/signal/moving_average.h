#pragma once

#include "signal/sample_clock.h"

#include <array>
#include <cstddef>

namespace steadyhand {

/// Mean of the last 41 frames, without regard to their time stamps: the filter in the paper's comparison.
/// Before 41 frames, the mean of all. Lag on a ramp: 20 frames.
class MovingAverage {
public:
	static constexpr std::size_t LENGTH = 41;

	/// Unusable input (NaN, infinite, beyond 1e100) is ignored: the output stays. 0 before any input.
	double push(double t_s, double x) {
		if (!is_usable(t_s) || !is_usable(x)) {
			return output();
		}
		window_[next_] = x;
		next_ = (next_ + 1) % LENGTH;
		count_ = count_ < LENGTH ? count_ + 1 : LENGTH;
		newest_ = x;
		return output();
	}

	[[nodiscard]] double output() const {
		// The sum is computed anew: a running sum accumulates rounding errors. It is relative to the newest
		// sample, which keeps the accuracy far from the origin.
		double sum = 0.0;
		for (std::size_t i = 0; i < count_; ++i) {
			sum += window_[i] - newest_;
		}
		return count_ > 0 ? newest_ + sum / static_cast<double>(count_) : 0.0;
	}

private:
	std::array<double, LENGTH> window_{};
	std::size_t next_ = 0;
	std::size_t count_ = 0;
	double newest_ = 0.0;
};

} // namespace steadyhand
