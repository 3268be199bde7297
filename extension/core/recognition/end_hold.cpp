#include "recognition/end_hold.h"

#include <algorithm>

namespace steadyhand {
namespace {

/// The hand has turned back once it is at this share of the furthest that it went.
constexpr double RETURNED = 0.5;
/// Of a stroke's time, how much later the hand stands: strokes are from a quarter of the peak speed to a
/// quarter, which a minimum jerk has at 0.146 and 0.854 of its time.
constexpr double SLOWS_DOWN = 0.146 / 0.708;
/// A hand that creeps by more than this, amplitudes, has not rested; but a tracker that wanders shows any so,
/// and is not believed for longer than that.
constexpr double CREEPS = 0.03;
constexpr double SETTLES_S = 3.0;

/// When the hand will stand, if it slows down now.
double will_stand_s(double t_s, const Stroke &stroke) {
	return t_s + SLOWS_DOWN * (t_s - stroke.onset_s);
}

} // namespace

void EndHold::begin(double onset_s, double gone_m) {
	onset_s_ = onset_s;
	gone_m_ = furthest_m_ = gone_m;
}

void EndHold::push(double gone_m) {
	gone_m_ = gone_m;
	furthest_m_ = std::max(furthest_m_, gone_m);
}

void EndHold::end(double t_s, const Stroke &stroke) {
	ended_s_ = t_s;
	moved_s_ = stood_s_ = will_stand_s(t_s, stroke);
	may_set_out_s_ = INFINITY;
}

void EndHold::follow(double t_s, const Stroke &stroke) {
	const bool is_gesture = stroke.onset_s < ended_s_;
	if (is_gesture) {
		stood_s_ = will_stand_s(t_s, stroke);
		moved_s_ = std::max(moved_s_, stood_s_);
		return;
	}
	if (t_s - moved_s_ > HOLD_S) {
		may_set_out_s_ = may_set_out_s();
	}
	moved_s_ = std::max(moved_s_, t_s);
}

bool EndHold::has_returned() const {
	return gone_m_ < RETURNED * furthest_m_;
}

bool EndHold::is_at_new_start(double t_s, const StrokeFinder &strokes, double amplitude_m) const {
	if (t_s - moved_s_ <= HOLD_S) {
		return false;
	}
	const bool may_settle = t_s - stood_s_ <= SETTLES_S;
	return !may_settle || strokes.stray_m(t_s - HOLD_S, t_s) <= CREEPS * amplitude_m;
}

bool EndHold::has_rested(const Stroke &stroke, const StrokeFinder &strokes, double stray_m) const {
	// When a slow hand stands is less sure.
	const double rested_s = stood_s_ + HOLD_S + SLOWS_DOWN * (stood_s_ - onset_s_);
	return stroke.onset_s >= rested_s && strokes.stray_m(stroke.onset_s - HOLD_S, stroke.onset_s) <= stray_m;
}

} // namespace steadyhand
