#pragma once

#include "base/parameters.h"
#include "signal/ring.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace steadyhand {

/// Standard deviation s of white noise, from the magnitudes of its second differences, at least one. Their
/// standard deviation is s sqrt(6), and their median magnitude 0.6745 of it. Changes the order of
/// r_magnitudes.
[[nodiscard]] inline double noise_of_second_differences(std::span<double> r_magnitudes) {
	constexpr double DEVIATION_PER_MEDIAN = 0.6053; // 1 / (0.6745 sqrt(6))
	const auto middle = r_magnitudes.begin() + static_cast<std::ptrdiff_t>(r_magnitudes.size() / 2);
	std::nth_element(r_magnitudes.begin(), middle, r_magnitudes.end());
	return DEVIATION_PER_MEDIAN * *middle;
}

/// Drift of a hand at rest in the measured motion element: tremor, and tracker errors that last longer than a
/// frame. It is measured by second differences over DRIFT_S. A constant velocity does not contribute.
class RestDrift {
public:
	/// x: motion element of a hand at rest, amplitudes. t_s must not decrease. False if the value is too soon
	/// after the last one; it is not used then.
	bool push(double t_s, double x) {
		if (!values_.empty() && t_s - values_.newest().t_s < APART_S) {
			return false;
		}
		if (!values_.empty() &&
				t_s - values_.newest().t_s > parameters::SHORT_DROPOUT_S) { // it may have been elsewhere
			values_.clear();
		}
		values_.push({ t_s, x });
		return true;
	}

	/// Standard deviation of white noise with the same median second difference, before RECENT_S ago: later
	/// the movement may have begun. UNKNOWN_DRIFT with too few values.
	[[nodiscard]] double deviation(double t_s) const {
		std::size_t count = values_.size();
		while (count > 0 && values_[count - 1].t_s > t_s - parameters::sessions::RECENT_S) {
			--count;
		}
		if (count < 2) {
			return parameters::sessions::UNKNOWN_DRIFT;
		}
		const double apart_s = (values_[count - 1].t_s - values_[0].t_s) / static_cast<double>(count - 1);
		const auto step =
				static_cast<std::size_t>(std::max(std::lround(parameters::sessions::DRIFT_S / apart_s), 1L));
		std::array<double, MOST> differences{};
		std::size_t difference_count = 0;
		for (std::size_t i = 2 * step; i < count; ++i) {
			differences[difference_count++] =
					std::abs(values_[i].x - 2.0 * values_[i - step].x + values_[i - 2 * step].x);
		}
		if (difference_count < FEWEST) {
			return parameters::sessions::UNKNOWN_DRIFT;
		}
		return noise_of_second_differences(std::span(differences).first(difference_count));
	}

private:
	static constexpr std::size_t MOST = 64; ///< values, at least 1.2 s
	static constexpr std::size_t FEWEST = 6;
	static constexpr double APART_S = 0.019;

	struct Value {
		double t_s = 0.0, x = 0.0;
	};
	Ring<Value, MOST> values_;
};

} // namespace steadyhand
