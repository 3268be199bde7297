#include "motion/gesture_follower.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

// All in normalised units: the part of the amplitude, and 1.875 = peak velocity of a minimum-jerk movement.
constexpr double ONSET_VALUE = 0.03;
constexpr double ONSET_VELOCITY = 0.3;
/// Below this the hand has come back to where it started.
constexpr double BACK_VALUE = 0.15;
/// A movement that is still at its start after so many times its mean first state was none.
constexpr double ABORT_AFTER = 3.0;
constexpr double RELEASE_S = 0.1; ///< from the end back to rest, once the hand has returned
constexpr double STILL_VELOCITY = 0.15;
constexpr double STILL_S = 0.15; ///< rest, where the start is not told

} // namespace

GestureFollower::GestureFollower(const GestureModel &model, const Task &task, bool start_is_known) :
		model_(&model),
		feature_(find_feature(model.feature)),
		task_(task),
		start_is_known_(start_is_known),
		decoder_(model.hmm),
		likelihood_(model.hmm),
		synthesiser_(model) {
}

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
	const std::optional<double> x_m = feature_->measure(frame, task_);
	if (!x_m || !std::isfinite(*x_m)) {
		return false;
	}
	window_.push(frame.t_s, *x_m);
	last_frame_ = frame;
	fresh_ = true;
	return true;
}

void GestureFollower::advance(double t_s) {
	while (clock_started_ && clock_.due(t_s)) {
		step(clock_.next_s());
		clock_.advance();
	}
}

void GestureFollower::step(double t_s) {
	const Observation observation = window_.normalised(task_.amplitude_m, model_->duration_mean_s);
	switch (stage_) {
		case Stage::RESTING:
			rest(t_s, observation);
			break;
		case Stage::MOVING:
			move(t_s, observation);
			break;
		case Stage::ARRIVED:
			if (observation.x() < BACK_VALUE) {
				enter(Stage::RESTING, t_s);
			}
			break;
	}
	fresh_ = false;
}

void GestureFollower::rest(double t_s, const Observation &observation) {
	if (observation.x() > ONSET_VALUE && observation.y() > ONSET_VELOCITY) {
		decoder_.reset();
		likelihood_.reset();
		symbols_seen_ = 0;
		state_played_ = 0;
		synthesiser_.begin(t_s, phase_of_value(*model_, std::min(observation.x(), 0.5)));
		enter(Stage::MOVING, t_s);
		move(t_s, observation);
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

void GestureFollower::move(double t_s, const Observation &observation) {
	const Symbol symbol = fresh_ ? model_->quantiser.symbol(observation) : UNSEEN;
	decoder_.push(symbol);
	likelihood_.push(symbol);
	++symbols_seen_;
	if (decoder_.state() > state_played_) {
		state_played_ = decoder_.state();
		synthesiser_.enter_state(state_played_, t_s);
	}
	if (state_played_ == 0 && observation.x() < BACK_VALUE &&
			t_s - stage_began_s_ > ABORT_AFTER * model_->elements.front().duration_mean_s) {
		enter(Stage::RESTING, t_s);
	} else if (synthesiser_.phase(t_s) >= 1.0) {
		enter(Stage::ARRIVED, t_s);
	}
}

void GestureFollower::enter(Stage stage, double t_s) {
	released_from_m_ = stage == Stage::RESTING ? motion(t_s).value_m : 0.0;
	stage_ = stage;
	stage_began_s_ = t_s;
}

void GestureFollower::take_for_start(const HandFrame &frame) {
	feature_->start_here(frame, task_);
	window_.reset();
	still_since_s_ = frame.t_s;
}

double GestureFollower::mean_log_likelihood() const {
	return symbols_seen_ > 0 ? likelihood_.log_likelihood() / symbols_seen_ : 0.0;
}

Motion GestureFollower::motion(double t_s) const {
	if (stage_ != Stage::RESTING) {
		return synthesiser_.motion(t_s, task_.amplitude_m);
	}
	const double released = (t_s - stage_began_s_) / RELEASE_S;
	if (!(released < 1.0)) {
		return {};
	}
	return { released_from_m_ * (1.0 - released), -released_from_m_ / RELEASE_S, 0.0, 0.0 };
}

} // namespace steadyhand
