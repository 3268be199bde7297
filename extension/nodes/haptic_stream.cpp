#include "haptic_stream.h"

#include <godot_cpp/classes/audio_server.hpp>
#include <godot_cpp/core/class_db.hpp>

#include <algorithm>
#include <chrono>
#include <span>
#include <thread>

namespace godot {

static_assert(sizeof(AudioFrame) == 2 * sizeof(float), "two channels, interleaved");

void HapticStreamPlayback::follow(const std::shared_ptr<steadyhand::VibrationLink> &p_link) {
	const double rate_hz = static_cast<double>(AudioServer::get_singleton()->get_mix_rate());
	vibration_ = std::make_unique<steadyhand::LiveVibration>(p_link, rate_hz, 2);
}

void HapticStreamPlayback::wait_for_last_mix() {
	if (instances_ == 0) {
		return;
	}
	constexpr int LONGEST_MS = 200; // twice the period of Godot's Dummy audio driver, the longest
	for (int ms = 0; ms < LONGEST_MS && mixes_ == mixes_at_stop_; ++ms) {
		std::this_thread::sleep_for(std::chrono::milliseconds(1));
	}
	AudioServer *const server = AudioServer::get_singleton();
	server->lock(); // waits for the end of a running mix
	server->unlock();
}

void HapticStreamPlayback::_start(double) {
	playing_ = true;
}

void HapticStreamPlayback::_stop() {
	playing_ = false;
}

int32_t HapticStreamPlayback::_mix(AudioFrame *p_buffer, float, int32_t p_frames) {
	const std::span<float> samples(&p_buffer->left, 2 * static_cast<std::size_t>(std::max(p_frames, 0)));
	if (vibration_) {
		vibration_->render(samples);
	} else {
		std::fill(samples.begin(), samples.end(), 0.0F);
	}
	++mixes_;
	return p_frames;
}

Ref<AudioStreamPlayback> HapticStream::_instantiate_playback() const {
	Ref<HapticStreamPlayback> playback;
	playback.instantiate();
	playback->follow(link_);
	return playback;
}

} // namespace godot
