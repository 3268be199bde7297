#pragma once

#include <array>
#include <cstddef>

namespace steadyhand {

/// Maps the stamps of a device's own clock to the host's clock, where samples arrive in bursts and late, but
/// never early.
///
/// host = device + offset. The offset is the smallest (arrival - device) of the last WINDOW_S: that of the
/// sample with the least delay. The constant part of the delay cannot be measured; it is part of the offset.
/// A mapped stamp never decreases and is never after the arrival of its sample.
///
/// Drift: a device clock that runs slow by 200 ppm maps up to 1 ms too early, because the smallest offset is
/// then the oldest. A clock that runs fast has no such error.
///
/// Changes of delay: the offset decreases at once when a sample arrives with less delay, as the first samples
/// do. Such a sample is mapped to its arrival. The offset increases by at most 1 ms/s, so that velocities
/// stay right.
///
/// A device clock that was set: the mapping restarts and reports this in `restarted`. It does so if the
/// device's clock goes back by more than BACK_S, jumps ahead by more than AHEAD_S, or if all samples of a
/// window are more than LATE_S later than before. After WINDOW_S without a sample it restarts without a
/// report. A shorter jump ahead decreases the offset. A shorter step back repeats the last stamp.
///
/// No allocation. Stamps may have any origin; Leap's count microseconds, Liberty's frames of 1/240 s.
class DeviceClock {
public:
	static constexpr double WINDOW_S = 5.0; ///< longer than a stall of the host
	static constexpr double BACK_S = 0.1;   ///< longer than a network's reordering
	static constexpr double AHEAD_S = 2.0;  ///< longer than a device's first samples wait for the host
	static constexpr double LATE_S = 0.1;   ///< more than a lasting increase of the delay

	struct Stamp {
		double host_s = 0.0;    ///< on the clock of the arrivals
		bool restarted = false; ///< the device's clock was set; the step to this stamp is no duration
	};

	/// `device_s`: when the sample was taken, on the device's clock. `arrival_s`: when it arrived, on the
	/// host's clock; it never decreases (an earlier time counts as the last one). A device stamp that is not
	/// finite or beyond 1e9 s is mapped to its arrival and not used otherwise. An arrival that is not finite
	/// or beyond 1e9 s repeats the last stamp.
	Stamp map(double device_s, double arrival_s);

	/// Resets to the initial state, for a new connection: mapped stamps may decrease once.
	void clear() { *this = DeviceClock(); }

private:
	static constexpr std::size_t BUCKETS = 20; ///< each is WINDOW_S / BUCKETS long

	void start(double device_s, double arrival_s);
	void add(double offset_s, double arrival_s);
	[[nodiscard]] double smallest_offset_s() const;

	std::array<double, BUCKETS> offsets_s_{}; ///< smallest of each bucket, infinite if the bucket is empty
	double bucket_end_s_ = 0.0;               ///< arrivals before it belong to offsets_s_[bucket_]
	std::size_t bucket_ = 0;
	double offset_s_ = 0.0;
	double newest_device_s_ = 0.0;
	double last_arrival_s_ = 0.0;
	double last_host_s_ = 0.0;
	bool has_arrival_ = false; ///< last_arrival_s_ and last_host_s_ are set
	bool is_started_ = false;  ///< the other members are set
};

} // namespace steadyhand
