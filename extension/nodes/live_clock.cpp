#include "live_clock.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/time.hpp>

#include <algorithm>
#include <cstdint>

namespace godot {

namespace {

struct LiveClock {
	bool is_set = false;
	uint64_t frame = 0; ///< game frame of the last call
	double host_s = 0.0;
	double time_s = 0.0;
};

LiveClock &live_clock() {
	static LiveClock clock;
	return clock;
}

/// The engine limits a frame's reported duration to the most physics ticks in one frame. For a longer frame
/// it reports slightly less than that.
double longest_frame_s(Engine &p_engine) {
	const auto ticks = static_cast<double>(p_engine.get_max_physics_steps_per_frame());
	return 0.9 * ticks / static_cast<double>(p_engine.get_physics_ticks_per_second());
}

} // namespace

double host_time_s() {
	return 1e-6 * static_cast<double>(Time::get_singleton()->get_ticks_usec());
}

double live_time_s(double p_frame_s) {
	LiveClock &clock = live_clock();
	Engine *const engine = Engine::get_singleton();
	const uint64_t frame = engine->get_process_frames();
	const double host_s = host_time_s();
	if (!clock.is_set) {
		clock = { true, frame, host_s, 0.0 };
	} else if (frame != clock.frame) {
		const double scale = engine->get_time_scale();
		const double frame_s = scale > 0.0 ? p_frame_s / scale : 0.0; // at 0 the game's time does not advance
		const double frames_s = frame_s * static_cast<double>(frame - clock.frame);
		const bool is_frame_time_usable = scale > 0.0 && frame_s < longest_frame_s(*engine);
		const double passed_s = is_frame_time_usable ? 0.0 : host_s - clock.host_s;
		clock = { true, frame, host_s, clock.time_s + std::max(frames_s, passed_s) };
	}
	return clock.time_s;
}

} // namespace godot
