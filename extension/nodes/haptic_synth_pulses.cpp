// HapticSynth's outputs that get only the strength.

#include "haptic_synth.h"

#include "node_label.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/input.hpp>
#include <godot_cpp/classes/project_settings.hpp>
#include <godot_cpp/classes/xr_interface.hpp>
#include <godot_cpp/classes/xr_node3d.hpp>
#include <godot_cpp/classes/xr_server.hpp>
#include <godot_cpp/core/class_db.hpp>

#include <limits>
#include <utility>

namespace godot {

namespace {

/// Whether a tracker is no controller, by the names of the engine's XR interfaces.
bool is_without_motor(const String &p_tracker) {
	return p_tracker == "head" || p_tracker.begins_with("/user/hand_tracker/") ||
			p_tracker.begins_with("/user/body_tracker") || p_tracker.begins_with("/user/face_tracker") ||
			p_tracker.begins_with("/user/eyes_ext");
}

} // namespace

void HapticSynth::set_controller(XRNode3D *p_controller) {
	controller_id_ = ObjectID(p_controller != nullptr ? p_controller->get_instance_id() : 0);
	update_pulses();
}

XRNode3D *HapticSynth::get_controller() const {
	return Object::cast_to<XRNode3D>(ObjectDB::get_instance(controller_id_));
}

void HapticSynth::set_controller_action(const StringName &p_action) {
	controller_action_ = p_action;
	update_pulses();
}

void HapticSynth::set_joypad(int64_t p_joypad) {
	ERR_FAIL_COND_MSG(p_joypad < NO_JOYPAD || p_joypad > std::numeric_limits<int>::max(),
			refusal(*this, "joypad must be -1 (none) or the number of a joypad", p_joypad));
	joypad_ = static_cast<int>(p_joypad);
	update_pulses();
}

void HapticSynth::drop_pulses() {
	pause_pulses(true);
	controller_pulses_.reset();
	joypad_pulses_.reset();
}

void HapticSynth::pause_pulses(bool p_paused) {
	for (HapticPulses *const pulses : { controller_pulses_.get(), joypad_pulses_.get() }) {
		if (pulses != nullptr) {
			pulses->set_paused(p_paused);
		}
	}
}

void HapticSynth::update_pulses() {
	drop_pulses();
	update_configuration_warnings();
	if (Engine::get_singleton()->is_editor_hint() || !is_inside_tree()) {
		return;
	}
	if (controller_id_.is_valid()) {
		controller_pulses_ = std::make_unique<ControllerPulses>(controller_id_, controller_action_);
		add_sink(*controller_pulses_);
	}
	if (joypad_ != NO_JOYPAD) {
		joypad_pulses_ = std::make_unique<JoypadPulses>(joypad_);
		add_sink(*joypad_pulses_);
	}
	pause_pulses(!can_process());
	PackedStringArray missing;
	add_sink_warnings(missing);
	for (int64_t i = 0; i < missing.size(); ++i) {
		if (!warned_.has(missing[i])) {
			WARN_PRINT(node_label(*this) + String(": ") + missing[i]);
		}
	}
	warned_ = std::move(missing);
}

void HapticSynth::listen_to_joypads(bool p_listen) {
	const Callable callable = callable_mp(this, &HapticSynth::on_joypad_changed);
	if (p_listen) {
		Input::get_singleton()->connect("joy_connection_changed", callable);
	} else {
		Input::get_singleton()->disconnect("joy_connection_changed", callable);
	}
}

void HapticSynth::on_joypad_changed(int64_t p_joypad, bool p_is_connected) {
	if (p_joypad != joypad_) {
		return;
	}
	update_configuration_warnings();
	if (!p_is_connected && !Engine::get_singleton()->is_editor_hint()) {
		WARN_PRINT(node_label(*this) + String(": joypad ") + itos(joypad_) +
				String(" was disconnected. It vibrates again once it is connected"));
	}
}

void HapticSynth::add_sink_warnings(PackedStringArray &r_warnings) const {
	const XRNode3D *const controller = get_controller();
	if (controller != nullptr) {
		// In the editor no interface runs, so the project setting decides.
		const bool has_interface = Engine::get_singleton()->is_editor_hint()
				? bool(ProjectSettings::get_singleton()->get_setting("xr/openxr/enabled", false))
				: XRServer::get_singleton()->get_primary_interface().is_valid();
		if (!has_interface) {
			r_warnings.push_back("The \"controller\" cannot vibrate: there is no XR interface. Enable XR > "
								 "OpenXR in the project "
								 "settings, or initialise an XRInterface first.");
		}
		const String tracker = controller->get_tracker();
		if (tracker.is_empty()) {
			r_warnings.push_back(
					"Set the \"tracker\" of the node in \"controller\", for example to left_hand.");
		} else if (is_without_motor(tracker)) {
			r_warnings.push_back(
					String("Set the \"tracker\" of the node in \"controller\" to a controller, for example "
						   "left_hand: ") +
					tracker + String(" does not vibrate."));
		}
		if (controller_action_ == StringName()) {
			r_warnings.push_back(
					"Set \"controller_action\" to a haptic action of the action map, for example haptic.");
		}
	}
	if (joypad_ != NO_JOYPAD && !Input::get_singleton()->get_connected_joypads().has(joypad_)) {
		r_warnings.push_back(String("Connect joypad ") + itos(joypad_) +
				String(", or set \"joypad\" to one that is connected, or to -1 (none)."));
	}
}

} // namespace godot
