#include "devices/liberty_clock.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace steadyhand {

LibertyClock::Answer LibertyClock::update(std::uint32_t frame_count, double host_s) {
	Answer answer;
	if (!has_frame_) {
		has_frame_ = true;
		frames_ = window_frames_ = frame_count;
		window_start_s_ = host_s;
	} else if (frame_count != last_count_) {
		// As the difference is taken modulo 2^32, a rollover is a step of 1 like any other.
		const auto step = std::bit_cast<std::int32_t>(frame_count - last_count_);
		if (step > 0) {
			frames_ += static_cast<std::uint64_t>(step);
			answer.lost = static_cast<std::uint32_t>(step) - 1;
		} else {
			// The host's clock measures the duration of the reset.
			const double passed = std::max((host_s - last_host_s_) * count_hz_, 1.0);
			frames_ += static_cast<std::uint64_t>(std::lround(passed));
			answer.has_restarted = true;
		}
		answer.has_rate_fault = measure_rate(host_s);
	} else {
		answer.is_new_frame = false;
	}
	last_count_ = frame_count;
	last_host_s_ = host_s;
	answer.time_s = time_s();
	return answer;
}

/// Counts a frame. True if it ends a window with a rate fault, and the window before had none.
bool LibertyClock::measure_rate(double host_s) {
	++arrived_;
	const double span_s = host_s - window_start_s_;
	if (span_s < WINDOW_S) {
		return false;
	}
	measured_hz_ = arrived_ / span_s;
	const double counted_hz = static_cast<double>(frames_ - window_frames_) / span_s;
	const bool is_other_rate = std::abs(counted_hz / rate_hz_ - 1.0) > COUNT_TOLERANCE;
	base_s_ = time_s();
	base_frames_ = window_frames_ = frames_;
	count_hz_ = is_other_rate ? counted_hz : rate_hz_;
	window_start_s_ = host_s;
	arrived_ = 0;
	const bool had_fault = has_rate_fault_;
	has_rate_fault_ = std::abs(measured_hz_ / rate_hz_ - 1.0) > RATE_TOLERANCE;
	return has_rate_fault_ && !had_fault;
}

std::string LibertyClock::rate_fault_text() const {
	return "Liberty: " + std::to_string(std::lround(measured_hz_)) + " frames a second arrive, must be " +
			std::to_string(std::lround(rate_hz_)) +
			". Plug the tracker into a USB port of the computer itself, close other programs, then switch "
			"the "
			"tracker off and on.";
}

} // namespace steadyhand
