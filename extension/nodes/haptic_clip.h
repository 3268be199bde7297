#pragma once

#include "haptic_effect.h"

#include "base/result.h"
#include "haptics/haptic_clip.h"

#include <godot_cpp/core/property_info.hpp>

#include <memory>
#include <vector>

namespace godot {

/// A designed or recorded vibration as an effect: a `.haptic` or `.ahap` file.
class HapticClip : public HapticEffect {
	GDCLASS(HapticClip, HapticEffect)

	steadyhand::HapticClip clip_;
	/// Tables of clip_ that to_core() has rendered; empty after a change.
	mutable Tables rendered_;

	void set_range_end(double &r_end_hz, double p_hz, const char *p_name);

public:
	HapticClip() { set_clip({}); }

	void set_drive(Drive p_drive) { HapticEffect::set_drive(p_drive); }
	Drive get_drive() const { return HapticEffect::get_drive(); }
	void set_trigger(Trigger p_trigger) {
		rendered_.clear();
		HapticEffect::set_trigger(p_trigger);
	}
	Trigger get_trigger() const { return HapticEffect::get_trigger(); }
	void set_full_scale(double p_full_scale) { set_positive(effect_.full_scale, p_full_scale, "full_scale"); }
	double get_full_scale() const { return effect_.full_scale; }
	void set_lowest_frequency(double p_hz) {
		set_range_end(clip_.playback.range.lowest_hz, p_hz, "lowest_frequency");
	}
	double get_lowest_frequency() const { return clip_.playback.range.lowest_hz; }
	void set_highest_frequency(double p_hz) {
		set_range_end(clip_.playback.range.highest_hz, p_hz, "highest_frequency");
	}
	double get_highest_frequency() const { return clip_.playback.range.highest_hz; }

	/// The content of a `.haptic` file; empty for an empty clip.
	String to_text() const;
	/// For the property that scenes and duplicates store: an empty text clears the clip.
	void set_text(const String &p_text);
	Error parse_text(const String &p_text);

	double get_duration() const { return clip_.duration_s(); }
	int get_transient_count() const { return static_cast<int>(clip_.transients.size()); }
	double get_amplitude_at(double p_time) const { return clip_.amplitude_at(p_time); }
	double get_frequency_at(double p_time) const;
	PackedFloat32Array get_waveform(int p_sample_rate_hz) const;

	/// Null, and one error in the log, if the file is no clip.
	static Ref<HapticClip> load_file(const String &p_path);
	static Ref<HapticClip> from_wav(const String &p_path);
	static Ref<HapticClip> from_waveform(const PackedFloat32Array &p_samples, int p_sample_rate_hz);

	steadyhand::Effect to_core(Tables &r_tables) const override;

protected:
	static void _bind_methods();
	void _validate_property(PropertyInfo &p_property) const;

private:
	static Ref<HapticClip> made(const steadyhand::Result<steadyhand::HapticClip> &p_clip);
	void set_clip(steadyhand::HapticClip p_clip);
	/// clip_ with its playback settings.
	steadyhand::HapticClip core() const;
};

} // namespace godot
