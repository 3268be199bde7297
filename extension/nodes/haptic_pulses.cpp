#include "haptic_pulses.h"

#include <godot_cpp/classes/input.hpp>
#include <godot_cpp/classes/xr_node3d.hpp>

namespace godot {

void ControllerPulses::send(const steadyhand::Pulse &p_pulse) {
	XRNode3D *const controller = Object::cast_to<XRNode3D>(ObjectDB::get_instance(controller_id_));
	if (controller != nullptr) {
		controller->trigger_haptic_pulse(
				action_, p_pulse.frequency_hz, p_pulse.amplitude, p_pulse.duration_s, 0.0);
	}
}

void JoypadPulses::send(const steadyhand::Pulse &p_pulse) {
	Input *const input = Input::get_singleton();
	if (p_pulse.amplitude <= 0.0) {
		input->stop_joy_vibration(joypad_);
	} else {
		const auto light = static_cast<float>(p_pulse.amplitude - p_pulse.low);
		const auto heavy = static_cast<float>(p_pulse.low);
		input->start_joy_vibration(joypad_, light, heavy, static_cast<float>(p_pulse.duration_s));
	}
}

} // namespace godot
