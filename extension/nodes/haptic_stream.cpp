#include "haptic_stream.h"

#include <godot_cpp/classes/audio_server.hpp>
#include <godot_cpp/core/class_db.hpp>

#include <algorithm>

namespace godot {

HapticStreamPlayback::HapticStreamPlayback() :
		waveform(std::make_unique<steadyhand::SpringWaveform>(
				static_cast<double>(AudioServer::get_singleton()->get_mix_rate()))) {}

void HapticStreamPlayback::_start(double) {
	playing = true;
}

void HapticStreamPlayback::_stop() {
	playing = false;
}

int32_t HapticStreamPlayback::_mix(AudioFrame *p_buffer, float, int32_t p_frames) {
	waveform->set_frequency(static_cast<double>(level->frequency_hz.load(std::memory_order_relaxed)));
	const double amplitude = static_cast<double>(level->amplitude.load(std::memory_order_relaxed));
	for (int32_t done = 0; done < p_frames;) {
		const std::size_t count = std::min(static_cast<std::size_t>(p_frames - done), samples.size());
		waveform->render(std::span(samples).first(count), amplitude);
		for (std::size_t i = 0; i < count; ++i) {
			p_buffer[done++] = { samples[i], samples[i] };
		}
	}
	return p_frames;
}

Ref<AudioStreamPlayback> HapticStream::_instantiate_playback() const {
	Ref<HapticStreamPlayback> playback;
	playback.instantiate();
	playback->follow(shared_level);
	return playback;
}

} // namespace godot
