#pragma once

#include "tracking/frame.h"
#include "tracking/tracker_monitor.h"

#include <array>
#include <cstddef>
#include <optional>

namespace steadyhand {

/// Rate and jitter of a stream of frames, over its newest frames; noise and faults of one joint, over all of
/// them. Allocates nothing.
class StreamStatistics {
public:
	/// Stamps must not decrease. Takes O(1).
	void add(const HandFrame &frame);

	/// Frames a second: the inverse of the median interval. 0 before there are MIN_INTERVALS.
	[[nodiscard]] double rate_hz() const;
	/// Median absolute deviation of the intervals from their median, s: no single gap moves it.
	[[nodiscard]] double jitter_s() const;
	/// Of the index fingertip; of another joint if the first frame with a hand has no index fingertip.
	[[nodiscard]] const TrackerMonitor &monitor() const { return monitor_; }

private:
	static constexpr std::size_t WINDOW = 128; ///< a second of the fastest headset
	static constexpr std::size_t MIN_INTERVALS = 8;

	std::array<double, WINDOW> intervals_s_{};
	std::size_t count_ = 0;
	std::optional<double> last_s_;
	std::optional<Joint> joint_; ///< that monitor_ watches
	TrackerMonitor monitor_;

	[[nodiscard]] double median_s() const;
};

} // namespace steadyhand
