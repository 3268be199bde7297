#pragma once

#include "recorded_track.h"

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_float64_array.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>

namespace godot {

/// The project's metrics for scripts; static functions only.
class MotionMetrics : public RefCounted {
	GDCLASS(MotionMetrics, RefCounted)

protected:
	static void _bind_methods();

public:
	static Dictionary compare(const PackedFloat64Array &p_reference, const PackedFloat64Array &p_curve,
			double p_rate_hz, double p_t0_s, double p_start_s, double p_end_s);
	static Dictionary summarise(const PackedFloat64Array &p_values);
	/// Empty if the track is null.
	static PackedFloat64Array feature_curve(const Ref<RecordedTrack> &p_track, const String &p_feature,
			const Dictionary &p_trial, double p_t0_s, double p_rate_hz, int p_count);
	/// Empty if nothing is odd, or a track is null.
	static String recording_oddity(const Ref<RecordedTrack> &p_measured,
			const Ref<RecordedTrack> &p_reference, const String &p_feature, const Dictionary &p_trial);
	static Dictionary confusion(const PackedStringArray &p_done, const PackedStringArray &p_recognised);
	static double false_alarms_per_minute(int p_alarms, double p_observed_s);
};

} // namespace godot
