#include "recognition/task_session.h"

#include "base/parameters.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

using namespace parameters;
using namespace parameters::sessions;

} // namespace

TaskSession::TaskSession(const GestureModel &model, const Task &task, const Synthesis &synthesis) :
		GestureSession(model, task, synthesis, true), element_(feature()), evidence_(feature(), task) {}

std::optional<double> TaskSession::measure(const HandFrame &frame, const FeatureTrack &track) {
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
	update_presence(frame.t_s);
	if (track.hand()) {
		evidence_.push(track.measurement(), last_place(), stage() == Stage::IDLE);
	}
	const double x = *x_m / task().amplitude_m;
	if (stage() == Stage::IDLE && std::abs(x) < RETURNED) {
		drift_.push(frame.t_s, x);
	}
	if (stage() != Stage::IDLE) {
		judge();
	}
	return x_m;
}

/// In `paper` mode the evidence has no influence.
void TaskSession::judge() {
	set_log_odds(mode() == MotionMode::PAPER ? LOG_PRIOR_TASK : evidence_.log_odds());
}

/// Notes where the hand is. Pauses the estimator while it is far away: the estimator has the greatest cost,
/// and a scene may have many tasks.
void TaskSession::update_presence(double t_s) {
	found_s_ = is_recent(t_s) ? found_s_ : t_s;
	const double tolerance = is_straight() ? OFF_STRAIGHT : OFF_CIRCLE;
	on_path_s_ = path_distance_m_ < tolerance * task().amplitude_m ? t_s : on_path_s_;
	last_s_ = t_s;
	if (is_near() || stage() != Stage::IDLE) {
		follow_hand(t_s);
	}
	set_paused(mode() == MotionMode::PHASE && t_s - followed_s_ > ELSEWHERE_S);
}

bool TaskSession::is_near() const {
	return distance_m() < (is_straight() ? ELSEWHERE : OFF_CIRCLE) * task().amplitude_m;
}

bool TaskSession::has_left_path() const {
	return is_straight() ? mode() == MotionMode::PHASE && off_path_s() > LONG_DROPOUT_S
						 : off_path_s() > DETECTION_S;
}

double TaskSession::start_distance_m() const {
	const bool is_anywhere = !is_straight() || feature().is_radius;
	return is_anywhere ? std::max(distance_m(), ANYWHERE_M) : distance_m();
}

void TaskSession::update_stage(double t_s, const FeatureTrack &track) {
	if (!is_reset() && t_s - last_s_ > LONG_DROPOUT_S) {
		is_rejected_ = false;
		lose(t_s);
	}
	switch (stage()) {
		case Stage::IDLE:
			if (is_paused()) {
				break;
			}
			if (is_rejected_ ? has_returned(t_s) : is_estimate_wrong(t_s)) {
				is_rejected_ = false;
				restart_estimate(t_s);
			} else if (!is_rejected_ && (is_straight() || off_path_s() <= 0.0) && has_started(t_s)) {
				judge();
				at_end_since_s_ = likely_s_ = t_s;
				max_value_ = 0.0;
				moved_s_ = t_s;
				begin(t_s, value());
				decode(t_s);
			}
			break;
		case Stage::ACTIVE:
			update_stop(t_s);
			if (has_left_path()) {
				is_rejected_ = true;
				go_idle(t_s);
			} else if (has_aborted(t_s)) {
				go_idle(t_s);
			} else if ((has_stopped(t_s) || is_still_at_end(t_s)) && is_end_observed(t_s, track)) {
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
	if (!evidence_.has_onset()) {
		return false;
	}
	const MotionEstimate now = estimate(t_s);
	// A small value at a late phase belongs to another movement.
	if (now.value <= START_VALUE || (now.value < RETURNED && now.phase > HALFWAY)) {
		return false;
	}
	const double onset = std::clamp(START_DRIFTS * drift_.deviation(t_s), START_VALUE, RETURNED);
	return now.value > (now.gesture > START_PROBABILITY && evidence_.is_along_axis() ? onset : HALFWAY);
}

/// The estimator is at the gesture's end, and the hand at the start: it took another movement for the
/// gesture.
bool TaskSession::is_estimate_wrong(double t_s) const {
	if (mode() == MotionMode::PAPER) {
		return false;
	}
	// The blended output still follows the last frame.
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
			max_value_ < RETURNED && now.gesture > ABORT_PROBABILITY && t_s - likely_s_ < DETECTION_S;
	const bool is_likely = (now.gesture > START_PROBABILITY || may_begin) && now.phase < END_PHASE;
	const bool has_returned = max_value_ - now.value > TURNED_BACK;
	return now.value < RETURNED && (has_returned || !is_likely);
}

/// The estimate may end the gesture: the last value is near the end, or the hand is in the second half or not
/// tracked, but not late in a dropout or just after one.
bool TaskSession::is_end_observed(double t_s, const FeatureTrack &track) const {
	const double unseen_s = t_s - (feature().place != nullptr ? track.last_measurement_s() : last_s_);
	const bool may_be_there = value() > HALFWAY || unseen_s > RECENT_S;
	const bool is_followed = unseen_s < SHORT_DROPOUT_S && !is_just_found(t_s);
	return mode() == MotionMode::PAPER || value() > NEAR_END || (is_followed && may_be_there);
}

bool TaskSession::has_returned(double t_s) const {
	const double now = mode() == MotionMode::PAPER ? value() : estimate(t_s).value;
	return now < RETURNED || (element_.is_periodic() && now > 1.0 + RETURNED);
}

void TaskSession::update_stop(double t_s) {
	const MotionEstimate now = estimate(t_s);
	const bool is_seen = is_recent(t_s);
	moved_s_ = is_seen && now.hold > STOP_PROBABILITY ? moved_s_ : t_s;
	max_value_ = is_seen && !is_just_found(t_s) ? std::max(max_value_, now.value) : max_value_;
}

/// The hand has stopped beyond completion_, or has turned back from there.
bool TaskSession::has_stopped(double t_s) const {
	if (mode() == MotionMode::PAPER) {
		return false; // the states play to the end
	}
	const double value = estimate(t_s).value;
	const bool has_turned = max_value_ > completion_ && value < max_value_ - TURNED_BACK;
	const bool has_stopped = value > completion_ && t_s - moved_s_ > STOP_S;
	return log_odds() > STOP_LOG_ODDS && (has_turned || has_stopped);
}

void TaskSession::try_end(double t_s) {
	const bool is_gesture = log_odds() >= 0.0;
	if (is_gesture && (mode() == MotionMode::PAPER || off_path_s() <= 0.0)) {
		enter_ended(t_s);
	} else if (!is_gesture && t_s - at_end_since_s_ > DETECTION_S) {
		is_rejected_ = true;
		go_idle(t_s);
	}
}

void TaskSession::go_idle(double t_s) {
	enter_idle(t_s);
	evidence_.ignore_before(beyond_s_ - DETECTION_S);
	if (!is_rejected_ && has_returned(t_s)) {
		const double amplitude_m = task().amplitude_m;
		restart_estimate(
				t_s, -element_.whole_rounds_m(amplitude_m * estimate(t_s).value, task()) / amplitude_m);
	}
}

bool TaskSession::is_near_end() const {
	return stage() != Stage::IDLE && value() > NEAR_END;
}

/// After a long dropout. A freeze is different: the hand may be at rest.
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
