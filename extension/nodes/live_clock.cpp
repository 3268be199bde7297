#include "live_clock.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/time.hpp>

#include <algorithm>
#include <cstdint>

namespace godot {

namespace {

/// The longest frame that the engine does not cut short is a little longer.
constexpr double FARTHEST_BEHIND_S = 0.1;

struct LiveClock {
	bool is_set = false;
	uint64_t frame = 0;
	double time_s = 0.0;
};

LiveClock &live_clock() {
	static LiveClock clock;
	return clock;
}

} // namespace

double host_time_s() {
	return 1e-6 * static_cast<double>(Time::get_singleton()->get_ticks_usec());
}

double live_time_s(double p_frame_s) {
	LiveClock &clock = live_clock();
	Engine *const engine = Engine::get_singleton();
	const auto frame = static_cast<uint64_t>(engine->get_process_frames());
	const double host_s = host_time_s();
	if (!clock.is_set) {
		clock = { true, frame, host_s };
	} else if (frame != clock.frame) {
		const double scale = engine->get_time_scale();
		const double passed_s = scale > 0.0 ? p_frame_s / scale : 0.0;
		clock.time_s = std::max(clock.time_s + passed_s, host_s - FARTHEST_BEHIND_S);
		clock.frame = frame;
	}
	return clock.time_s;
}

} // namespace godot
