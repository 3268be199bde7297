#include "recognition/task_session.h"

#include "base/parameters.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

using namespace parameters;
using namespace parameters::strokes;
using namespace parameters::sessions;

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
		path_distance_m_ = feature().path_distance_m(frame, task());
	}
	const double about = is_straight() ? OFF_STRAIGHT : OFF_CIRCLE;
	hand_.push(frame.t_s, path_distance_m_ < about * task().amplitude_m);
	update_nearness(frame.t_s);
	strokes_.update(strokes);
	const double x = *x_m / task().amplitude_m;
	if (stage() == Stage::IDLE && std::abs(x) < RETURNED) {
		wander_.push(frame.t_s, x);
	}
	if (stage() != Stage::IDLE) {
		strokes_.add(strokes);
		judge(strokes);
	}
	return x_m;
}

/// In `paper` mode the task alone says which gesture it is.
void TaskSession::judge(const StrokeFinder &strokes) {
	set_log_odds(mode() == MotionMode::PAPER ? LOG_PRIOR_TASK : strokes_.judge(strokes));
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
	return is_straight() ? mode() == MotionMode::PHASE && hand_.off_path_s() > LONG_DROPOUT_S
						 : hand_.off_path_s() > DETECTION_S;
}

double TaskSession::start_distance_m() const {
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
			} else if (!is_rejected_ && (is_straight() || hand_.off_path_s() <= 0.0) && has_started(t_s)) {
				strokes_.begin();
				judge(strokes);
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
		return value() > START_VALUE && observation().y() > START_SPEED;
	}
	if (!strokes_.has_onset()) {
		return false;
	}
	const MotionEstimate now = estimate(t_s);
	// A value this small so late belongs to a movement elsewhere.
	if (now.value <= START_VALUE || (now.value < RETURNED && now.phase > HALFWAY)) {
		return false;
	}
	const double onset = std::clamp(START_DRIFTS * wander_.deviation(t_s), START_VALUE, RETURNED);
	return now.value > (now.gesture > START_PROBABILITY && strokes_.is_along_axis() ? onset : HALFWAY);
}

/// The estimator took a movement elsewhere for a whole gesture, and the hand is back.
bool TaskSession::has_been_elsewhere(double t_s) const {
	if (mode() == MotionMode::PAPER) {
		return false;
	}
	// Before it is blended: the output still follows the last frame.
	const MotionEstimate now = unblended(t_s);
	return now.phase > END_PHASE && std::abs(now.value) < RETURNED;
}

bool TaskSession::has_aborted(double t_s) {
	if (mode() == MotionMode::PAPER) {
		return value() < RETURNED &&
				t_s - stage_began_s() > ABORT_AFTER * model().elements.front().duration_mean_s;
	}
	const MotionEstimate now = estimate(t_s);
	likely_s_ = now.gesture > START_PROBABILITY ? t_s : likely_s_;
	beyond_s_ = now.value < RETURNED ? beyond_s_ : t_s;
	const bool may_begin =
			furthest_ < RETURNED && now.gesture > ABORT_PROBABILITY && t_s - likely_s_ < DETECTION_S;
	const bool is_under_way = (now.gesture > START_PROBABILITY || may_begin) && now.phase < END_PHASE;
	const bool has_returned = furthest_ - now.value > TURNED_BACK;
	return now.value < RETURNED && (has_returned || !is_under_way);
}

/// The estimate may end the gesture: not long into a dropout unless the end was near, and not while the hand
/// is tracked in the first half.
bool TaskSession::is_known(double t_s, const StrokeFinder &strokes) const {
	const double unseen_s =
			t_s - (feature().place != nullptr ? strokes.last_measurement_s() : hand_.last_s());
	const bool may_be_there = value() > HALFWAY || unseen_s > MISSING_S;
	const bool is_followed = unseen_s < ABSENCES_S.front() && !hand_.is_just_found(t_s);
	return mode() == MotionMode::PAPER || value() > NEAR_END || (is_followed && may_be_there);
}

bool TaskSession::has_returned(double t_s) const {
	const double shown = mode() == MotionMode::PAPER ? value() : estimate(t_s).value;
	return shown < RETURNED || (element_.is_periodic() && shown > 1.0 + RETURNED);
}

void TaskSession::follow_stop(double t_s) {
	const MotionEstimate now = estimate(t_s);
	const bool is_seen = hand_.is_recent(t_s);
	moved_s_ = is_seen && now.hold > STOP_PROBABILITY ? moved_s_ : t_s;
	furthest_ = is_seen && !hand_.is_just_found(t_s) ? std::max(furthest_, now.value) : furthest_;
}

/// At `completion` or beyond, or turned back from there.
bool TaskSession::has_stopped(double t_s) const {
	if (mode() == MotionMode::PAPER) {
		return false; // plays to the end
	}
	const double value = estimate(t_s).value;
	const bool has_turned = furthest_ > completion_ && value < furthest_ - TURNED_BACK;
	const bool has_stopped = value > completion_ && t_s - moved_s_ > STOP_S;
	return strokes_.best_log_odds() > STOP_LOG_ODDS && (has_turned || has_stopped);
}

void TaskSession::try_end(double t_s) {
	const bool is_paper = mode() == MotionMode::PAPER;
	const bool counts = is_paper || strokes_.best_log_odds() >= 0.0;
	if (counts && (is_paper || hand_.off_path_s() <= 0.0)) {
		arrive(t_s);
	} else if (!counts && t_s - at_end_since_s_ > DETECTION_S) {
		is_rejected_ = true;
		go_idle(t_s);
	}
}

void TaskSession::go_idle(double t_s) {
	const bool had_left = stage() == Stage::ENDED || furthest_ > LEFT_START;
	rest(t_s);
	if (had_left) {
		strokes_.ignore_before(beyond_s_ - DETECTION_S);
	}
	if (!is_rejected_ && has_returned(t_s)) { // not if it is elsewhere
		const double amplitude_m = task().amplitude_m;
		restart_estimate(
				t_s, -element_.whole_rounds_m(amplitude_m * estimate(t_s).value, task()) / amplitude_m);
	}
}

bool TaskSession::is_near_end() const {
	return stage() != Stage::IDLE && value() > NEAR_END;
}

/// A dropout, not a freeze: a tracker that repeats itself may show a hand at rest.
void TaskSession::lose(double t_s) {
	set_log_odds(LOG_PRIOR_NO_TASK);
	start_distance_m_ = path_distance_m_ = INFINITY;
	reset_hand(t_s);
}

void TaskSession::abort(double t_s) {
	if (stage() != Stage::IDLE) {
		set_log_odds(LOG_PRIOR_NO_TASK);
		is_rejected_ = true; // until the hand has returned
		go_idle(t_s);
	}
}

} // namespace steadyhand
