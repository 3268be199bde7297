#pragma once

#include "signal/sample_clock.h"

#include <array>
#include <cstddef>

namespace steadyhand {

/// Mean of the last 41 frames, whatever their stamps: the filter that the paper compares with. While fewer
/// have been seen, the mean of those. Lag on a steady ramp: 20 frames.
class MovingAverage {
public:
	static constexpr std::size_t LENGTH = 41;

	/// Unusable input (NaN, infinite, beyond 1e100) is no frame: the last output stands; 0 before any input.
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

	/// Costs nothing where it is not asked for.
	[[nodiscard]] double output() const {
		// Summed afresh each time: a running sum would keep the rounding error of every frame ever seen.
		// Differences from the newest sample, so that a hand far from the origin loses nothing either.
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
