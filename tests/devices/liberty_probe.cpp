// liberty_probe SECONDS [RATE_HZ]: runs a LibertyDevice and prints its events, one a line.

#include "liberty_device.h"

#include <chrono>
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

} // namespace

int main(int argc, char **argv) {
	if (argc < 2) {
		std::fputs("liberty_probe SECONDS [RATE_HZ]\n", stderr);
		return 2;
	}
	using Clock = std::chrono::steady_clock;
	const auto end = Clock::now() + std::chrono::duration<double>(std::strtod(argv[1], nullptr));
	LibertySettings settings;
	settings.rate_hz = argc > 2 ? static_cast<int>(std::strtol(argv[2], nullptr, 10)) : settings.rate_hz;
	LibertyDevice device;
	LibertyEvent event;
	device.start(settings);
	while (Clock::now() < end) {
		while (device.next(event)) {
			print(event);
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
