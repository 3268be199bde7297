#include "haptic_effect.h"

#include "conversions.h"
#include "node_label.h"
#include "text_file.h"

#include "haptics/effect_preview.h"
#include "haptics/wav.h"

#include <godot_cpp/core/class_db.hpp>

#include <algorithm>
#include <cmath>

namespace godot {

namespace {

/// Sample rate, high enough for the frequencies that hands feel.
constexpr double SPECTRUM_RATE_HZ = 8000.0;

/// Number of samples of a Curve.
constexpr int CURVE_POINTS = 257;

} // namespace

PackedFloat32Array HapticEffect::packed(const std::vector<float> &p_values) {
	PackedFloat32Array array;
	array.resize(static_cast<int64_t>(p_values.size()));
	std::copy(p_values.begin(), p_values.end(), array.ptrw());
	return array;
}

steadyhand::Table HapticEffect::keep(Tables &r_tables, std::vector<float> p_values) {
	r_tables.push_back(std::make_shared<const std::vector<float>>(std::move(p_values)));
	const std::vector<float> &kept = *r_tables.back();
	return { kept.data(), static_cast<std::uint32_t>(kept.size()) };
}

void HapticEffect::set_positive(double &r_member, double p_value, const char *p_name) {
	ERR_FAIL_COND_MSG(!(p_value > 0.0) || !std::isfinite(p_value),
			refusal(get_class(), String(p_name) + String(" must be above 0"), p_value));
	r_member = p_value;
	emit_changed();
}

void HapticEffect::set_not_negative(double &r_member, double p_value, const char *p_name) {
	ERR_FAIL_COND_MSG(!(p_value >= 0.0) || !std::isfinite(p_value),
			refusal(get_class(), String(p_name) + String(" must be 0 or more"), p_value));
	r_member = p_value;
	emit_changed();
}

void HapticEffect::set_within(
		double &r_member, double p_value, const char *p_name, double p_least, double p_most) {
	ERR_FAIL_COND_MSG(!(p_value >= p_least) || !(p_value <= p_most),
			refusal(get_class(),
					String(p_name) + String(" must be ") + String::num(p_least) + String("..") +
							String::num(p_most),
					p_value));
	r_member = p_value;
	emit_changed();
}

void HapticEffect::set_frequency(double p_frequency_hz) {
	set_positive(effect_.frequency_hz, p_frequency_hz, "frequency");
}

void HapticEffect::set_gain(double p_gain) {
	ERR_FAIL_COND_MSG(!(p_gain >= 0.0) || p_gain > 1.0, refusal(get_class(), "gain must be 0..1", p_gain));
	effect_.gain = p_gain;
	emit_changed();
}

void HapticEffect::set_channels(int p_channels) {
	ERR_FAIL_COND_MSG(p_channels < 1 || p_channels > 3,
			refusal(get_class(), "channels must be 1 (left), 2 (right) or 3 (both)", p_channels));
	effect_.channels = static_cast<std::uint8_t>(p_channels);
	emit_changed();
}

void HapticEffect::set_drive(Drive p_drive) {
	ERR_FAIL_COND_MSG(!is_enumerator(p_drive, DRIVE_ACCELERATION),
			refusal(get_class(), "drive must be one of DRIVE_*", p_drive));
	effect_.drive = static_cast<steadyhand::Drive>(p_drive);
	emit_changed();
}

void HapticEffect::set_trigger(Trigger p_trigger) {
	ERR_FAIL_COND_MSG(!is_enumerator(p_trigger, TRIGGER_START),
			refusal(get_class(), "trigger must be one of TRIGGER_*", p_trigger));
	effect_.trigger = static_cast<steadyhand::Trigger>(p_trigger);
	emit_changed();
}

PackedFloat32Array HapticEffect::get_preview(int p_sample_rate_hz) const {
	ERR_FAIL_COND_V_MSG(!is_sample_rate(p_sample_rate_hz), PackedFloat32Array(),
			sample_rate_fault(get_class(), "the sample rate", p_sample_rate_hz));
	Tables tables;
	return packed(steadyhand::preview_of(to_core(tables), p_sample_rate_hz));
}

PackedFloat32Array HapticEffect::get_preview_spectrum(const PackedFloat32Array &p_frequencies_hz) const {
	Tables tables;
	const std::vector<float> samples = steadyhand::preview_of(to_core(tables), SPECTRUM_RATE_HZ);
	return packed(steadyhand::spectrum_of(samples, SPECTRUM_RATE_HZ,
			std::span(p_frequencies_hz.ptr(), static_cast<std::size_t>(p_frequencies_hz.size()))));
}

Error HapticEffect::save_preview_wav(const String &p_path, int p_sample_rate_hz) const {
	ERR_FAIL_COND_V_MSG(!is_sample_rate(p_sample_rate_hz), ERR_INVALID_PARAMETER,
			sample_rate_fault(get_class(), "the sample rate", p_sample_rate_hz));
	Tables tables;
	const std::vector<float> samples = steadyhand::preview_of(to_core(tables), p_sample_rate_hz);
	const auto header = steadyhand::wav_header(
			{ .sample_rate_hz = static_cast<std::uint32_t>(p_sample_rate_hz) }, samples.size());
	std::string bytes(header.size() + steadyhand::WAV_SAMPLE_BYTES * samples.size(), '\0');
	const std::span<std::byte> out = std::as_writable_bytes(std::span(bytes));
	std::copy(header.begin(), header.end(), out.begin());
	steadyhand::wav_encode(samples, out.subspan(header.size()));
	return write_text_file(p_path, bytes);
}

void SpringEffect::set_drive(Drive p_drive) {
	HapticEffect::set_drive(p_drive);
}

void SpringEffect::set_trigger(Trigger p_trigger) {
	ERR_FAIL_COND_MSG(p_trigger == TRIGGER_ARRIVAL || p_trigger == TRIGGER_START,
			refusal("SpringEffect", "trigger must be TRIGGER_ALWAYS or TRIGGER_MOVING", p_trigger));
	HapticEffect::set_trigger(p_trigger);
}

steadyhand::Effect InertialViscousEffect::to_core(Tables &) const {
	steadyhand::Effect effect = effect_;
	effect.viscous = viscosity_s_m_ * speed_m_s_;
	return effect;
}

CustomEffect::CustomEffect() {
	effect_.shape = steadyhand::Shape::CURVE;
}

void CustomEffect::set_curve(const Ref<Curve> &p_curve) {
	const Callable callable = callable_mp(this, &CustomEffect::on_curve_changed);
	if (curve_.is_valid()) {
		curve_->disconnect("changed", callable);
	}
	curve_ = p_curve;
	if (curve_.is_valid()) {
		curve_->connect("changed", callable);
	}
	emit_changed();
}

void CustomEffect::set_waveform(const PackedFloat32Array &p_waveform) {
	waveform_ = p_waveform;
	emit_changed();
}

steadyhand::Effect CustomEffect::to_core(Tables &r_tables) const {
	steadyhand::Effect effect = effect_;
	const bool plays_samples = effect.is_cue() && waveform_.size() > 1;
	if (plays_samples) {
		effect.shape = steadyhand::Shape::SAMPLES;
		std::vector<float> values(waveform_.ptr(), waveform_.ptr() + waveform_.size());
		for (float &value : values) {
			value = std::isfinite(value) ? std::clamp(value, -1.0F, 1.0F) : 0.0F;
		}
		effect.table = keep(r_tables, std::move(values));
	} else if (curve_.is_valid()) {
		std::vector<float> values(CURVE_POINTS);
		for (int i = 0; i < CURVE_POINTS; ++i) {
			const float value = curve_->sample_baked(static_cast<float>(i) / (CURVE_POINTS - 1));
			values[static_cast<std::size_t>(i)] = std::isfinite(value) ? std::clamp(value, 0.0F, 1.0F) : 0.0F;
		}
		effect.table = keep(r_tables, std::move(values));
	} else {
		effect.shape = steadyhand::Shape::SINE;
	}
	return effect;
}

void HapticEffect::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_frequency", "frequency"), &HapticEffect::set_frequency);
	ClassDB::bind_method(D_METHOD("get_frequency"), &HapticEffect::get_frequency);
	ClassDB::bind_method(D_METHOD("set_gain", "gain"), &HapticEffect::set_gain);
	ClassDB::bind_method(D_METHOD("get_gain"), &HapticEffect::get_gain);
	ClassDB::bind_method(D_METHOD("set_channels", "channels"), &HapticEffect::set_channels);
	ClassDB::bind_method(D_METHOD("get_channels"), &HapticEffect::get_channels);
	ClassDB::bind_method(D_METHOD("get_preview", "sample_rate"), &HapticEffect::get_preview);
	ClassDB::bind_method(
			D_METHOD("save_preview_wav", "path", "sample_rate"), &HapticEffect::save_preview_wav);
	ClassDB::bind_method(
			D_METHOD("get_preview_spectrum", "frequencies"), &HapticEffect::get_preview_spectrum);

	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "frequency", PROPERTY_HINT_RANGE, "1,1000,1,or_greater,suffix:Hz"),
			"set_frequency", "get_frequency");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "gain", PROPERTY_HINT_RANGE, "0,1,0.01"), "set_gain", "get_gain");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "channels", PROPERTY_HINT_FLAGS, "Left,Right"), "set_channels",
			"get_channels");

	BIND_ENUM_CONSTANT(DRIVE_CONSTANT);
	BIND_ENUM_CONSTANT(DRIVE_POSITION);
	BIND_ENUM_CONSTANT(DRIVE_VELOCITY);
	BIND_ENUM_CONSTANT(DRIVE_ACCELERATION);
	BIND_ENUM_CONSTANT(TRIGGER_ALWAYS);
	BIND_ENUM_CONSTANT(TRIGGER_MOVING);
	BIND_ENUM_CONSTANT(TRIGGER_ARRIVAL);
	BIND_ENUM_CONSTANT(TRIGGER_START);
}

void SpringEffect::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_drive", "drive"), &SpringEffect::set_drive);
	ClassDB::bind_method(D_METHOD("get_drive"), &SpringEffect::get_drive);
	ClassDB::bind_method(D_METHOD("set_trigger", "trigger"), &SpringEffect::set_trigger);
	ClassDB::bind_method(D_METHOD("get_trigger"), &SpringEffect::get_trigger);
	ClassDB::bind_method(D_METHOD("set_full_scale", "full_scale"), &SpringEffect::set_full_scale);
	ClassDB::bind_method(D_METHOD("get_full_scale"), &SpringEffect::get_full_scale);

	ADD_PROPERTY(PropertyInfo(Variant::INT, "drive", PROPERTY_HINT_ENUM,
						 "Constant,Position,Velocity,Acceleration"),
			"set_drive", "get_drive");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "full_scale", PROPERTY_HINT_RANGE, "0.01,20,0.01,or_greater"),
			"set_full_scale", "get_full_scale");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "trigger", PROPERTY_HINT_ENUM, "Always,While Moving"),
			"set_trigger", "get_trigger");
}

void ImpulseEffect::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_decay", "decay"), &ImpulseEffect::set_decay);
	ClassDB::bind_method(D_METHOD("get_decay"), &ImpulseEffect::get_decay);
	ClassDB::bind_method(D_METHOD("set_full_speed", "full_speed"), &ImpulseEffect::set_full_speed);
	ClassDB::bind_method(D_METHOD("get_full_speed"), &ImpulseEffect::get_full_speed);

	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "decay", PROPERTY_HINT_RANGE, "1,1000,1,or_greater,suffix:1/s"),
			"set_decay", "get_decay");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "full_speed", PROPERTY_HINT_RANGE,
						 "0.01,5,0.01,or_greater,suffix:m/s"),
			"set_full_speed", "get_full_speed");
}

void InertialViscousEffect::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_duration", "duration"), &InertialViscousEffect::set_duration);
	ClassDB::bind_method(D_METHOD("get_duration"), &InertialViscousEffect::get_duration);
	ClassDB::bind_method(D_METHOD("set_speed", "speed"), &InertialViscousEffect::set_speed);
	ClassDB::bind_method(D_METHOD("get_speed"), &InertialViscousEffect::get_speed);
	ClassDB::bind_method(D_METHOD("set_viscosity", "viscosity"), &InertialViscousEffect::set_viscosity);
	ClassDB::bind_method(D_METHOD("get_viscosity"), &InertialViscousEffect::get_viscosity);
	ClassDB::bind_method(D_METHOD("set_inertia", "inertia"), &InertialViscousEffect::set_inertia);
	ClassDB::bind_method(D_METHOD("get_inertia"), &InertialViscousEffect::get_inertia);

	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "duration", PROPERTY_HINT_RANGE,
						 "0.01,0.5,0.001,or_greater,suffix:s"),
			"set_duration", "get_duration");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "speed", PROPERTY_HINT_RANGE, "0,2,0.01,or_greater,suffix:m/s"),
			"set_speed", "get_speed");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "viscosity", PROPERTY_HINT_RANGE, "0,5,0.01,or_greater,suffix:s/m"),
			"set_viscosity", "get_viscosity");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "inertia", PROPERTY_HINT_RANGE, "0,2,0.01,or_greater,suffix:s^2/m"),
			"set_inertia", "get_inertia");
}

void CustomEffect::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_drive", "drive"), &CustomEffect::set_drive);
	ClassDB::bind_method(D_METHOD("get_drive"), &CustomEffect::get_drive);
	ClassDB::bind_method(D_METHOD("set_trigger", "trigger"), &CustomEffect::set_trigger);
	ClassDB::bind_method(D_METHOD("get_trigger"), &CustomEffect::get_trigger);
	ClassDB::bind_method(D_METHOD("set_full_scale", "full_scale"), &CustomEffect::set_full_scale);
	ClassDB::bind_method(D_METHOD("get_full_scale"), &CustomEffect::get_full_scale);
	ClassDB::bind_method(D_METHOD("set_duration", "duration"), &CustomEffect::set_duration);
	ClassDB::bind_method(D_METHOD("get_duration"), &CustomEffect::get_duration);
	ClassDB::bind_method(D_METHOD("set_curve", "curve"), &CustomEffect::set_curve);
	ClassDB::bind_method(D_METHOD("get_curve"), &CustomEffect::get_curve);
	ClassDB::bind_method(D_METHOD("set_waveform", "waveform"), &CustomEffect::set_waveform);
	ClassDB::bind_method(D_METHOD("get_waveform"), &CustomEffect::get_waveform);
	ClassDB::bind_method(D_METHOD("set_waveform_rate", "rate"), &CustomEffect::set_waveform_rate);
	ClassDB::bind_method(D_METHOD("get_waveform_rate"), &CustomEffect::get_waveform_rate);

	ADD_PROPERTY(PropertyInfo(Variant::INT, "trigger", PROPERTY_HINT_ENUM,
						 "Always,While Moving,At Arrival,At Start"),
			"set_trigger", "get_trigger");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "drive", PROPERTY_HINT_ENUM,
						 "Constant,Position,Velocity,Acceleration"),
			"set_drive", "get_drive");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "full_scale", PROPERTY_HINT_RANGE, "0.01,20,0.01,or_greater"),
			"set_full_scale", "get_full_scale");
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "curve", PROPERTY_HINT_RESOURCE_TYPE, "Curve"), "set_curve",
			"get_curve");
	ADD_GROUP("Cue", "");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "duration", PROPERTY_HINT_RANGE, "0.01,2,0.001,or_greater,suffix:s"),
			"set_duration", "get_duration");
	ADD_PROPERTY(PropertyInfo(Variant::PACKED_FLOAT32_ARRAY, "waveform"), "set_waveform", "get_waveform");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "waveform_rate", PROPERTY_HINT_RANGE,
						 String("1000,") + itos(HIGHEST_RATE_HZ) + String(",1,suffix:Hz")),
			"set_waveform_rate", "get_waveform_rate");
}

} // namespace godot
