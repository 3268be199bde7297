#include "haptic_stream.h"

#include <godot_cpp/classes/audio_server.hpp>
#include <godot_cpp/core/class_db.hpp>

#include <algorithm>

namespace godot {

HapticStreamPlayback::HapticStreamPlayback() :
		waveform_(std::make_unique<steadyhand::SpringWaveform>(
				static_cast<double>(AudioServer::get_singleton()->get_mix_rate()))) {}

void HapticStreamPlayback::_start(double) {
	playing_ = true;
}

void HapticStreamPlayback::_stop() {
	playing_ = false;
}

int32_t HapticStreamPlayback::_mix(AudioFrame *p_buffer, float, int32_t p_frames) {
	waveform_->set_frequency(static_cast<double>(level_->frequency_hz.load(std::memory_order_relaxed)));
	const double amplitude = static_cast<double>(level_->amplitude.load(std::memory_order_relaxed));
	for (int32_t done = 0; done < p_frames;) {
		const std::size_t count = std::min(static_cast<std::size_t>(p_frames - done), samples_.size());
		waveform_->render(std::span(samples_).first(count), amplitude);
		for (std::size_t i = 0; i < count; ++i) {
			p_buffer[done++] = { samples_[i], samples_[i] };
		}
	}
	return p_frames;
}

Ref<AudioStreamPlayback> HapticStream::_instantiate_playback() const {
	Ref<HapticStreamPlayback> playback;
	playback.instantiate();
	playback->follow(shared_level_);
	return playback;
}

} // namespace godot
