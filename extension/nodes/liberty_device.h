#pragma once

#include "devices/liberty_protocol.h"
#include "devices/liberty_sequence.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <string>

namespace steadyhand {

/// An event of the tracker.
struct LibertyEvent {
	enum class Kind : std::uint8_t {
		CONNECTED, ///< the stream starts, or starts again; with `stations` and `text`
		RECORD,    ///< `record` and the times
		WARNING,   ///< `text`: the stream continues, but something is wrong
		NOTE,      ///< `text`: a message of the tracker
		FAILURE    ///< `text`: there is no stream, and what to do
	};
	Kind kind = Kind::NOTE;
	/// s, arrival on std::chrono::steady_clock, of all kinds.
	double host_time_s = 0.0;
	/// s, on the tracker's clock (LibertyClock). Starts near 0 at each connection.
	double device_time_s = std::numeric_limits<double>::quiet_NaN();
	/// Frames that were skipped before this one; the same in all records of a cycle.
	std::uint32_t lost_frames = 0;
	/// The tracker sent the mirror image of the position. `record` has the true position if
	/// LibertySettings::mirror_flips is set.
	bool is_mirrored = false;
	std::uint32_t stations = 0; ///< bit i set: a sensor is plugged into station i + 1
	LibertyRecord record;
	std::string text;
};

/// Polhemus Liberty on the USB. Its own thread finds the tracker, starts it, receives data, and searches for
/// it again after it was unplugged. Only one other thread may call the functions.
class LibertyDevice {
public:
	LibertyDevice();
	~LibertyDevice(); ///< as stop()
	LibertyDevice(const LibertyDevice &) = delete;
	LibertyDevice &operator=(const LibertyDevice &) = delete;

	/// Starts to search for the tracker. Returns at once; failures are events. Ends a running stream and
	/// drops its events.
	void start(const LibertySettings &settings);

	/// Stops and releases the tracker. This usually takes 0.2 s, at most 5 s. May be called twice.
	void stop();

	[[nodiscard]] bool is_running() const;

	/// Gets the oldest event; false if there is none. The queue has 4096 events, which is 1 s of 16 stations
	/// at 240 Hz.
	bool next(LibertyEvent &r_event);

	/// Records that did not fit into the queue, since start().
	[[nodiscard]] std::uint64_t dropped_records() const;

private:
	struct Thread;
	std::unique_ptr<Thread> thread_;
};

} // namespace steadyhand
