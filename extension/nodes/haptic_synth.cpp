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
	if (gesture_hmm_ != nullptr) {
		gesture_hmm_->remove_listener(this);
	}
}

void HapticSynth::_notification(int p_what) {
	if (p_what == NOTIFICATION_ENTER_TREE) {
		update_player();
	} else if (p_what == NOTIFICATION_INTERNAL_PROCESS) {
		quiet_s_ = motion_came_ ? 0.0 : quiet_s_ + get_process_delta_time();
		motion_came_ = false;
		if (quiet_s_ > QUIET_AFTER_S) {
			stream_->level().amplitude.store(0.0F, std::memory_order_relaxed);
		}
	}
}

void HapticSynth::on_motion_started() {
	if (wav_) {
		wav_->start_anew();
	}
	set_amplitude(0.0);
}

void HapticSynth::on_motion(double p_time_s, double p_displacement) {
	const double displacement = std::isfinite(p_displacement) ? std::clamp(p_displacement, 0.0, 1.0) : 0.0;
	set_amplitude(displacement * gain_);
	if (wav_wanted_) {
		wav_wanted_ = false;
		wav_ = std::make_unique<HapticWav>(wav_sample_rate_hz_, frequency_hz_);
		if (wav_->open(wav_path_) != OK) {
			wav_.reset();
		}
	}
	if (wav_) {
		wav_->advance(p_time_s, amplitude_);
	}
}

void HapticSynth::on_motion_freed() {
	gesture_hmm_ = nullptr;
	set_amplitude(0.0);
	update_configuration_warnings();
}

void HapticSynth::set_amplitude(double p_amplitude) {
	amplitude_ = p_amplitude;
	motion_came_ = true;
	if (stream_.is_valid()) {
		stream_->level().amplitude.store(static_cast<float>(amplitude_), std::memory_order_relaxed);
	}
}

void HapticSynth::set_gesture_hmm(GestureHMM *p_gesture_hmm) {
	if (gesture_hmm_ == p_gesture_hmm) {
		return;
	}
	if (gesture_hmm_ != nullptr) {
		gesture_hmm_->remove_listener(this);
	}
	gesture_hmm_ = p_gesture_hmm;
	if (gesture_hmm_ != nullptr) {
		gesture_hmm_->add_listener(this);
	}
	on_motion_started();
	update_configuration_warnings();
}

void HapticSynth::set_frequency(double p_frequency_hz) {
	ERR_FAIL_COND_MSG(!(p_frequency_hz > 0.0) || !std::isfinite(p_frequency_hz),
			"HapticSynth: frequency must be above 0 Hz");
	frequency_hz_ = p_frequency_hz;
	if (stream_.is_valid()) {
		stream_->level().frequency_hz.store(static_cast<float>(frequency_hz_), std::memory_order_relaxed);
	}
	if (wav_) {
		wav_->set_frequency(frequency_hz_);
	}
}

void HapticSynth::set_gain(double p_gain) {
	ERR_FAIL_COND_MSG(
			std::isnan(p_gain) || p_gain < 0.0 || p_gain > 1.0, "HapticSynth: gain must be within 0..1");
	gain_ = p_gain;
}

void HapticSynth::set_bus(const StringName &p_bus) {
	bus_ = p_bus;
	if (is_inside_tree()) {
		update_player();
	}
	update_configuration_warnings();
}

void HapticSynth::update_player() {
	if (Engine::get_singleton()->is_editor_hint()) {
		return;
	}
	const bool exists = bus_ != StringName() && AudioServer::get_singleton()->get_bus_index(bus_) >= 0;
	if (bus_ != StringName() && !exists) {
		// The engine would play on Master: through the loudspeakers.
		ERR_PRINT(String("HapticSynth: there is no audio bus '") + String(bus_) +
				String("'; nothing is played"));
	}
	if (exists && player_ == nullptr) {
		stream_.instantiate();
		set_frequency(frequency_hz_);
		player_ = memnew(AudioStreamPlayer);
		player_->set_stream(stream_);
		player_->set_autoplay(true);
		player_->set_bus(bus_);
		add_child(player_, false, INTERNAL_MODE_FRONT);
	} else if (exists) {
		player_->set_bus(bus_);
	} else if (player_ != nullptr) {
		player_->queue_free();
		player_ = nullptr;
		stream_.unref();
	}
	set_process_internal(exists);
}

void HapticSynth::set_wav_path(const String &p_path) {
	stop_wav();
	wav_path_ = p_path;
	wav_wanted_ = !p_path.is_empty() && !Engine::get_singleton()->is_editor_hint();
}

void HapticSynth::set_wav_sample_rate(int p_rate_hz) {
	ERR_FAIL_COND_MSG(p_rate_hz < 8000 || p_rate_hz > 192000,
			"HapticSynth: wav_sample_rate must be in 8000..192000 Hz");
	wav_sample_rate_hz_ = p_rate_hz;
}

void HapticSynth::stop_wav() {
	wav_.reset();
	wav_wanted_ = false;
}

PackedStringArray HapticSynth::_get_configuration_warnings() const {
	PackedStringArray warnings;
	if (gesture_hmm_ == nullptr) {
		warnings.push_back("Set \"gesture_hmm\" to the GestureHMM whose motion is to be felt.");
	}
	if (bus_ == StringName() && wav_path_.is_empty()) {
		warnings.push_back(
				"Set \"bus\" to an audio bus that leads to the actuator, or \"wav_path\" to a file; "
				"otherwise the vibration goes nowhere.");
	} else if (bus_ != StringName() && AudioServer::get_singleton()->get_bus_index(bus_) < 0) {
		warnings.push_back(String("Add an audio bus named '") + String(bus_) +
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
		p_property.hint_string = std::move(names);
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
