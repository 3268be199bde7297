#pragma once

#include "base/parameters.h"
#include "signal/ring.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace steadyhand {

/// Drift of a hand at rest in the measured motion element: tremor, and tracker errors that last longer than a
/// frame. It is measured by second differences over about 0.1 s. A constant velocity does not contribute.
class RestDrift {
public:
	/// x: motion element of a hand at rest, amplitudes. t_s must not decrease. A value too soon after the
	/// last one is not used.
	void push(double t_s, double x) {
		const double since_s = values_.empty() ? INFINITY : t_s - values_.newest().t_s;
		if (since_s > parameters::SHORT_DROPOUT_S) { // it may have been elsewhere
			values_.clear();
		}
		if (since_s >= APART_S) {
			values_.push({ t_s, x });
		}
	}

	/// Standard deviation of white noise with the same median second difference, before RECENT_S ago: later
	/// the movement may have begun. UNKNOWN_DRIFT with too few values.
	[[nodiscard]] double deviation(double t_s) const {
		constexpr double DEVIATION_PER_MEDIAN = 0.6053; // 1 / (0.6745 sqrt(6)), of white noise
		const double last_s = t_s - parameters::sessions::RECENT_S;
		std::array<double, MOST> differences{};
		auto end = differences.begin();
		for (std::size_t i = 2 * STEP; i < values_.size() && values_[i].t_s <= last_s; ++i) {
			*end++ = std::abs(values_[i].x - 2.0 * values_[i - STEP].x + values_[i - 2 * STEP].x);
		}
		const auto middle = differences.begin() + (end - differences.begin()) / 2;
		std::nth_element(differences.begin(), middle, end);
		return end - differences.begin() < FEWEST ? parameters::sessions::UNKNOWN_DRIFT
												  : DEVIATION_PER_MEDIAN * *middle;
	}

private:
	static constexpr std::size_t MOST = 64; ///< values, at least 1.2 s
	static constexpr std::size_t STEP = 5;  ///< values of a first difference
	static constexpr std::ptrdiff_t FEWEST = 6;
	static constexpr double APART_S = 0.019;

	struct Value {
		double t_s = 0.0, x = 0.0;
	};
	Ring<Value, MOST> values_;
};

} // namespace steadyhand
