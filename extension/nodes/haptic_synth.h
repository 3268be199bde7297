#pragma once

#include "haptic_device_profile.h"
#include "haptic_effect.h"
#include "haptic_pulses.h"
#include "haptic_stream.h"
#include "haptic_wav.h"
#include "motion_listener.h"
#include "read_only_copy.h"

#include "haptics/arrival_detector.h"

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/variant/packed_vector2_array.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <algorithm>
#include <deque>
#include <limits>
#include <memory>

namespace godot {

class AudioStreamPlayer;
class GestureHMM;
class XRNode3D;

/// Turns a GestureHMM's motion into vibration. Outputs: an audio bus and a script's buffer, live; an XR
/// controller and a joypad, which get the strength; a WAV file, on the motion's clock.
class HapticSynth : public Node, public MotionListener {
	GDCLASS(HapticSynth, Node)

public:
	HapticSynth() = default;
	~HapticSynth() override;

	void set_gesture_hmm(GestureHMM *p_gesture_hmm);
	GestureHMM *get_gesture_hmm() const { return gesture_hmm_; }
	void set_effects(const TypedArray<HapticEffect> &p_effects);
	/// A read-only copy.
	TypedArray<HapticEffect> get_effects() const { return read_only_copy(effects_); }
	void set_gain(double p_gain);
	double get_gain() const { return gain_; }
	void set_arrival_level(double p_level);
	double get_arrival_level() const { return arrivals_.level(); }
	void set_device(const Ref<HapticDeviceProfile> &p_device);
	Ref<HapticDeviceProfile> get_device() const { return device_; }
	void set_bus(const StringName &p_bus);
	StringName get_bus() const { return bus_; }
	void set_controller(XRNode3D *p_controller);
	XRNode3D *get_controller() const;
	void set_controller_action(const StringName &p_action);
	StringName get_controller_action() const { return controller_action_; }
	void set_joypad(int64_t p_joypad);
	int get_joypad() const { return joypad_; }
	void set_wav_path(const String &p_path);
	String get_wav_path() const { return wav_path_; }
	void set_wav_sample_rate(int p_rate_hz);
	int get_wav_sample_rate() const { return wav_sample_rate_hz_; }
	void set_buffer_sample_rate(int p_rate_hz);
	int get_buffer_sample_rate() const { return buffer_sample_rate_hz_; }

	double get_amplitude() const;
	void stop_wav();
	PackedVector2Array get_buffer(int p_frames);

	void on_motion_ended() override;
	void on_motion(const MotionInstant &p_motion) override;
	void on_motion_known() override;
	void on_motion_freed() override;

	PackedStringArray _get_configuration_warnings() const override;

protected:
	static void _bind_methods();
	void _notification(int p_what);
	void _validate_property(PropertyInfo &p_property) const;

private:
	static constexpr int NO_JOYPAD = -1;
	static constexpr double NOT_SET = std::numeric_limits<double>::quiet_NaN();

	struct BusSink : LiveSink {
		double output_latency_s = 0.0;

		void play(const steadyhand::LiveMotion &p_motion) override {
			steadyhand::LiveMotion delayed = p_motion;
			delayed.heard_s = std::min(delayed.heard_s + output_latency_s, delayed.snapshot.end_s());
			LiveSink::play(delayed);
		}
	};
	/// For get_buffer().
	struct BufferSink : LiveSink {
		explicit BufferSink(int p_rate_hz) : vibration(link(), p_rate_hz, 2) {}
		steadyhand::LiveVibration vibration;
	};
	/// Tables of effects that may still be in use.
	struct TablesInUse {
		std::uint64_t generation;
		HapticEffect::Tables tables;
	};

	GestureHMM *gesture_hmm_ = nullptr;
	bool follows_parent_ = false; ///< gesture_hmm_ is the parent, because none was set
	TypedArray<HapticEffect> effects_;
	double gain_ = 1.0;
	Ref<HapticDeviceProfile> device_;
	StringName bus_;
	ObjectID controller_id_;
	StringName controller_action_ = "haptic";
	int joypad_ = NO_JOYPAD;
	String wav_path_;
	int wav_sample_rate_hz_ = 48000;
	int buffer_sample_rate_hz_ = 48000;

	steadyhand::EffectSet core_effects_;
	bool effects_are_set_ = false; ///< core_effects_ agree with the properties
	bool has_warned_of_null_ = false;
	StringName default_gesture_; ///< gesture whose default effects are used if "effects" is empty
	/// Shared with the links whose readers may use them.
	std::shared_ptr<std::deque<TablesInUse>> tables_ = std::make_shared<std::deque<TablesInUse>>();
	steadyhand::ArrivalDetector arrivals_;
	steadyhand::Strength strength_;
	double played_s_ = NOT_SET;    ///< time of the motion at the last play()
	bool has_vibrated_ = false;    ///< the strength was above 0
	mutable bool is_read_ = false; ///< a script has read samples or the amplitude
	double ready_for_s_ = 0.0;     ///< sum of the game's frame durations

	AudioStreamPlayer *player_ = nullptr; ///< a child of this node
	std::unique_ptr<BusSink> bus_sink_;
	double mix_rate_hz_ = 0.0; ///< of player_
	std::unique_ptr<HapticPulses> controller_pulses_;
	std::unique_ptr<HapticPulses> joypad_pulses_;
	PackedStringArray warned_; ///< warnings at the last check
	std::unique_ptr<BufferSink> buffer_;
	double buffer_kept_s_ = NOT_SET; ///< end of the buffer without a get_buffer() call
	std::unique_ptr<HapticWav> wav_;
	bool is_wav_pending_ = false; ///< the file is opened at the first motion

	template <class Function> void for_each_sink(Function p_function) const;
	void add_sink(HapticSink &p_sink);
	bool bus_exists() const;
	void listen_to_buses(bool p_listen);
	void check_audio();
	void on_buses_changed();
	void on_bus_renamed(int64_t, const StringName &, const StringName &) { on_buses_changed(); }
	void update_player();
	void make_player();
	void drop_player();
	void update_pulses();
	void drop_pulses();
	void pause_pulses(bool p_paused);
	void listen_to_joypads(bool p_listen);
	void on_joypad_changed(int64_t p_joypad, bool p_is_connected);
	bool has_output() const;
	void follow_parent();
	void warn_of_no_output();
	void add_sink_warnings(PackedStringArray &r_warnings) const;
	void open_wav();
	void on_effects_changed();
	void build_effects();
	StringName expected_gesture() const;
	void drop_old_tables();
	steadyhand::LiveMotion live_motion() const;
	void connect_effects(bool p_connect);
	void connect_changed(Object *p_object, bool p_connect);
};

} // namespace godot
