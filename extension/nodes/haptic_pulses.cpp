#include "haptic_pulses.h"

#include <godot_cpp/classes/input.hpp>
#include <godot_cpp/classes/xr_node3d.hpp>

namespace godot {

namespace {

/// Of a joypad's motors the light one turns faster than this, the heavy one more slowly.
constexpr double HEAVY_BELOW_HZ = 100.0;

} // namespace

void ControllerPulses::send(const steadyhand::Pulse &p_pulse) {
	XRNode3D *const controller = Object::cast_to<XRNode3D>(ObjectDB::get_instance(controller_id_));
	if (controller != nullptr) {
		controller->trigger_haptic_pulse(
				action_, p_pulse.frequency_hz, p_pulse.amplitude, p_pulse.duration_s, 0.0);
	}
}

void JoypadPulses::send(const steadyhand::Pulse &p_pulse) {
	Input *const input = Input::get_singleton();
	const auto amplitude = static_cast<float>(p_pulse.amplitude);
	if (p_pulse.amplitude <= 0.0) {
		input->stop_joy_vibration(joypad_);
	} else if (p_pulse.frequency_hz < HEAVY_BELOW_HZ) {
		input->start_joy_vibration(joypad_, 0.0F, amplitude, static_cast<float>(p_pulse.duration_s));
	} else {
		input->start_joy_vibration(joypad_, amplitude, 0.0F, static_cast<float>(p_pulse.duration_s));
	}
}

} // namespace godot
