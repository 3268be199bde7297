#include "devices/device_clock.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace steadyhand {
namespace {

/// Beyond this, a double cannot represent single microseconds.
constexpr double FARTHEST_CLOCK_S = 1e9;
/// Five times the drift of a poor quartz, 200 ppm, so that the offset follows it.
constexpr double RISE_S_PER_S = 1e-3;

bool is_time(double time_s) {
	return std::abs(time_s) <= FARTHEST_CLOCK_S; // false for NaN
}

} // namespace

void DeviceClock::start(double device_s, double arrival_s) {
	offsets_s_.fill(std::numeric_limits<double>::infinity());
	bucket_ = 0;
	offset_s_ = offsets_s_[0] = arrival_s - device_s;
	bucket_end_s_ = arrival_s + WINDOW_S / BUCKETS;
	newest_device_s_ = device_s;
	is_started_ = true;
}

void DeviceClock::add(double offset_s, double arrival_s) {
	// At most BUCKETS iterations: map() restarts after a longer gap.
	while (arrival_s >= bucket_end_s_) {
		bucket_ = (bucket_ + 1) % BUCKETS;
		offsets_s_[bucket_] = std::numeric_limits<double>::infinity();
		bucket_end_s_ += WINDOW_S / BUCKETS;
	}
	offsets_s_[bucket_] = std::min(offsets_s_[bucket_], offset_s);
}

double DeviceClock::smallest_offset_s() const {
	return *std::min_element(offsets_s_.begin(), offsets_s_.end());
}

DeviceClock::Stamp DeviceClock::map(double device_s, double arrival_s) {
	if (!is_time(arrival_s)) {
		return { last_host_s_, false };
	}
	arrival_s = has_arrival_ ? std::max(arrival_s, last_arrival_s_) : arrival_s;
	const double earliest_s = has_arrival_ ? last_host_s_ : -std::numeric_limits<double>::infinity();
	last_arrival_s_ = arrival_s;
	has_arrival_ = true;
	if (!is_time(device_s)) {
		last_host_s_ = arrival_s;
		return { last_host_s_, false };
	}

	const double offset_s = arrival_s - device_s;
	const double step_s = device_s - newest_device_s_;
	bool restarted = is_started_ && (step_s < -BACK_S || offset_s < offset_s_ - AHEAD_S);
	if (!is_started_ || restarted || arrival_s >= bucket_end_s_ + WINDOW_S) {
		start(device_s, arrival_s);
	} else {
		add(offset_s, arrival_s);
		const double smallest_s = smallest_offset_s();
		if (smallest_s > offset_s_ + LATE_S) {
			restarted = true;
			offset_s_ = smallest_s;
		} else {
			offset_s_ = std::min(smallest_s, offset_s_ + RISE_S_PER_S * std::max(0.0, step_s));
		}
		newest_device_s_ = std::max(newest_device_s_, device_s);
	}
	last_host_s_ = std::min(arrival_s, std::max(earliest_s, device_s + offset_s_));
	return { last_host_s_, restarted };
}

} // namespace steadyhand
