#pragma once

#include "sample_rates.h"

#include "haptics/effect.h"

#include <godot_cpp/classes/curve.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>

#include <memory>
#include <vector>

namespace godot {

/// The core's Effect as a resource: the vibration of a gesture.
class HapticEffect : public Resource {
	GDCLASS(HapticEffect, Resource)

public:
	/// In the order of the core's Drive.
	enum Drive : int64_t { DRIVE_CONSTANT, DRIVE_POSITION, DRIVE_VELOCITY, DRIVE_ACCELERATION };
	/// In the order of the core's Trigger.
	enum Trigger : int64_t { TRIGGER_ALWAYS, TRIGGER_MOVING, TRIGGER_ARRIVAL, TRIGGER_START };
	/// Tables that the core reads and the caller owns.
	using Tables = std::vector<std::shared_ptr<const std::vector<float>>>;

	void set_frequency(double p_frequency_hz);
	double get_frequency() const { return effect_.frequency_hz; }
	void set_gain(double p_gain);
	double get_gain() const { return effect_.gain; }
	void set_channels(int p_channels);
	int get_channels() const { return effect_.channels; }

	PackedFloat32Array get_preview(int p_sample_rate_hz) const;
	PackedFloat32Array get_preview_spectrum(const PackedFloat32Array &p_frequencies_hz) const;
	Error save_preview_wav(const String &p_path, int p_sample_rate_hz) const;

	/// Adds the tables that the effect reads to r_tables.
	virtual steadyhand::Effect to_core(Tables &) const { return effect_; }

protected:
	static void _bind_methods();

	steadyhand::Effect effect_;

	explicit HapticEffect(const steadyhand::Effect &p_effect) : effect_(p_effect) {}
	HapticEffect() = default;

	static PackedFloat32Array packed(const std::vector<float> &p_values);

	void set_drive(Drive p_drive);
	Drive get_drive() const { return static_cast<Drive>(effect_.drive); }
	void set_trigger(Trigger p_trigger);
	Trigger get_trigger() const { return static_cast<Trigger>(effect_.trigger); }
	/// Refuses numbers that are not finite or not above 0.
	void set_positive(double &r_member, double p_value, const char *p_name);
	void set_not_negative(double &r_member, double p_value, const char *p_name);
	void set_within(double &r_member, double p_value, const char *p_name, double p_least, double p_most);
	/// Adds the table to r_tables.
	static steadyhand::Table keep(Tables &r_tables, std::vector<float> p_values);
	/// For effects at an arrival, which have an end.
	void set_duration(double p_duration) {
		set_within(effect_.duration_s, p_duration, "duration", 0.001, 10.0);
	}
};

/// M sin(2 pi f t), with M by the motion: a stretched spring.
class SpringEffect : public HapticEffect {
	GDCLASS(SpringEffect, HapticEffect)

public:
	SpringEffect() : HapticEffect(steadyhand::spring_effect()) {}

	void set_drive(Drive p_drive);
	Drive get_drive() const { return HapticEffect::get_drive(); }
	void set_trigger(Trigger p_trigger);
	Trigger get_trigger() const { return HapticEffect::get_trigger(); }
	void set_full_scale(double p_full_scale) { set_positive(effect_.full_scale, p_full_scale, "full_scale"); }
	double get_full_scale() const { return effect_.full_scale; }

protected:
	static void _bind_methods();
};

/// M exp(-N t) sin(2 pi f t) from an arrival, with M by the speed there: a hard surface.
class ImpulseEffect : public HapticEffect {
	GDCLASS(ImpulseEffect, HapticEffect)

public:
	ImpulseEffect() : HapticEffect(steadyhand::impulse_effect()) {}

	void set_decay(double p_decay) { set_within(effect_.decay_per_s, p_decay, "decay", 1.0, 10000.0); }
	double get_decay() const { return effect_.decay_per_s; }
	void set_full_speed(double p_speed) { set_positive(effect_.full_scale, p_speed, "full_speed"); }
	double get_full_speed() const { return effect_.full_scale; }

protected:
	static void _bind_methods();
};

/// A short sine from an arrival. Its amplitude depends on a constant speed and the actual acceleration: a
/// mass that moves in a viscous medium.
class InertialViscousEffect : public HapticEffect {
	GDCLASS(InertialViscousEffect, HapticEffect)

	double speed_m_s_ = 0.5;
	double viscosity_s_m_ = 1.0;

public:
	InertialViscousEffect() : HapticEffect(steadyhand::inertial_viscous_effect()) {}

	void set_duration(double p_duration) { HapticEffect::set_duration(p_duration); }
	double get_duration() const { return effect_.duration_s; }
	void set_speed(double p_speed) { set_not_negative(speed_m_s_, p_speed, "speed"); }
	double get_speed() const { return speed_m_s_; }
	void set_viscosity(double p_viscosity) { set_not_negative(viscosity_s_m_, p_viscosity, "viscosity"); }
	double get_viscosity() const { return viscosity_s_m_; }
	void set_inertia(double p_inertia) { set_not_negative(effect_.inertia_s2_m, p_inertia, "inertia"); }
	double get_inertia() const { return effect_.inertia_s2_m; }

	steadyhand::Effect to_core(Tables &r_tables) const override;

protected:
	static void _bind_methods();
};

/// A carrier with the user's own amplitude curve, or a short recorded waveform.
class CustomEffect : public HapticEffect {
	GDCLASS(CustomEffect, HapticEffect)

	Ref<Curve> curve_;
	PackedFloat32Array waveform_;

public:
	CustomEffect();

	void set_drive(Drive p_drive) { HapticEffect::set_drive(p_drive); }
	Drive get_drive() const { return HapticEffect::get_drive(); }
	void set_trigger(Trigger p_trigger) { HapticEffect::set_trigger(p_trigger); }
	Trigger get_trigger() const { return HapticEffect::get_trigger(); }
	void set_full_scale(double p_full_scale) { set_positive(effect_.full_scale, p_full_scale, "full_scale"); }
	double get_full_scale() const { return effect_.full_scale; }
	void set_duration(double p_duration) { HapticEffect::set_duration(p_duration); }
	double get_duration() const { return effect_.duration_s; }
	void set_curve(const Ref<Curve> &p_curve);
	Ref<Curve> get_curve() const { return curve_; }
	void set_waveform(const PackedFloat32Array &p_waveform);
	PackedFloat32Array get_waveform() const { return waveform_; }
	void set_waveform_rate(double p_rate) {
		set_within(effect_.table_rate_hz, p_rate, "waveform_rate", 1000.0, HIGHEST_RATE_HZ);
	}
	double get_waveform_rate() const { return effect_.table_rate_hz; }

	steadyhand::Effect to_core(Tables &r_tables) const override;

protected:
	static void _bind_methods();

private:
	void on_curve_changed() { emit_changed(); }
};

} // namespace godot

VARIANT_ENUM_CAST(godot::HapticEffect::Drive);
VARIANT_ENUM_CAST(godot::HapticEffect::Trigger);
