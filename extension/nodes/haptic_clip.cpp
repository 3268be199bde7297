#include "haptic_clip.h"

#include "conversions.h"
#include "sample_rates.h"
#include "text_file.h"

#include "haptics/ahap_file.h"
#include "haptics/haptic_file.h"
#include "haptics/recorded_clip.h"
#include "haptics/wav.h"

#include <godot_cpp/core/class_db.hpp>

#include <cmath>

namespace godot {

namespace {

constexpr double RENDERED_RATE_HZ = 48000.0;
/// Samples of a clip that is driven by the motion, from its start to its end.
constexpr int PLACES = 1025;
constexpr double MOST_HZ = 1000.0;

} // namespace

void HapticClip::set_clip(steadyhand::HapticClip p_clip) {
	clip_ = std::move(p_clip);
	const steadyhand::ClipPlayback &playback = clip_.playback;
	effect_.shape = steadyhand::Shape::SAMPLES;
	effect_.fades = false;
	effect_.table_rate_hz = RENDERED_RATE_HZ;
	effect_.trigger = playback.trigger;
	effect_.drive = playback.drive;
	effect_.gain = playback.gain;
	effect_.full_scale = playback.full_scale;
	effect_.channels = static_cast<std::uint8_t>(playback.channels);
	rendered_.clear();
	emit_changed();
}

steadyhand::HapticClip HapticClip::core() const {
	steadyhand::HapticClip clip = clip_;
	clip.playback = { .trigger = effect_.trigger,
		.drive = effect_.drive,
		.gain = effect_.gain,
		.full_scale = effect_.full_scale,
		.channels = effect_.channels,
		.range = clip_.playback.range };
	return clip;
}

void HapticClip::set_range_end(double &r_end_hz, double p_hz, const char *p_name) {
	rendered_.clear();
	set_within(r_end_hz, p_hz, p_name, 1.0, MOST_HZ);
}

String HapticClip::to_text() const {
	return clip_.duration_s() > 0.0 ? to_godot(steadyhand::format_haptic(core())) : String();
}

void HapticClip::set_text(const String &p_text) {
	if (p_text.is_empty()) {
		set_clip({});
	} else {
		parse_text(p_text);
	}
}

Error HapticClip::parse_text(const String &p_text) {
	steadyhand::Result<steadyhand::HapticClip> parsed =
			steadyhand::parse_haptic(godot::to_core(p_text), "HapticClip.parse_text");
	ERR_FAIL_COND_V_MSG(!parsed, ERR_PARSE_ERROR, to_godot(parsed.error()));
	set_clip(std::move(parsed).value());
	return OK;
}

double HapticClip::get_frequency_at(double p_time) const {
	return clip_.playback.range.hz(clip_.frequency_at(p_time));
}

PackedFloat32Array HapticClip::get_waveform(int p_sample_rate_hz) const {
	ERR_FAIL_COND_V_MSG(!is_sample_rate(p_sample_rate_hz), PackedFloat32Array(),
			sample_rate_fault("HapticClip", "the sample rate", p_sample_rate_hz));
	return packed(steadyhand::waveform_of(clip_, p_sample_rate_hz));
}

Ref<HapticClip> HapticClip::made(const steadyhand::Result<steadyhand::HapticClip> &p_clip) {
	ERR_FAIL_COND_V_MSG(!p_clip, Ref<HapticClip>(), to_godot(p_clip.error()));
	Ref<HapticClip> resource;
	resource.instantiate();
	resource->set_clip(p_clip.value());
	return resource;
}

Ref<HapticClip> HapticClip::load_file(const String &p_path) {
	const steadyhand::Result<std::string> text = read_text_file(p_path);
	ERR_FAIL_COND_V_MSG(!text, Ref<HapticClip>(), to_godot(text.error()));
	const bool is_ahap = p_path.get_extension().to_lower() == "ahap";
	return made(is_ahap ? steadyhand::parse_ahap(text.value(), godot::to_core(p_path))
						: steadyhand::parse_haptic(text.value(), godot::to_core(p_path)));
}

Ref<HapticClip> HapticClip::from_wav(const String &p_path) {
	const steadyhand::Result<std::string> bytes = read_text_file(p_path);
	ERR_FAIL_COND_V_MSG(!bytes, Ref<HapticClip>(), to_godot(bytes.error()));
	const steadyhand::Result<steadyhand::WavSamples> wav =
			steadyhand::parse_wav(std::as_bytes(std::span(bytes.value())), godot::to_core(p_path));
	ERR_FAIL_COND_V_MSG(!wav, Ref<HapticClip>(), to_godot(wav.error()));
	steadyhand::HapticClip clip =
			steadyhand::recorded_clip(wav.value().samples, wav.value().format.sample_rate_hz);
	clip.source = godot::to_core(p_path.get_file());
	return made(clip);
}

Ref<HapticClip> HapticClip::from_waveform(const PackedFloat32Array &p_samples, int p_sample_rate_hz) {
	ERR_FAIL_COND_V_MSG(!is_sample_rate(p_sample_rate_hz), Ref<HapticClip>(),
			sample_rate_fault("HapticClip", "the sample rate", p_sample_rate_hz));
	ERR_FAIL_COND_V_MSG(
			p_samples.is_empty(), Ref<HapticClip>(), "HapticClip: from_waveform needs at least one sample");
	return made(steadyhand::recorded_clip(
			std::span(p_samples.ptr(), static_cast<std::size_t>(p_samples.size())), p_sample_rate_hz));
}

steadyhand::Effect HapticClip::to_core(Tables &r_tables) const {
	steadyhand::Effect effect = effect_;
	effect.frequency_hz = steadyhand::main_frequency_hz(clip_);
	const bool is_driven = !effect.is_cue();
	if (rendered_.empty() && is_driven) {
		std::vector<float> amplitudes(PLACES), frequencies(PLACES);
		for (std::size_t i = 0; i < PLACES; ++i) {
			const double time_s = clip_.duration_s() * static_cast<double>(i) / (PLACES - 1);
			amplitudes[i] = static_cast<float>(clip_.amplitude_at(time_s));
			frequencies[i] = static_cast<float>(get_frequency_at(time_s));
		}
		keep(rendered_, std::move(amplitudes));
		keep(rendered_, std::move(frequencies));
	} else if (rendered_.empty()) {
		keep(rendered_, steadyhand::waveform_of(clip_, RENDERED_RATE_HZ));
	}
	r_tables.insert(r_tables.end(), rendered_.begin(), rendered_.end());
	const auto table = [this](std::size_t i) {
		return steadyhand::Table{ rendered_[i]->data(), static_cast<std::uint32_t>(rendered_[i]->size()) };
	};
	effect.table = table(0);
	if (is_driven) {
		effect.shape = steadyhand::Shape::CURVE;
		effect.frequency_table = table(1);
	}
	return effect;
}

void HapticClip::_validate_property(PropertyInfo &p_property) const {
	if (p_property.name == StringName("frequency")) {
		p_property.usage = PROPERTY_USAGE_NONE; // the clip has its own instead
	}
}

void HapticClip::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_drive", "drive"), &HapticClip::set_drive);
	ClassDB::bind_method(D_METHOD("get_drive"), &HapticClip::get_drive);
	ClassDB::bind_method(D_METHOD("set_trigger", "trigger"), &HapticClip::set_trigger);
	ClassDB::bind_method(D_METHOD("get_trigger"), &HapticClip::get_trigger);
	ClassDB::bind_method(D_METHOD("set_full_scale", "full_scale"), &HapticClip::set_full_scale);
	ClassDB::bind_method(D_METHOD("get_full_scale"), &HapticClip::get_full_scale);
	ClassDB::bind_method(D_METHOD("set_lowest_frequency", "frequency"), &HapticClip::set_lowest_frequency);
	ClassDB::bind_method(D_METHOD("get_lowest_frequency"), &HapticClip::get_lowest_frequency);
	ClassDB::bind_method(D_METHOD("set_highest_frequency", "frequency"), &HapticClip::set_highest_frequency);
	ClassDB::bind_method(D_METHOD("get_highest_frequency"), &HapticClip::get_highest_frequency);
	ClassDB::bind_method(D_METHOD("set_text", "text"), &HapticClip::set_text);
	ClassDB::bind_method(D_METHOD("get_text"), &HapticClip::to_text);
	ClassDB::bind_method(D_METHOD("to_text"), &HapticClip::to_text);
	ClassDB::bind_method(D_METHOD("parse_text", "text"), &HapticClip::parse_text);
	ClassDB::bind_method(D_METHOD("get_duration"), &HapticClip::get_duration);
	ClassDB::bind_method(D_METHOD("get_transient_count"), &HapticClip::get_transient_count);
	ClassDB::bind_method(D_METHOD("get_amplitude_at", "time"), &HapticClip::get_amplitude_at);
	ClassDB::bind_method(D_METHOD("get_frequency_at", "time"), &HapticClip::get_frequency_at);
	ClassDB::bind_method(D_METHOD("get_waveform", "sample_rate"), &HapticClip::get_waveform);
	ClassDB::bind_static_method("HapticClip", D_METHOD("load_file", "path"), &HapticClip::load_file);
	ClassDB::bind_static_method("HapticClip", D_METHOD("from_wav", "path"), &HapticClip::from_wav);
	ClassDB::bind_static_method(
			"HapticClip", D_METHOD("from_waveform", "samples", "sample_rate"), &HapticClip::from_waveform);

	// For duplicate() and clips inside a scene. A clip with its own file is stored as a path.
	ADD_PROPERTY(
			PropertyInfo(Variant::STRING, "text", PROPERTY_HINT_MULTILINE_TEXT, "", PROPERTY_USAGE_STORAGE),
			"set_text", "get_text");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "trigger", PROPERTY_HINT_ENUM,
						 "Always,While Moving,At Arrival,At Start"),
			"set_trigger", "get_trigger");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "drive", PROPERTY_HINT_ENUM,
						 "Constant,Position,Velocity,Acceleration"),
			"set_drive", "get_drive");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "full_scale", PROPERTY_HINT_RANGE, "0.01,20,0.01,or_greater"),
			"set_full_scale", "get_full_scale");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "lowest_frequency", PROPERTY_HINT_RANGE, "1,1000,1,suffix:Hz"),
			"set_lowest_frequency", "get_lowest_frequency");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "highest_frequency", PROPERTY_HINT_RANGE, "1,1000,1,suffix:Hz"),
			"set_highest_frequency", "get_highest_frequency");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "duration", PROPERTY_HINT_NONE, "suffix:s",
						 PROPERTY_USAGE_EDITOR | PROPERTY_USAGE_READ_ONLY),
			"", "get_duration");
}

} // namespace godot
