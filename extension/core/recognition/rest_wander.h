#pragma once

#include "base/parameters.h"
#include "signal/ring.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace steadyhand {

/// Standard deviation of white noise whose second differences have these sizes, one and more, whose order is
/// lost: by their median, because half of them, whose deviation is s sqrt(6), are within 0.6745 of that.
[[nodiscard]] inline double deviation_of_bends(std::span<double> r_sizes) {
	constexpr double DEVIATION_PER_MEDIAN = 0.6053; // 1 / (0.6745 sqrt(6))
	const auto middle = r_sizes.begin() + static_cast<std::ptrdiff_t>(r_sizes.size() / 2);
	std::nth_element(r_sizes.begin(), middle, r_sizes.end());
	return DEVIATION_PER_MEDIAN * *middle;
}

/// How far a hand at rest is shown to wander: by its own tremor, or by a tracker whose errors last longer
/// than a frame, which bends from frame to frame do not tell. Bends over a tenth of a second
/// do; that the hand drifts, or has just come there, is none of it.
class RestWander {
public:
	/// x: what the element shows of a hand at rest, in amplitudes. t_s must not decrease. False where the
	/// last one is too near for it to be kept.
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

	/// Standard deviation of white noise that bends as much, of the median, in the time before the hand may
	/// have set out by t_s; UNKNOWN_DRIFT where it has not been seen for 0.4 s.
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
		std::array<double, MOST> bends{};
		std::size_t bend_count = 0;
		for (std::size_t i = 2 * step; i < count; ++i) {
			bends[bend_count++] =
					std::abs(values_[i].x - 2.0 * values_[i - step].x + values_[i - 2 * step].x);
		}
		if (bend_count < FEWEST) {
			return parameters::sessions::UNKNOWN_DRIFT;
		}
		return deviation_of_bends(std::span(bends).first(bend_count));
	}

private:
	static constexpr std::size_t MOST = 64; ///< values, of 1.2 s and more
	static constexpr std::size_t FEWEST = 6;
	static constexpr double APART_S = 0.019;

	struct Value {
		double t_s = 0.0, x = 0.0;
	};
	Ring<Value, MOST> values_;
};

} // namespace steadyhand
