#pragma once

#include <cstdint>
#include <limits>
#include <string>

namespace steadyhand {

/// The tracker's time from its frame count, which is more exact than its time stamps of whole milliseconds.
/// Also measures the rate at which frames arrive.
class LibertyClock {
public:
	/// `rate_hz` is the rate that the tracker was set to.
	explicit LibertyClock(double rate_hz) : rate_hz_(rate_hz), count_hz_(rate_hz) {}

	struct Answer {
		double time_s = 0.0;         ///< of the frame on the tracker's clock; never goes back
		bool is_new_frame = true;    ///< false: another station of the same cycle
		std::uint32_t lost = 0;      ///< frames that were skipped before this one
		bool has_restarted = false;  ///< the count went back: the tracker was reset
		bool has_rate_fault = false; ///< rate_fault() became true with this frame
	};

	/// A record's frame count and its arrival on the host's clock, s. The stations of one cycle share a count
	/// and get the same time. Time is frame count / rate. If the count runs at another rate than the
	/// configured one, it is divided by its measured rate, from the end of the first window on.
	[[nodiscard]] Answer update(std::uint32_t frame_count, double host_s);

	/// Frames a second on the host's clock, over the last complete WINDOW_S. NaN before the first one.
	[[nodiscard]] double measured_rate_hz() const { return measured_hz_; }
	/// The measured rate differs by more than RATE_TOLERANCE from the configured one.
	[[nodiscard]] bool rate_fault() const { return has_rate_fault_; }
	/// rate_fault() as a sentence for the user, with what to do.
	[[nodiscard]] std::string rate_fault_text() const;

	/// s. A hundred times the variation of arrivals, 20 ms.
	static constexpr double WINDOW_S = 2.0;
	/// Of the configured rate. The tracker's two rates differ by far more, quartz clocks by far less.
	static constexpr double RATE_TOLERANCE = 0.05;
	/// Of the configured rate, for the count itself. Delays of the computer change a window by less, and the
	/// tracker's other rate is half or double.
	static constexpr double COUNT_TOLERANCE = 0.25;

private:
	bool measure_rate(double host_s);
	[[nodiscard]] double time_s() const {
		return base_s_ + static_cast<double>(frames_ - base_frames_) / count_hz_;
	}

	double rate_hz_;
	double count_hz_; ///< of the frame count
	double measured_hz_ = std::numeric_limits<double>::quiet_NaN();
	bool has_rate_fault_ = false;
	bool has_frame_ = false;
	std::uint32_t last_count_ = 0;
	std::uint64_t frames_ = 0;      ///< the count without rollover and resets
	std::uint64_t base_frames_ = 0; ///< the count has run at count_hz_ since this frame
	double base_s_ = 0.0;           ///< the tracker's time at base_frames_
	double last_host_s_ = 0.0;
	double window_start_s_ = 0.0;
	std::uint64_t window_frames_ = 0; ///< frames_ at the window's start
	std::uint32_t arrived_ = 0;       ///< frames since the window's start
};

} // namespace steadyhand
