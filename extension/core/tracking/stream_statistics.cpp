#include "tracking/stream_statistics.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace steadyhand {
namespace {

/// Median of at least one value. Reorders the values.
double median(double *begin, double *end) {
	double *const middle = begin + (end - begin) / 2;
	std::nth_element(begin, middle, end);
	return *middle;
}

/// Joint to monitor. The frame must have a tracked joint.
Joint watched_joint(const HandFrame &frame) {
	return frame.has(Joint::INDEX) ? Joint::INDEX : static_cast<Joint>(std::countr_zero(frame.tracked));
}

} // namespace

void StreamStatistics::add(const HandFrame &frame) {
	if (last_s_ && frame.t_s > *last_s_) {
		intervals_s_[count_++ % WINDOW] = frame.t_s - *last_s_;
	}
	last_s_ = frame.t_s;
	if (!joint_ && frame.tracked != 0) {
		joint_ = watched_joint(frame);
	}
	if (joint_ && frame.has(*joint_)) {
		monitor_.push(frame.t_s, frame.position(*joint_));
	}
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
