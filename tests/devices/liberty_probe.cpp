// liberty_probe SECONDS [STREAM_S CONNECTION]: runs a LibertyDevice for SECONDS and prints its events, one a
// line. With STREAM_S it ends earlier: after STREAM_S of records, on the tracker's clock, of connection
// number CONNECTION (from 1).

#include "liberty_device.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <thread>

using namespace steadyhand;

namespace {

void print(const LibertyEvent &event) {
	const LibertyRecord &record = event.record;
	switch (event.kind) {
		case LibertyEvent::Kind::RECORD:
			std::printf("record %d %.6f %.6f %u %d %d %.6f %.6f %.6f\n", record.station, event.host_time_s,
					event.device_time_s, event.lost_frames, record.is_tracked ? 1 : 0,
					event.is_mirrored ? 1 : 0, record.position_m.x(), record.position_m.y(),
					record.position_m.z());
			break;
		case LibertyEvent::Kind::CONNECTED:
			std::printf("connected %.6f %s\n", event.host_time_s, event.text.c_str());
			break;
		case LibertyEvent::Kind::WARNING:
			std::printf("warning %.6f %s\n", event.host_time_s, event.text.c_str());
			break;
		case LibertyEvent::Kind::NOTE:
			std::printf("note %.6f %s\n", event.host_time_s, event.text.c_str());
			break;
		case LibertyEvent::Kind::FAILURE:
			std::printf("failure %.6f %s\n", event.host_time_s, event.text.c_str());
			break;
	}
}

/// Whether the wanted part of the stream has come.
class StreamEnd {
public:
	StreamEnd(double stream_s, int connection) : stream_s_(stream_s), connection_(connection) {}

	void add(const LibertyEvent &event) {
		if (event.kind == LibertyEvent::Kind::CONNECTED) {
			++connections_;
		} else if (event.kind == LibertyEvent::Kind::RECORD && connections_ == connection_) {
			first_s_ = has_record_ ? first_s_ : event.device_time_s;
			has_record_ = true;
			has_come_ = event.device_time_s - first_s_ >= stream_s_;
		}
	}
	[[nodiscard]] bool has_come() const { return has_come_; }

private:
	double stream_s_, first_s_ = 0.0;
	int connection_, connections_ = 0;
	bool has_record_ = false, has_come_ = false;
};

} // namespace

int main(int argc, char **argv) {
	if (argc < 2) {
		std::fputs("liberty_probe SECONDS [STREAM_S CONNECTION]\n", stderr);
		return 2;
	}
	using Clock = std::chrono::steady_clock;
	const auto end = Clock::now() + std::chrono::duration<double>(std::strtod(argv[1], nullptr));
	StreamEnd wanted(argc > 3 ? std::strtod(argv[2], nullptr) : HUGE_VAL,
			argc > 3 ? static_cast<int>(std::strtol(argv[3], nullptr, 10)) : 1);
	LibertyDevice device;
	LibertyEvent event;
	device.start(LibertySettings());
	while (Clock::now() < end && !wanted.has_come()) {
		while (device.next(event)) {
			print(event);
			wanted.add(event);
		}
		std::this_thread::sleep_for(std::chrono::milliseconds(8)); // a game's frame
	}
	device.stop();
	device.stop();
	while (device.next(event)) {
		print(event);
	}
	std::printf("end %llu dropped\n", static_cast<unsigned long long>(device.dropped_records()));
	return 0;
}
