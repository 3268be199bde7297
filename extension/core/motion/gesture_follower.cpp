#include "motion/gesture_follower.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

// All in normalised units: the part of the amplitude, and 1.875 = peak velocity of a minimum-jerk movement.
constexpr double ONSET_VALUE = 0.03;
constexpr double ONSET_VELOCITY = 0.3;
/// `phase` mode: expected phase and value from which on the gesture is at its end.
constexpr double ARRIVED_PHASE = 0.97;
constexpr double ARRIVED_VALUE = 0.9;
/// Below this the hand has come back to where it started. On a circle, which leads there anyway, it is on its
/// next round from this far beyond its end on.
constexpr double BACK_VALUE = 0.15;
/// A movement that is still at its start after so many times its mean first state was none.
constexpr double ABORT_AFTER = 3.0;
/// Symbols of a longer pause say no more than those of its last seconds; and a clock that leaps must not
/// hang.
constexpr double LONGEST_GAP_S = 10.0;
constexpr double RELEASE_S = 0.1; ///< from the end back to rest, once the hand has returned
constexpr double STILL_VELOCITY = 0.15;
constexpr double STILL_S = 0.15; ///< rest, where the start is not told

} // namespace

GestureFollower::GestureFollower(
		const GestureModel &model, const Task &task, bool start_is_known, MotionMode mode) :
		model_(&model),
		element_(*find_feature(model.feature)), task_(task), start_is_known_(start_is_known), mode_(mode),
		decoder_(model.hmm), likelihood_(model.hmm), paper_(model), phase_(model) {}

bool GestureFollower::push(const HandFrame &frame) {
	if (clock_started_) {
		// A symbol due before this frame must not see it.
		advance(std::nextafter(frame.t_s, -INFINITY));
	} else {
		clock_.start(frame.t_s);
		clock_started_ = true;
		still_since_s_ = frame.t_s;
		if (!start_is_known_) {
			take_for_start(frame);
		}
	}
	if (stage_ == Stage::RESTING) {
		element_.restart();
	}
	const std::optional<double> x_m = element_.measure(frame, task_);
	if (!x_m || !std::isfinite(*x_m)) {
		return false;
	}
	window_.push(frame.t_s, *x_m);
	if (mode_ == MotionMode::PHASE) {
		phase_.push(frame.t_s, *x_m / task_.amplitude_m);
	}
	last_frame_ = frame;
	fresh_ = true;
	return true;
}

void GestureFollower::advance(double t_s) {
	if (clock_started_ && t_s - clock_.next_s() > LONGEST_GAP_S) {
		clock_.start(t_s - LONGEST_GAP_S);
	}
	while (clock_started_ && clock_.due(t_s)) {
		if (mode_ == MotionMode::PHASE) {
			phase_.advance(clock_.next_s());
		}
		step(clock_.next_s());
		clock_.advance();
	}
}

void GestureFollower::step(double t_s) {
	const Observation observation = window_.normalised(task_.amplitude_m, model_->duration_mean_s);
	switch (stage_) {
		case Stage::RESTING:
			wait_at_rest(t_s, observation);
			break;
		case Stage::MOVING:
			decode(t_s, observation);
			if (was_nothing(t_s, observation)) {
				enter(Stage::RESTING, t_s);
			} else if (has_arrived(t_s)) {
				enter(Stage::ARRIVED, t_s);
			}
			break;
		case Stage::ARRIVED:
			if (is_back(t_s, observation)) {
				enter(Stage::RESTING, t_s);
			}
			break;
	}
	fresh_ = false;
}

void GestureFollower::wait_at_rest(double t_s, const Observation &observation) {
	if (has_begun(t_s, observation)) {
		begin(t_s, observation);
		decode(t_s, observation);
		return;
	}
	if (start_is_known_) {
		return;
	}
	if (std::abs(observation.y()) > STILL_VELOCITY) {
		still_since_s_ = t_s;
	} else if (t_s - still_since_s_ > STILL_S) {
		take_for_start(last_frame_);
	}
}

void GestureFollower::begin(double t_s, const Observation &observation) {
	decoder_.reset();
	likelihood_.reset();
	symbols_seen_ = 0;
	state_played_ = 0;
	if (mode_ == MotionMode::PAPER) {
		paper_.begin(t_s, phase_of_value(*model_, std::min(observation.x(), 0.5)));
	}
	enter(Stage::MOVING, t_s);
}

void GestureFollower::decode(double t_s, const Observation &observation) {
	const Symbol symbol = fresh_ ? model_->quantiser.symbol(observation) : UNSEEN;
	decoder_.push(symbol);
	likelihood_.push(symbol);
	++symbols_seen_;
	if (decoder_.state() > state_played_) {
		state_played_ = decoder_.state();
		if (mode_ == MotionMode::PAPER) {
			paper_.enter_state(state_played_, t_s);
		}
	}
}

bool GestureFollower::has_begun(double t_s, const Observation &observation) const {
	if (mode_ == MotionMode::PAPER) {
		return observation.x() > ONSET_VALUE && observation.y() > ONSET_VELOCITY;
	}
	const PhaseEstimate estimate = phase_.at(t_s);
	return estimate.moving > 0.5 && estimate.value > ONSET_VALUE;
}

bool GestureFollower::was_nothing(double t_s, const Observation &observation) const {
	if (mode_ == MotionMode::PAPER) {
		return state_played_ == 0 && observation.x() < BACK_VALUE &&
				t_s - stage_began_s_ > ABORT_AFTER * model_->elements.front().duration_mean_s;
	}
	const PhaseEstimate estimate = phase_.at(t_s);
	return estimate.moving < 0.5 || (estimate.phase > ARRIVED_PHASE && estimate.value < BACK_VALUE);
}

bool GestureFollower::has_arrived(double t_s) const {
	if (mode_ == MotionMode::PAPER) {
		return paper_.phase(t_s) >= 1.0;
	}
	const PhaseEstimate estimate = phase_.at(t_s);
	return estimate.phase > ARRIVED_PHASE && estimate.value > ARRIVED_VALUE;
}

bool GestureFollower::is_back(double t_s, const Observation &observation) const {
	const double value = mode_ == MotionMode::PAPER ? observation.x() : phase_.at(t_s).value;
	return value < BACK_VALUE || (element_.is_periodic() && value > 1.0 + BACK_VALUE);
}

void GestureFollower::enter(Stage stage, double t_s) {
	released_from_m_ = stage == Stage::RESTING ? motion(t_s).value_m : 0.0;
	stage_ = stage;
	stage_began_s_ = t_s;
	if (stage == Stage::RESTING && mode_ == MotionMode::PHASE) {
		if (element_.is_periodic()) {
			phase_ = PhaseEstimator(*model_); // the same place is another value from now on
		} else {
			phase_.restart();
		}
	}
}

void GestureFollower::take_for_start(const HandFrame &frame) {
	element_.feature().start_here(frame, task_);
	window_.reset();
	still_since_s_ = frame.t_s;
}

double GestureFollower::mean_log_likelihood() const {
	return symbols_seen_ > 0 ? likelihood_.log_likelihood() / symbols_seen_ : 0.0;
}

Motion GestureFollower::motion(double t_s) const {
	if (mode_ == MotionMode::PHASE) {
		const PhaseEstimate estimate = phase_.at(t_s);
		return { task_.amplitude_m * estimate.value, task_.amplitude_m * estimate.velocity,
			task_.amplitude_m * estimate.acceleration, stage_ == Stage::RESTING ? 0.0 : estimate.phase };
	}
	if (stage_ != Stage::RESTING) {
		return paper_.motion(t_s, task_.amplitude_m);
	}
	const double released = (t_s - stage_began_s_) / RELEASE_S;
	if (!(released < 1.0)) {
		return {};
	}
	return { released_from_m_ * (1.0 - released), -released_from_m_ / RELEASE_S, 0.0, 0.0 };
}

} // namespace steadyhand
