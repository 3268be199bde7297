#pragma once

#include "haptics/spring.h"

#include <godot_cpp/classes/audio_frame.hpp>
#include <godot_cpp/classes/audio_stream.hpp>
#include <godot_cpp/classes/audio_stream_playback.hpp>

#include <atomic>
#include <memory>

namespace godot {

/// All that passes from the scene to the audio thread.
struct HapticLevel {
	std::atomic<float> amplitude = 0.0F; ///< 0..1
	std::atomic<float> frequency_hz = static_cast<float>(steadyhand::SpringWaveform::DEFAULT_FREQUENCY_HZ);
	static_assert(std::atomic<float>::is_always_lock_free);
};

/// Makes the vibration on the audio thread, block by block; the amplitude is ramped inside each, so that it
/// never steps.
class HapticStreamPlayback : public AudioStreamPlayback {
	GDCLASS(HapticStreamPlayback, AudioStreamPlayback)

	static constexpr std::size_t BLOCK = 256;

	std::shared_ptr<HapticLevel> level_ = std::make_shared<HapticLevel>();
	std::unique_ptr<steadyhand::SpringWaveform> waveform_;
	std::array<float, BLOCK> samples_{};
	std::atomic<bool> playing_ = false;

protected:
	static void _bind_methods() {}

public:
	HapticStreamPlayback();
	void follow(const std::shared_ptr<HapticLevel> &p_level) { level_ = p_level; }

	void _start(double p_from_pos) override;
	void _stop() override;
	bool _is_playing() const override { return playing_; }
	int32_t _mix(AudioFrame *p_buffer, float p_rate_scale, int32_t p_frames) override;
};

/// The endless vibration of a HapticSynth.
class HapticStream : public AudioStream {
	GDCLASS(HapticStream, AudioStream)

	std::shared_ptr<HapticLevel> shared_level_ = std::make_shared<HapticLevel>();

protected:
	static void _bind_methods() {}

public:
	HapticLevel &level() { return *shared_level_; }

	Ref<AudioStreamPlayback> _instantiate_playback() const override;
	String _get_stream_name() const override { return "Vibration"; }
	/// Endless.
	double _get_length() const override { return 0.0; }
	bool _is_monophonic() const override { return true; }
};

} // namespace godot
