#pragma once

#include "haptic_stream.h"
#include "haptic_wav.h"
#include "motion_listener.h"

#include <godot_cpp/classes/node.hpp>

#include <memory>

namespace godot {

class AudioStreamPlayer;
class GestureHMM;

/// Turns a GestureHMM's motion into vibration: live to an audio bus, and on the motion's own clock to a WAV
/// file.
class HapticSynth : public Node, public MotionListener {
	GDCLASS(HapticSynth, Node)

public:
	enum Effect { EFFECT_SPRING };

	HapticSynth() = default;
	~HapticSynth() override;

	void set_gesture_hmm(GestureHMM *p_gesture_hmm);
	GestureHMM *get_gesture_hmm() const { return gesture_hmm_; }
	void set_effect(Effect p_effect) { effect_ = p_effect; }
	Effect get_effect() const { return effect_; }
	void set_frequency(double p_frequency_hz);
	double get_frequency() const { return frequency_hz_; }
	void set_gain(double p_gain);
	double get_gain() const { return gain_; }
	void set_bus(const StringName &p_bus);
	StringName get_bus() const { return bus_; }
	void set_wav_path(const String &p_path);
	String get_wav_path() const { return wav_path_; }
	void set_wav_sample_rate(int p_rate_hz);
	int get_wav_sample_rate() const { return wav_sample_rate_hz_; }

	double get_amplitude() const { return amplitude_; }
	void stop_wav();

	void on_motion_started() override;
	void on_motion(double p_time_s, double p_displacement) override;
	void on_motion_freed() override;

	PackedStringArray _get_configuration_warnings() const override;

protected:
	static void _bind_methods();
	void _notification(int p_what);
	void _validate_property(PropertyInfo &p_property) const;

private:
	GestureHMM *gesture_hmm_ = nullptr;
	Effect effect_ = EFFECT_SPRING;
	double frequency_hz_ = steadyhand::SpringWaveform::DEFAULT_FREQUENCY_HZ;
	double gain_ = 1.0;
	StringName bus_;
	String wav_path_;
	int wav_sample_rate_hz_ = 48000;

	double amplitude_ = 0.0;
	AudioStreamPlayer *player_ = nullptr; ///< a child of this node
	Ref<HapticStream> stream_;
	bool motion_came_ = false; ///< since the last process frame
	double quiet_s_ = 0.0;     ///< for how long none has come
	std::unique_ptr<HapticWav> wav_;
	bool wav_wanted_ = false; ///< opened with the first motion

	void update_player();
	void set_amplitude(double p_amplitude);
};

} // namespace godot

VARIANT_ENUM_CAST(godot::HapticSynth::Effect);
