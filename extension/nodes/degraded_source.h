#pragma once

#include "hand_source.h"

#include "simulation/degraded_hand.h"

#include <algorithm>
#include <cstddef>

namespace godot {

/// A string literal as an argument of a template.
template <std::size_t SIZE> struct PropertyName {
	char text[SIZE] = {};

	consteval PropertyName(const char (&p_text)[SIZE]) { std::copy_n(p_text, SIZE, text); }
};

/// Degrades another source: adds dropouts, freezes, jumps, drift, latency, a lower rate, rounding, noise.
class DegradedSource : public HandSource {
	GDCLASS(DegradedSource, HandSource)

public:
	enum Preset : int64_t { PRESET_CUSTOM, PRESET_STABLE, PRESET_UNSTABLE };

	void set_source(const Ref<HandSource> &p_source);
	Ref<HandSource> get_source() const { return source_; }
	void set_preset(Preset p_preset);
	Preset get_preset() const { return preset_; }
	void set_seed(int64_t p_seed);
	int64_t get_seed() const { return static_cast<int64_t>(settings_.seed); }
	void set_silent_dropouts(bool p_silent);
	bool get_silent_dropouts() const { return settings_.dropouts_are_silent; }

	/// For the numeric properties.
	template <double steadyhand::DegradeSettings::*FIELD, PropertyName NAME> void set_number(double p_value) {
		set_checked(NAME.text, settings_.*FIELD, p_value);
	}
	template <double steadyhand::DegradeSettings::*FIELD> double get_number() const {
		return settings_.*FIELD;
	}

	const steadyhand::DegradeSettings &core() const { return settings_; }

	std::unique_ptr<HandStream> make_stream(HandTracker &p_tracker) override;
	PackedStringArray get_warnings() const override;
	String no_frame_advice() const override;
	String played_file() const override { return source_.is_valid() ? source_->played_file() : String(); }
	bool is_script() const override { return source_.is_valid() && source_->is_script(); }

protected:
	static void _bind_methods();

private:
	Ref<HandSource> source_;
	Preset preset_ = PRESET_CUSTOM;
	steadyhand::DegradeSettings settings_;

	void set_checked(const char *p_name, double &r_field, double p_value);
	/// Whether this source reads p_source, possibly through other DegradedSources. A cycle would never end.
	bool contains(const HandSource *p_source) const;
};

} // namespace godot

VARIANT_ENUM_CAST(godot::DegradedSource::Preset);
