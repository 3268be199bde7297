#pragma once

#include "haptic_sink.h"

#include "haptics/pulse_train.h"

#include <godot_cpp/core/object_id.hpp>
#include <godot_cpp/variant/string_name.hpp>

namespace godot {

class XRNode3D;

/// Sends the strength of the vibration to outputs that make their own waveform.
class HapticPulses : public HapticSink {
public:
	void set_effects(const steadyhand::EffectSet &p_effects) override { effects_ = p_effects; }
	/// Only the scene's thread reads the tables.
	std::uint64_t oldest_generation() const override { return effects_.generation; }
	void restart() override { stop(); }
	bool is_live() const override { return true; }
	void play(const steadyhand::LiveMotion &p_motion) override {
		if (is_paused_) {
			return;
		}
		if (const auto pulse = train_.next(effects_, p_motion)) {
			send(*pulse);
		}
	}

	/// Ends the vibration.
	void stop() {
		if (train_.restart()) {
			// The same duration as PulseTrain's last pulse.
			send({ .duration_s = steadyhand::PulseTrain::DURATION_S });
		}
	}

	void set_paused(bool p_paused) {
		is_paused_ = p_paused;
		stop();
	}

protected:
	/// An amplitude of 0 ends the current pulse.
	virtual void send(const steadyhand::Pulse &p_pulse) = 0;

private:
	steadyhand::EffectSet effects_;
	steadyhand::PulseTrain train_;
	bool is_paused_ = false;
};

/// Pulses of an XR controller, by a haptic action of the XR interface.
class ControllerPulses : public HapticPulses {
public:
	ControllerPulses(uint64_t p_controller_id, const StringName &p_action) :
			controller_id_(p_controller_id), action_(p_action) {}

protected:
	void send(const steadyhand::Pulse &p_pulse) override;

private:
	ObjectID controller_id_;
	StringName action_;
};

/// Pulses of a joypad's two motors.
class JoypadPulses : public HapticPulses {
public:
	explicit JoypadPulses(int p_joypad) : joypad_(p_joypad) {}

protected:
	void send(const steadyhand::Pulse &p_pulse) override;

private:
	int joypad_;
};

} // namespace godot
