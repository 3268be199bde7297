#include "recognition/task_session.h"

#include "strokes/stroke_evidence.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

// Values are in amplitudes, velocities in amplitudes / mean duration: a minimum jerk peaks at 1.875.

/// Of a start; in `paper` mode both. With drift at rest the value must exceed so many deviations of it.
constexpr double ONSET_VALUE = 0.03, ONSET_VELOCITY = 0.1, ONSET_DRIFTS = 7.0;
/// P(gesture) above which it starts, and below which it is aborted; between them after UNLIKELY_S.
constexpr double BEGUN = 0.7, NOT_BEGUN = 0.1, UNLIKELY_S = 0.3;
constexpr double HALFWAY = 0.5;     ///< from here on a gesture has started at any probability
constexpr double LEFT_START = 0.25; ///< from here on the hand has left the start
/// Below this the hand has returned. On a circle the next round starts so far beyond the end.
constexpr double RETURN_VALUE = 0.15;
/// An onset so long before the return belongs to the gesture before.
constexpr double TURNS_S = 0.3;
/// `paper` mode: a gesture at its start after so many mean durations of the first state is aborted.
constexpr double ABORT_AFTER = 3.0;
/// Time at the end in which a stroke may still become the gesture.
constexpr double DOUBT_S = 0.3;
/// The hand has stopped if P(hold) exceeds the first for so long, and turned back if it is back so far.
constexpr double STOPPED = 0.7, STOPPED_S = 0.2, TURNED_BACK = 0.08;
/// log odds of the strokes for an end before the target: hands that do something else stop anywhere.
constexpr double BEYOND_DOUBT = 9.0;
/// P(hold) at the start above which the gesture is aborted.
constexpr double RESTS = 0.95;
/// With drift at rest the hand has turned back only by so many deviations of it.
constexpr double RETURN_DRIFTS = 4.0;
constexpr double NEAR_END = 0.75;
/// No gesture starts so far off its start (TaskStrokes allows 0.62 at most). A hand that stays there for so
/// long is not followed.
constexpr double ELSEWHERE = 0.7, ELSEWHERE_S = 3.0;
/// The same off a circle, for which there are no strokes.
constexpr double OFF_CIRCLE = 0.3;
/// A hand so far off a straight task for so long has left it: a game may move the player, a tracker may jump.
constexpr double OFF_STRAIGHT = 1.0, GONE_S = 1.0;
/// Distance from the start of a gesture that may start anywhere.
constexpr double ANYWHERE_M = 0.1;
/// Without a measurement for so long the hand may be elsewhere.
constexpr double MISSING_S = 0.05;

} // namespace

TaskSession::TaskSession(const GestureModel &model, const Task &task, const Synthesis &synthesis) :
		GestureSession(model, task, synthesis, true), element_(feature()), strokes_(feature(), task) {}

std::optional<double> TaskSession::measure(
		const HandFrame &frame, bool /*has_place*/, const StrokeFinder &strokes) {
	if (stage() == Stage::IDLE) {
		element_.restart();
	}
	const std::optional<double> x_m = element_.measure(frame, task());
	if (!x_m || !std::isfinite(*x_m)) {
		return std::nullopt;
	}
	if (!is_straight()) {
		off_way_m_ = feature().off_way_m(frame, task());
	}
	const double about = is_straight() ? OFF_STRAIGHT : OFF_CIRCLE;
	hand_.push(frame.t_s, off_way_m_ < about * task().amplitude_m);
	update_nearness(frame.t_s);
	strokes_.look(strokes);
	const double x = *x_m / task().amplitude_m;
	if (stage() == Stage::IDLE && std::abs(x) < RETURN_VALUE) {
		wander_.push(frame.t_s, x);
	}
	if (stage() != Stage::IDLE) {
		strokes_.add(strokes);
		set_log_odds(strokes_.judge(strokes));
	}
	return x_m;
}

/// The estimator costs most of what a task does, and of many in a scene the hand is near few.
void TaskSession::update_nearness(double t_s) {
	if (is_near() || stage() != Stage::IDLE) {
		follow_hand(t_s);
	}
	set_paused(mode() == MotionMode::PHASE && t_s - followed_s_ > ELSEWHERE_S);
}

bool TaskSession::is_near() const {
	return away_m() < (is_straight() ? ELSEWHERE : OFF_CIRCLE) * task().amplitude_m;
}

bool TaskSession::has_gone_elsewhere() const {
	return is_straight() ? mode() == MotionMode::PHASE && hand_.off_way_s() > GONE_S
						 : hand_.off_way_s() > DOUBT_S;
}

double TaskSession::off_start_m() const {
	const bool is_anywhere = !is_straight() || feature().is_radius;
	return is_anywhere ? std::max(away_m(), ANYWHERE_M) : away_m();
}

void TaskSession::update_stage(double t_s, const StrokeFinder &strokes) {
	if (!is_reset() && t_s - hand_.last_s() > ABSENCES_S.back()) {
		is_rejected_ = false;
		lose(t_s);
	}
	switch (stage()) {
		case Stage::IDLE:
			if (is_paused()) {
				break;
			}
			if (is_rejected_ ? has_returned(t_s) : has_been_elsewhere(t_s)) {
				is_rejected_ = false;
				restart_estimate(t_s);
			} else if (!is_rejected_ && (is_straight() || hand_.off_way_s() <= 0.0) && has_started(t_s)) {
				strokes_.begin();
				set_log_odds(strokes_.judge(strokes));
				at_end_since_s_ = likely_s_ = t_s;
				furthest_ = 0.0;
				moved_s_ = t_s;
				begin(t_s, value());
				decode(t_s);
			}
			break;
		case Stage::ACTIVE:
			follow_stop(t_s);
			if (has_gone_elsewhere()) {
				is_rejected_ = true;
				go_idle(t_s);
			} else if (has_aborted(t_s)) {
				go_idle(t_s);
			} else if ((has_stopped(t_s) || is_still_at_end(t_s)) && is_known(t_s, strokes)) {
				try_end(t_s);
			} else {
				at_end_since_s_ = t_s;
			}
			break;
		case Stage::ENDED:
			if (has_returned(t_s)) {
				go_idle(t_s);
			} else {
				beyond_s_ = t_s;
			}
			break;
	}
}

bool TaskSession::has_started(double t_s) const {
	if (mode() == MotionMode::PAPER) {
		return value() > ONSET_VALUE && observation().y() > ONSET_VELOCITY;
	}
	if (!strokes_.has_set_out()) {
		return false;
	}
	const MotionEstimate now = estimate(t_s);
	// A value this small so late belongs to a movement elsewhere.
	if (now.value <= ONSET_VALUE || (now.value < RETURN_VALUE && now.phase > HALFWAY)) {
		return false;
	}
	const double onset = std::clamp(ONSET_DRIFTS * wander_.deviation(t_s), ONSET_VALUE, RETURN_VALUE);
	return now.value > (now.gesture > BEGUN && strokes_.heads_along() ? onset : HALFWAY);
}

/// The estimator took a movement elsewhere for a whole gesture, and the hand is back.
bool TaskSession::has_been_elsewhere(double t_s) const {
	if (mode() == MotionMode::PAPER) {
		return false;
	}
	// Before it is blended: the output still follows the last frame.
	const MotionEstimate now = expected(t_s);
	return now.phase > ENDED_PHASE && std::abs(now.value) < RETURN_VALUE;
}

bool TaskSession::has_aborted(double t_s) {
	if (mode() == MotionMode::PAPER) {
		return value() < RETURN_VALUE &&
				t_s - stage_began_s() > ABORT_AFTER * model().elements.front().duration_mean_s;
	}
	const MotionEstimate now = estimate(t_s);
	likely_s_ = now.gesture > BEGUN ? t_s : likely_s_;
	beyond_s_ = now.value < RETURN_VALUE ? beyond_s_ : t_s;
	const bool may_begin =
			furthest_ < RETURN_VALUE && now.gesture > NOT_BEGUN && t_s - likely_s_ < UNLIKELY_S;
	const bool is_under_way = (now.gesture > BEGUN || may_begin) && now.phase < ENDED_PHASE;
	const double wander = std::max(TURNED_BACK, RETURN_DRIFTS * wander_.deviation(t_s));
	const bool has_returned = furthest_ - now.value > wander || now.hold > RESTS;
	return now.value < RETURN_VALUE && (has_returned || !is_under_way);
}

/// The estimate may end the gesture: not long into a dropout unless the end was near, and not while the hand
/// is tracked in the first half.
bool TaskSession::is_known(double t_s, const StrokeFinder &strokes) const {
	const double unseen_s = t_s - (feature().place != nullptr ? strokes.news_s() : hand_.last_s());
	const bool may_be_there = value() > HALFWAY || unseen_s > MISSING_S;
	const bool is_followed = unseen_s < ABSENCES_S.front() && !hand_.is_just_found(t_s);
	return mode() == MotionMode::PAPER || value() > NEAR_END || (is_followed && may_be_there);
}

bool TaskSession::has_returned(double t_s) const {
	const double shown = mode() == MotionMode::PAPER ? value() : estimate(t_s).value;
	return shown < RETURN_VALUE || (element_.is_periodic() && shown > 1.0 + RETURN_VALUE);
}

void TaskSession::follow_stop(double t_s) {
	const MotionEstimate now = estimate(t_s);
	const bool is_seen = hand_.is_recent(t_s);
	moved_s_ = is_seen && now.hold > STOPPED ? moved_s_ : t_s;
	furthest_ = is_seen && !hand_.is_just_found(t_s) ? std::max(furthest_, now.value) : furthest_;
}

/// At `completion` or beyond, or turned back from there.
bool TaskSession::has_stopped(double t_s) const {
	if (mode() == MotionMode::PAPER) {
		return false; // plays to the end
	}
	const double value = estimate(t_s).value;
	const bool has_turned = furthest_ > completion_ && value < furthest_ - TURNED_BACK;
	const bool has_stopped = value > completion_ && t_s - moved_s_ > STOPPED_S;
	return strokes_.best_log_odds() > BEYOND_DOUBT && (has_turned || has_stopped);
}

void TaskSession::try_end(double t_s) {
	const bool is_paper = mode() == MotionMode::PAPER;
	const bool counts = is_paper || strokes_.best_log_odds() >= 0.0;
	if (counts && (is_paper || hand_.off_way_s() <= 0.0)) {
		arrive(t_s);
	} else if (!counts && t_s - at_end_since_s_ > DOUBT_S) {
		is_rejected_ = true;
		go_idle(t_s);
	}
}

void TaskSession::go_idle(double t_s) {
	const bool had_left = stage() == Stage::ENDED || furthest_ > LEFT_START;
	rest(t_s);
	if (had_left) {
		strokes_.ignore_before(beyond_s_ - TURNS_S);
	}
	if (!is_rejected_ && has_returned(t_s)) { // not if it is elsewhere
		const double amplitude_m = task().amplitude_m;
		restart_estimate(t_s, -element_.rounds_m(amplitude_m * estimate(t_s).value, task()) / amplitude_m);
	}
}

bool TaskSession::is_near_end() const {
	return stage() != Stage::IDLE && value() > NEAR_END;
}

/// A dropout, not a freeze: a tracker that repeats itself may show a hand at rest.
void TaskSession::lose(double t_s) {
	set_log_odds(LOG_PRIOR_OPEN);
	off_start_m_ = off_way_m_ = INFINITY;
	reset_hand(t_s);
}

void TaskSession::abort(double t_s) {
	if (stage() != Stage::IDLE) {
		set_log_odds(LOG_PRIOR_OPEN);
		is_rejected_ = true; // until the hand has returned
		go_idle(t_s);
	}
}

} // namespace steadyhand
