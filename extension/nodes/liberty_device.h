#pragma once

#include "devices/liberty_protocol.h"
#include "devices/liberty_sequence.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <string>

namespace steadyhand {

/// One thing that happened to the tracker.
struct LibertyEvent {
	enum class Kind : std::uint8_t {
		CONNECTED, ///< the stream starts, or starts again; `stations` and `text` say of what
		RECORD,    ///< `record` and the times
		WARNING,   ///< `text`: the stream goes on, but something is wrong
		NOTE,      ///< `text`: the tracker said something
		FAILURE    ///< `text`: there is no stream, and what to do
	};
	Kind kind = Kind::NOTE;
	/// s, arrival on std::chrono::steady_clock, of all kinds.
	double host_time_s = 0.0;
	/// s, on the tracker's clock (LibertyClock). Starts near 0 at each connection.
	double device_time_s = std::numeric_limits<double>::quiet_NaN();
	/// Frames that were skipped before this one; told with each station's record.
	std::uint32_t lost_frames = 0;
	/// The tracker sent the mirror image of the position. `record` holds the true one if
	/// LibertySettings::mirror_flips is set.
	bool is_mirrored = false;
	std::uint32_t stations = 0; ///< bit i set: a sensor is plugged into station i + 1
	LibertyRecord record;
	std::string text;
};

/// Polhemus Liberty on the USB. A thread of its own finds the tracker, starts it, receives, and looks for it
/// again after it was unplugged. All functions are for one other thread.
class LibertyDevice {
public:
	LibertyDevice();
	~LibertyDevice(); ///< as stop()
	LibertyDevice(const LibertyDevice &) = delete;
	LibertyDevice &operator=(const LibertyDevice &) = delete;

	/// Starts to look for the tracker. Returns at once: failures come as events. Ends a stream that runs, and
	/// throws away its events.
	void start(const LibertySettings &settings);

	/// Stops the tracker and gives it back. Waits for it, 0.2 s as a rule and 5 s at most. May be called
	/// twice.
	void stop();

	[[nodiscard]] bool is_running() const;

	/// Takes out the oldest event. False where none waits. Call it often: 4096 events fit, which is 1 s of 16
	/// stations at 240 Hz.
	bool next(LibertyEvent &r_event);

	/// Records that found no room, since start().
	[[nodiscard]] std::uint64_t dropped_records() const;

private:
	struct Thread;
	std::unique_ptr<Thread> thread_;
};

} // namespace steadyhand
