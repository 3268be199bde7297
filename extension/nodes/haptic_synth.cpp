#include "haptic_synth.h"

#include "gesture_hmm.h"

#include <godot_cpp/classes/audio_server.hpp>
#include <godot_cpp/classes/audio_stream_player.hpp>
#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/core/class_db.hpp>

#include <algorithm>
#include <cmath>

namespace godot {

namespace {

/// A motion that is not driven on for this long of real time is over: a paused tracker must not keep the hand
/// buzzing.
constexpr double QUIET_AFTER_S = 0.1;

} // namespace

HapticSynth::~HapticSynth() {
	if (gesture_hmm != nullptr) {
		gesture_hmm->remove_listener(this);
	}
}

void HapticSynth::_notification(int p_what) {
	if (p_what == NOTIFICATION_ENTER_TREE) {
		update_player();
	} else if (p_what == NOTIFICATION_INTERNAL_PROCESS) {
		quiet_s = motion_came ? 0.0 : quiet_s + get_process_delta_time();
		motion_came = false;
		if (quiet_s > QUIET_AFTER_S) {
			stream->level().amplitude.store(0.0F, std::memory_order_relaxed);
		}
	}
}

void HapticSynth::on_motion_started() {
	if (wav) {
		wav->start_anew();
	}
	set_amplitude(0.0);
}

void HapticSynth::on_motion(double p_time_s, double p_displacement) {
	const double displacement = std::isfinite(p_displacement) ? std::clamp(p_displacement, 0.0, 1.0) : 0.0;
	set_amplitude(displacement * gain);
	if (wav_wanted) {
		wav_wanted = false;
		wav = std::make_unique<HapticWav>(wav_sample_rate_hz, frequency_hz);
		if (wav->open(wav_path) != OK) {
			wav.reset();
		}
	}
	if (wav) {
		wav->advance(p_time_s, amplitude);
	}
}

void HapticSynth::on_motion_freed() {
	gesture_hmm = nullptr;
	set_amplitude(0.0);
	update_configuration_warnings();
}

void HapticSynth::set_amplitude(double p_amplitude) {
	amplitude = p_amplitude;
	motion_came = true;
	if (stream.is_valid()) {
		stream->level().amplitude.store(static_cast<float>(amplitude), std::memory_order_relaxed);
	}
}

void HapticSynth::set_gesture_hmm(GestureHMM *p_gesture_hmm) {
	if (gesture_hmm == p_gesture_hmm) {
		return;
	}
	if (gesture_hmm != nullptr) {
		gesture_hmm->remove_listener(this);
	}
	gesture_hmm = p_gesture_hmm;
	if (gesture_hmm != nullptr) {
		gesture_hmm->add_listener(this);
	}
	on_motion_started();
	update_configuration_warnings();
}

void HapticSynth::set_frequency(double p_frequency_hz) {
	ERR_FAIL_COND_MSG(!(p_frequency_hz > 0.0) || !std::isfinite(p_frequency_hz),
			"HapticSynth: frequency must be above 0 Hz");
	frequency_hz = p_frequency_hz;
	if (stream.is_valid()) {
		stream->level().frequency_hz.store(static_cast<float>(frequency_hz), std::memory_order_relaxed);
	}
	if (wav) {
		wav->set_frequency(frequency_hz);
	}
}

void HapticSynth::set_gain(double p_gain) {
	ERR_FAIL_COND_MSG(!(p_gain >= 0.0 && p_gain <= 1.0), "HapticSynth: gain must be within 0..1");
	gain = p_gain;
}

void HapticSynth::set_bus(const StringName &p_bus) {
	bus = p_bus;
	if (is_inside_tree()) {
		update_player();
	}
	update_configuration_warnings();
}

void HapticSynth::update_player() {
	if (Engine::get_singleton()->is_editor_hint()) {
		return;
	}
	const bool exists = bus != StringName() && AudioServer::get_singleton()->get_bus_index(bus) >= 0;
	if (bus != StringName() && !exists) {
		// The engine would play on Master: through the loudspeakers.
		ERR_PRINT(String("HapticSynth: there is no audio bus '") + String(bus) +
				String("'; nothing is played"));
	}
	if (exists && player == nullptr) {
		stream.instantiate();
		set_frequency(frequency_hz);
		player = memnew(AudioStreamPlayer);
		player->set_stream(stream);
		player->set_autoplay(true);
		player->set_bus(bus);
		add_child(player, false, INTERNAL_MODE_FRONT);
	} else if (exists) {
		player->set_bus(bus);
	} else if (player != nullptr) {
		player->queue_free();
		player = nullptr;
		stream.unref();
	}
	set_process_internal(exists);
}

void HapticSynth::set_wav_path(const String &p_path) {
	stop_wav();
	wav_path = p_path;
	wav_wanted = !p_path.is_empty() && !Engine::get_singleton()->is_editor_hint();
}

void HapticSynth::set_wav_sample_rate(int p_rate_hz) {
	ERR_FAIL_COND_MSG(p_rate_hz < 8000 || p_rate_hz > 192000,
			"HapticSynth: wav_sample_rate must be in 8000..192000 Hz");
	wav_sample_rate_hz = p_rate_hz;
}

void HapticSynth::stop_wav() {
	wav.reset();
	wav_wanted = false;
}

PackedStringArray HapticSynth::_get_configuration_warnings() const {
	PackedStringArray warnings;
	if (gesture_hmm == nullptr) {
		warnings.push_back("Set \"gesture_hmm\" to the GestureHMM whose motion is to be felt.");
	}
	if (bus == StringName() && wav_path.is_empty()) {
		warnings.push_back(
				"Set \"bus\" to an audio bus that leads to the actuator, or \"wav_path\" to a file; "
				"otherwise the vibration goes nowhere.");
	} else if (bus != StringName() && AudioServer::get_singleton()->get_bus_index(bus) < 0) {
		warnings.push_back(String("Add an audio bus named '") + String(bus) +
				String("' in the Audio panel, or set \"bus\" to one that exists."));
	}
	return warnings;
}

void HapticSynth::_validate_property(PropertyInfo &p_property) const {
	if (p_property.name == StringName("bus")) {
		AudioServer *const server = AudioServer::get_singleton();
		String names;
		for (int32_t i = 0; i < server->get_bus_count(); ++i) {
			names += (i > 0 ? String(",") : String()) + String(server->get_bus_name(i));
		}
		p_property.hint = PROPERTY_HINT_ENUM_SUGGESTION;
		p_property.hint_string = names;
	}
}

void HapticSynth::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_gesture_hmm", "gesture_hmm"), &HapticSynth::set_gesture_hmm);
	ClassDB::bind_method(D_METHOD("get_gesture_hmm"), &HapticSynth::get_gesture_hmm);
	ClassDB::bind_method(D_METHOD("set_effect", "effect"), &HapticSynth::set_effect);
	ClassDB::bind_method(D_METHOD("get_effect"), &HapticSynth::get_effect);
	ClassDB::bind_method(D_METHOD("set_frequency", "frequency"), &HapticSynth::set_frequency);
	ClassDB::bind_method(D_METHOD("get_frequency"), &HapticSynth::get_frequency);
	ClassDB::bind_method(D_METHOD("set_gain", "gain"), &HapticSynth::set_gain);
	ClassDB::bind_method(D_METHOD("get_gain"), &HapticSynth::get_gain);
	ClassDB::bind_method(D_METHOD("set_bus", "bus"), &HapticSynth::set_bus);
	ClassDB::bind_method(D_METHOD("get_bus"), &HapticSynth::get_bus);
	ClassDB::bind_method(D_METHOD("set_wav_path", "path"), &HapticSynth::set_wav_path);
	ClassDB::bind_method(D_METHOD("get_wav_path"), &HapticSynth::get_wav_path);
	ClassDB::bind_method(D_METHOD("set_wav_sample_rate", "rate"), &HapticSynth::set_wav_sample_rate);
	ClassDB::bind_method(D_METHOD("get_wav_sample_rate"), &HapticSynth::get_wav_sample_rate);
	ClassDB::bind_method(D_METHOD("get_amplitude"), &HapticSynth::get_amplitude);
	ClassDB::bind_method(D_METHOD("stop_wav"), &HapticSynth::stop_wav);

	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "gesture_hmm", PROPERTY_HINT_NODE_TYPE, "GestureHMM"),
			"set_gesture_hmm", "get_gesture_hmm");
	ADD_PROPERTY(
			PropertyInfo(Variant::INT, "effect", PROPERTY_HINT_ENUM, "Spring"), "set_effect", "get_effect");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "frequency", PROPERTY_HINT_RANGE,
						 "20,1000,1,or_greater,or_less,suffix:Hz"),
			"set_frequency", "get_frequency");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "gain", PROPERTY_HINT_RANGE, "0,1,0.01"), "set_gain", "get_gain");
	ADD_GROUP("Output", "");
	ADD_PROPERTY(PropertyInfo(Variant::STRING_NAME, "bus"), "set_bus", "get_bus");
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "wav_path", PROPERTY_HINT_GLOBAL_SAVE_FILE, "*.wav"),
			"set_wav_path", "get_wav_path");
	ADD_PROPERTY(
			PropertyInfo(Variant::INT, "wav_sample_rate", PROPERTY_HINT_RANGE, "8000,192000,1,suffix:Hz"),
			"set_wav_sample_rate", "get_wav_sample_rate");

	BIND_ENUM_CONSTANT(EFFECT_SPRING);
}

} // namespace godot
