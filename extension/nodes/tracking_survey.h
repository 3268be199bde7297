#pragma once

#include "tracking/tracking_survey.h"

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/vector3.hpp>

namespace godot {

/// The core's TrackingSurvey for scripts.
class TrackingSurvey : public RefCounted {
	GDCLASS(TrackingSurvey, RefCounted)

	steadyhand::TrackingSurvey survey_;

protected:
	static void _bind_methods();

public:
	/// Returns ERR_INVALID_PARAMETER without a message if a number is not finite, or the time is before the
	/// last frame.
	Error push(double p_time_s, const Vector3 &p_position);
	double get_duration() const { return survey_.duration_s(); }
	Dictionary propose() const;
};

} // namespace godot
