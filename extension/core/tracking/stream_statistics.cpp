#include "tracking/stream_statistics.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

/// Reorders the values; there is at least one.
double median(double *begin, double *end) {
	double *const middle = begin + (end - begin) / 2;
	std::nth_element(begin, middle, end);
	return *middle;
}

} // namespace

void StreamStatistics::add(const HandFrame &frame) {
	const double interval_s = frame.t_s - last_s_;
	if (has_last_ && interval_s > 0.0) {
		const double usual_s = count_ < MIN_INTERVALS ? interval_s : intervals_s_[(count_ - 1) % WINDOW];
		const bool is_gap = count_ >= MIN_INTERVALS && interval_s > LONG_PERIODS * usual_s &&
				interval_s > LONG_PERIODS * median_s();
		if (is_gap) {
			dropouts_ += has_hand_ ? 1 : 0;
			has_hand_ = false;
		} else {
			intervals_s_[count_++ % WINDOW] = interval_s;
		}
	}
	if (frame.tracked == 0 && has_hand_) {
		++dropouts_;
	}
	has_hand_ = frame.tracked != 0;
	last_s_ = frame.t_s;
	has_last_ = true;
}

double StreamStatistics::median_s() const {
	std::array<double, WINDOW> sorted = intervals_s_;
	const std::size_t size = std::min(count_, WINDOW);
	return median(sorted.data(), sorted.data() + size);
}

double StreamStatistics::rate_hz() const {
	return count_ < MIN_INTERVALS ? 0.0 : 1.0 / median_s();
}

double StreamStatistics::jitter_s() const {
	if (count_ < MIN_INTERVALS) {
		return 0.0;
	}
	const double usual_s = median_s();
	std::array<double, WINDOW> deviations = intervals_s_;
	const std::size_t size = std::min(count_, WINDOW);
	for (std::size_t i = 0; i < size; ++i) {
		deviations[i] = std::abs(deviations[i] - usual_s);
	}
	return median(deviations.data(), deviations.data() + size);
}

} // namespace steadyhand
