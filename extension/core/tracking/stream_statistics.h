#pragma once

#include "tracking/frame.h"
#include "tracking/tracker_monitor.h"

#include <array>
#include <cstddef>
#include <optional>

namespace steadyhand {

/// Rate and jitter of the newest frames of a stream; noise and faults of one joint in all frames. Does not
/// allocate.
class StreamStatistics {
public:
	/// Stamps must not decrease. Takes O(1).
	void add(const HandFrame &frame);

	/// Frames per second: the inverse of the median interval. 0 before there are MIN_INTERVALS.
	[[nodiscard]] double rate_hz() const;
	/// Median absolute deviation of the intervals from their median, s. Single gaps have no effect.
	[[nodiscard]] double jitter_s() const;
	/// Monitors the index fingertip, or another joint if the first frame with a hand has no index fingertip.
	[[nodiscard]] const TrackerMonitor &monitor() const { return monitor_; }

private:
	static constexpr std::size_t WINDOW = 128; ///< intervals: a second of the fastest headset
	static constexpr std::size_t MIN_INTERVALS = 8;

	std::array<double, WINDOW> intervals_s_{};
	std::size_t count_ = 0;
	std::optional<double> last_s_;
	std::optional<Joint> joint_; ///< joint of monitor_
	TrackerMonitor monitor_;

	[[nodiscard]] double median_s() const;
};

} // namespace steadyhand
