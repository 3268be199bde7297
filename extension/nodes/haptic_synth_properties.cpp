// Properties and methods of HapticSynth for the inspector and scripts.

#include "gesture_hmm.h"
#include "haptic_synth.h"
#include "name_suggestions.h"
#include "parent_as.h"
#include "sample_rates.h"

#include <godot_cpp/classes/audio_server.hpp>
#include <godot_cpp/classes/xr_node3d.hpp>
#include <godot_cpp/core/class_db.hpp>

namespace godot {

/// Be it one that is missing.
bool HapticSynth::has_output() const {
	return bus_ != StringName() || !wav_path_.is_empty() || get_controller() != nullptr ||
			joypad_ != NO_JOYPAD;
}

PackedStringArray HapticSynth::_get_configuration_warnings() const {
	PackedStringArray warnings;
	if (gesture_hmm_ == nullptr && parent_as<GestureHMM>(*this) == nullptr) {
		warnings.push_back(
				"Set \"gesture_hmm\" to the GestureHMM whose motion is felt, or make this node its child.");
	}
	if (!has_output()) {
		warnings.push_back(
				"Set \"bus\" to an audio bus that leads to the actuator, \"controller\" or \"joypad\", or "
				"\"wav_path\" to a file. Without one of them, only a script that calls get_buffer() gets the "
				"vibration.");
	} else if (bus_ != StringName() && !bus_exists()) {
		warnings.push_back(String("Add an audio bus named '") + String(bus_) +
				String("' in the Audio panel, or set \"bus\" to one that exists."));
	}
	add_sink_warnings(warnings);
	bool has_empty = false;
	for (int64_t i = 0; i < effects_.size(); ++i) {
		const Ref<HapticEffect> effect = effects_[i];
		has_empty = has_empty || effect.is_null();
	}
	if (has_empty) {
		warnings.push_back("Remove the empty entry from \"effects\", or make a HapticEffect in it.");
	}
	if (effects_.size() > static_cast<int64_t>(steadyhand::EffectSet::MOST)) {
		warnings.push_back(String("Remove effects: only the first ") +
				itos(static_cast<int64_t>(steadyhand::EffectSet::MOST)) + String(" are felt."));
	}
	if (device_.is_valid() && device_->has_unusable_points()) {
		warnings.push_back("Give each point of the \"response\" of \"device\" a frequency above 0 Hz and a "
						   "response of 0 or more. Other points are left out.");
	}
	return warnings;
}

void HapticSynth::_validate_property(PropertyInfo &p_property) const {
	if (p_property.name == StringName("bus")) {
		AudioServer *const server = AudioServer::get_singleton();
		PackedStringArray names;
		for (int32_t i = 0; i < server->get_bus_count(); ++i) {
			names.push_back(server->get_bus_name(i));
		}
		suggest(names, p_property);
	}
}

void HapticSynth::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_gesture_hmm", "gesture_hmm"), &HapticSynth::set_gesture_hmm);
	ClassDB::bind_method(D_METHOD("get_gesture_hmm"), &HapticSynth::get_gesture_hmm);
	ClassDB::bind_method(D_METHOD("set_effects", "effects"), &HapticSynth::set_effects);
	ClassDB::bind_method(D_METHOD("get_effects"), &HapticSynth::get_effects);
	ClassDB::bind_method(D_METHOD("set_gain", "gain"), &HapticSynth::set_gain);
	ClassDB::bind_method(D_METHOD("get_gain"), &HapticSynth::get_gain);
	ClassDB::bind_method(D_METHOD("set_arrival_level", "level"), &HapticSynth::set_arrival_level);
	ClassDB::bind_method(D_METHOD("get_arrival_level"), &HapticSynth::get_arrival_level);
	ClassDB::bind_method(D_METHOD("set_device", "device"), &HapticSynth::set_device);
	ClassDB::bind_method(D_METHOD("get_device"), &HapticSynth::get_device);
	ClassDB::bind_method(D_METHOD("set_bus", "bus"), &HapticSynth::set_bus);
	ClassDB::bind_method(D_METHOD("get_bus"), &HapticSynth::get_bus);
	ClassDB::bind_method(D_METHOD("set_controller", "controller"), &HapticSynth::set_controller);
	ClassDB::bind_method(D_METHOD("get_controller"), &HapticSynth::get_controller);
	ClassDB::bind_method(D_METHOD("set_controller_action", "action"), &HapticSynth::set_controller_action);
	ClassDB::bind_method(D_METHOD("get_controller_action"), &HapticSynth::get_controller_action);
	ClassDB::bind_method(D_METHOD("set_joypad", "joypad"), &HapticSynth::set_joypad);
	ClassDB::bind_method(D_METHOD("get_joypad"), &HapticSynth::get_joypad);
	ClassDB::bind_method(D_METHOD("set_wav_path", "path"), &HapticSynth::set_wav_path);
	ClassDB::bind_method(D_METHOD("get_wav_path"), &HapticSynth::get_wav_path);
	ClassDB::bind_method(D_METHOD("set_wav_sample_rate", "rate"), &HapticSynth::set_wav_sample_rate);
	ClassDB::bind_method(D_METHOD("get_wav_sample_rate"), &HapticSynth::get_wav_sample_rate);
	ClassDB::bind_method(D_METHOD("set_buffer_sample_rate", "rate"), &HapticSynth::set_buffer_sample_rate);
	ClassDB::bind_method(D_METHOD("get_buffer_sample_rate"), &HapticSynth::get_buffer_sample_rate);
	ClassDB::bind_method(D_METHOD("get_amplitude"), &HapticSynth::get_amplitude);
	ClassDB::bind_method(D_METHOD("stop_wav"), &HapticSynth::stop_wav);
	ClassDB::bind_method(D_METHOD("get_buffer", "frames"), &HapticSynth::get_buffer);

	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "gesture_hmm", PROPERTY_HINT_NODE_TYPE, "GestureHMM"),
			"set_gesture_hmm", "get_gesture_hmm");
	const String effect_hint =
			itos(Variant::OBJECT) + String("/") + itos(PROPERTY_HINT_RESOURCE_TYPE) + ":HapticEffect";
	ADD_PROPERTY(PropertyInfo(Variant::ARRAY, "effects", PROPERTY_HINT_ARRAY_TYPE, effect_hint),
			"set_effects", "get_effects");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "gain", PROPERTY_HINT_RANGE, "0,1,0.01"), "set_gain", "get_gain");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "arrival_level", PROPERTY_HINT_RANGE, "0.51,1,0.01"),
			"set_arrival_level", "get_arrival_level");
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "device", PROPERTY_HINT_RESOURCE_TYPE, "HapticDeviceProfile"),
			"set_device", "get_device");
	ADD_GROUP("Output", "");
	ADD_PROPERTY(PropertyInfo(Variant::STRING_NAME, "bus"), "set_bus", "get_bus");
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "controller", PROPERTY_HINT_NODE_TYPE, "XRNode3D"),
			"set_controller", "get_controller");
	// Name in the default action map that Godot makes for OpenXR.
	ADD_PROPERTY(
			PropertyInfo(Variant::STRING_NAME, "controller_action", PROPERTY_HINT_ENUM_SUGGESTION, "haptic"),
			"set_controller_action", "get_controller_action");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "joypad", PROPERTY_HINT_RANGE, "-1,15,1,or_greater"),
			"set_joypad", "get_joypad");
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "wav_path", PROPERTY_HINT_GLOBAL_SAVE_FILE, "*.wav"),
			"set_wav_path", "get_wav_path");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "wav_sample_rate", PROPERTY_HINT_RANGE, sample_rate_hint()),
			"set_wav_sample_rate", "get_wav_sample_rate");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "buffer_sample_rate", PROPERTY_HINT_RANGE, sample_rate_hint()),
			"set_buffer_sample_rate", "get_buffer_sample_rate");
}

} // namespace godot
