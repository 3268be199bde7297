#pragma once

#include "devices/hemisphere_guard.h"
#include "devices/liberty_clock.h"
#include "liberty_device.h"
#include "liberty_usb.h"

#include <array>
#include <atomic>
#include <functional>
#include <optional>
#include <string>

namespace steadyhand {

/// One connection to the tracker, from its discovery to its loss. Only for LibertyDevice's thread.
class LibertySession {
public:
	using Emit = std::function<void(LibertyEvent &&event)>;

	/// All references must outlive this object. Set `is_stopping` to end run().
	LibertySession(const LibusbLibrary &library, const LibertySettings &settings,
			const std::atomic<bool> &is_stopping, Emit emit);

	struct End {
		std::string failure;        ///< why it ended; empty after `is_stopping`
		bool was_streaming = false; ///< the failure was emitted
		bool is_absent = false;     ///< no tracker was found
	};
	/// Connects, starts the stream and receives until the tracker is lost or `is_stopping` is set. Then stops
	/// the stream.
	End run();

private:
	using Kind = LibertyEvent::Kind;

	/// Topics of warnings. Each is reported at most once in REPEAT_S.
	enum Topic : std::uint8_t { FAULTS, FLIPS, SIZES, REFUSALS, TEXTS, TOPIC_COUNT };

	void receive(std::span<const std::uint8_t> bytes, double host_s);
	void handle(const LibertyMessage &message, double host_s);
	void handle_record(const LibertyRecord &record, double host_s);
	std::optional<Error> take(const LibertyStep &step);
	bool is_met(const LibertyStep &step, double since_s) const;
	void connect(double host_s);
	void stream(End &r_end);
	void report(Kind kind, std::string text, double host_s);
	void report_rarely(Topic topic, Kind kind, std::string text, double host_s);

	const LibertySettings &settings_;
	const std::atomic<bool> &is_stopping_;
	Emit emit_;
	LibertyParser parser_;
	LibertyUsb usb_;
	LibertyClock clock_;
	std::array<HemisphereGuard, LIBERTY_STATION_COUNT> guards_;
	std::array<double, TOPIC_COUNT> reported_s_{};
	const LibertyStep *step_ = nullptr; ///< the current step; null while the stream runs
	double received_s_ = 0.0;           ///< arrival of the last bytes
	std::optional<std::uint32_t> stations_;
	std::uint32_t lost_frames_ = 0; ///< before the cycle of clock_'s last frame
	bool is_connected_ = false;     ///< CONNECTED was emitted
	bool has_record_ = false;
};

} // namespace steadyhand
