#pragma once

#include "strokes/stroke_finder.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {

/// The end of a gesture whose task is not known: held until the hand has come back from it, or has rested
/// there, which makes it a new start. Ways are in metres along the gesture's. amplitude_m: of the gesture.
class EndHold {
public:
	/// A hand that has rested for so long is at a new start.
	static constexpr double HOLD_S = 1.0;

	/// A gesture has begun: its stroke did at onset_s.
	void begin(double onset_s, double gone_m);
	/// At each frame in which the hand has a place.
	void push(double gone_m);
	/// The gesture is over, by this stroke.
	void end(double t_s, const Stroke &stroke);
	/// Since the end: a hand that is still, or again, on its way.
	void follow(double t_s, const Stroke &stroke);

	[[nodiscard]] bool has_returned() const;
	[[nodiscard]] bool is_at_new_start(double t_s, const StrokeFinder &strokes, double amplitude_m) const;
	/// From when on what the hand sets out on may be a gesture of its own, though the end is held on, as it
	/// may have been settling.
	[[nodiscard]] double may_set_out_s() const { return std::min(may_set_out_s_, moved_s_ + HOLD_S); }
	/// Before this stroke, one of the finder's, and strayed no further than that.
	[[nodiscard]] bool has_rested(const Stroke &stroke, const StrokeFinder &strokes, double stray_m) const;

private:
	double onset_s_ = 0.0;
	double ended_s_ = 0.0;
	double stood_s_ = 0.0;            ///< when the hand came to stand, or will
	double moved_s_ = 0.0;            ///< when it was last on its way, or when it will stand
	double may_set_out_s_ = INFINITY; ///< of what it has set out on since
	double gone_m_ = 0.0;
	double furthest_m_ = 0.0; ///< since the beginning
};

} // namespace steadyhand
