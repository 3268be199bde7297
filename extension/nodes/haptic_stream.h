#pragma once

#include "haptics/live_vibration.h"

#include <godot_cpp/classes/audio_frame.hpp>
#include <godot_cpp/classes/audio_stream.hpp>
#include <godot_cpp/classes/audio_stream_playback.hpp>

#include <atomic>
#include <cstdint>
#include <memory>

namespace godot {

/// Renders the vibration on the audio thread.
class HapticStreamPlayback : public AudioStreamPlayback {
	GDCLASS(HapticStreamPlayback, AudioStreamPlayback)

	static inline std::atomic<int> instances_ = 0;
	static inline std::atomic<std::uint32_t> mixes_ = 0; ///< of all playbacks
	static inline std::uint32_t mixes_at_stop_ = 0;

	std::unique_ptr<steadyhand::LiveVibration> vibration_;
	std::atomic<bool> playing_ = false;

protected:
	static void _bind_methods() {}

public:
	HapticStreamPlayback() { ++instances_; }
	~HapticStreamPlayback() override { --instances_; }

	void follow(const std::shared_ptr<steadyhand::VibrationLink> &p_link);

	/// Call it when a player is stopped.
	static void note_stop() { mixes_at_stop_ = mixes_; }
	/// The audio thread mixes a stopped playback once more, to fade it out. The library must not be unloaded
	/// before.
	static void wait_for_last_mix();

	void _start(double p_from_pos) override;
	void _stop() override;
	bool _is_playing() const override { return playing_; }
	int32_t _mix(AudioFrame *p_buffer, float p_rate_scale, int32_t p_frames) override;
};

/// The vibration of a HapticSynth as an audio stream without an end.
class HapticStream : public AudioStream {
	GDCLASS(HapticStream, AudioStream)

	std::shared_ptr<steadyhand::VibrationLink> link_ = std::make_shared<steadyhand::VibrationLink>();

protected:
	static void _bind_methods() {}

public:
	void follow(const std::shared_ptr<steadyhand::VibrationLink> &p_link) { link_ = p_link; }

	Ref<AudioStreamPlayback> _instantiate_playback() const override;
	String _get_stream_name() const override { return "Vibration"; }
	/// 0: no end.
	double _get_length() const override { return 0.0; }
	bool _is_monophonic() const override { return true; }
};

} // namespace godot
