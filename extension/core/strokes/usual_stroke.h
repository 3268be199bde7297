#pragma once

#include "gesture/gesture_model.h"

namespace steadyhand {

/// The stroke of a gesture without a task, according to its model.
struct UsualStroke {
	double amplitude_m = 0.0;
	double duration_s = 0.0; ///< mean
	/// The hand is fast at the end: it passes the end and comes back. Otherwise it stops at the end.
	bool is_strike = false;
};

[[nodiscard]] UsualStroke usual_stroke(const GestureModel &model);

/// Speed of the reference curve at `phase`, as a fraction of its peak speed; 0 without growth.
[[nodiscard]] double speed_share(const GestureModel &model, double phase);

} // namespace steadyhand
