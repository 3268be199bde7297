#pragma once

#include "tracking/frame.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace steadyhand {

/// Rate, jitter and dropouts of a stream of frames, over its newest frames. Allocates nothing.
class StreamStatistics {
public:
	/// Stamps must not decrease. Takes O(1).
	void add(const HandFrame &frame);

	/// Frames a second: the inverse of the median interval. 0 before there are MIN_INTERVALS.
	[[nodiscard]] double rate_hz() const;
	/// Median absolute deviation of the intervals from their median, s: no single gap moves it.
	[[nodiscard]] double jitter_s() const;
	/// Times that no joint was tracked, or no frame came for LONG_PERIODS periods, after one was tracked.
	[[nodiscard]] std::uint64_t dropouts() const { return dropouts_; }

private:
	static constexpr std::size_t WINDOW = 128; ///< a second of the fastest headset
	static constexpr std::size_t MIN_INTERVALS = 8;
	/// Loaded trackers skip 1 to 3 frames now and then, which is no dropout.
	static constexpr double LONG_PERIODS = 5.0;

	std::array<double, WINDOW> intervals_s_{};
	std::size_t count_ = 0;
	double last_s_ = 0.0;
	bool has_last_ = false;
	bool has_hand_ = false;
	std::uint64_t dropouts_ = 0;

	[[nodiscard]] double median_s() const;
};

} // namespace steadyhand
