#include "motion/gesture_follower.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

/// `phase` mode: expected phase and value from which on the gesture is at its end.
constexpr double ARRIVED_PHASE = 0.97;
constexpr double ARRIVED_VALUE = 0.9;
// All in normalised units: the part of the amplitude, and 1.875 = peak velocity of a minimum-jerk movement.
constexpr double ONSET_VALUE = 0.03;
constexpr double ONSET_VELOCITY = 0.3;
constexpr double HALF_WAY = 0.5; ///< from there on a hand has begun, whatever it did before
/// Below this the hand has come back to where it started. On a circle, which leads there anyway, it is on its
/// next round from this far beyond its end on.
constexpr double BACK_VALUE = 0.15;
/// A movement that is still at its start after so many times its mean first state was none.
constexpr double ABORT_AFTER = 3.0;
/// Symbols of a longer pause say no more than those of its last seconds; and a clock that leaps must not
/// hang.
constexpr double LONGEST_GAP_S = 10.0;
/// log odds while the hand has not been still yet, from where a stroke could have begun.
constexpr double NO_STROKE = -10.0;
constexpr double DOUBT_S = 0.3;        ///< at its end a stroke may still turn out to have been the gesture
constexpr double SMALLEST_MOVE = 0.02; ///< amplitudes: a hand that rests beside the start has not begun
/// Shorter strokes (in amplitudes) do not say where they go.
constexpr double LONG_ENOUGH = 0.5;
constexpr double RELEASE_RATE_PER_S = 50.0; ///< from the end back to rest: within a tenth of a second

/// The model's speed at its end in shares of its peak, and what people slow down less.
double end_speed_share(const GestureModel &model) {
	constexpr double SLOWED = 0.25;
	constexpr int POINTS = 50;
	double peak = 0.0;
	for (int i = 0; i <= POINTS; ++i) {
		peak = std::max(peak, evaluate(model, static_cast<double>(i) / POINTS).slope);
	}
	return peak > 0.0 ? SLOWED + std::max(evaluate(model, ARRIVED_PHASE).slope, 0.0) / peak : SLOWED;
}

} // namespace

GestureFollower::GestureFollower(const GestureModel &model, const Task &task, bool start_is_known,
		MotionMode mode, const PhaseEffort &effort, double latency_s, const StateDecoding &decoding) :
		model_(&model),
		element_(*find_feature(model.feature)), feature_(&element_.feature()), task_(task),
		start_is_known_(start_is_known), mode_(mode),
		way_(feature_->direction != nullptr ? feature_->direction(task) : FeaturePlace::Zero()),
		end_speed_share_(end_speed_share(model)), decoder_(model.hmm, decoding), paper_(model),
		phase_(model, effort, latency_s) {}

bool GestureFollower::push(
		const HandFrame &frame, const std::optional<FeaturePlace> &place, const StrokeFinder &strokes) {
	if (!clock_started_) {
		clock_.start(frame.t_s);
		clock_started_ = true;
	}
	double x_m = 0.0;
	if (start_is_known_) {
		if (stage_ == Stage::RESTING) {
			element_.restart();
		}
		const std::optional<double> measured_m = element_.measure(frame, task_);
		if (!measured_m || !std::isfinite(*measured_m)) {
			return false;
		}
		x_m = *measured_m;
		place_ = place.value_or(place_);
	} else {
		if (!place) {
			return false;
		}
		place_ = *place;
		watch(frame.t_s, strokes);
		x_m = (place_ - start_).dot(way_);
	}
	window_.push(frame.t_s, x_m);
	if (follows_phase()) {
		phase_.push(frame.t_s, x_m / task_.amplitude_m, place_ / task_.amplitude_m);
	}
	if (start_is_known_) {
		look_for_move(strokes);
		if (stage_ != Stage::RESTING) {
			judge_by_task(strokes);
		}
	}
	fresh_ = true;
	return true;
}

void GestureFollower::advance(double t_s, const StrokeFinder &strokes) {
	if (clock_started_ && t_s - clock_.next_s() > LONGEST_GAP_S) {
		clock_.start(t_s - LONGEST_GAP_S);
	}
	while (clock_started_ && clock_.due(t_s)) {
		step(clock_.next_s(), strokes);
		clock_.advance();
	}
}

void GestureFollower::step(double t_s, const StrokeFinder &strokes) {
	if (!fresh_ && follows_phase()) {
		phase_.wait(t_s);
	}
	if (stage_ == Stage::MOVING) {
		decode(t_s);
	}
	if (start_is_known_) {
		step_in_task(t_s, strokes);
	}
	fresh_ = false;
}

void GestureFollower::step_in_task(double t_s, const StrokeFinder &strokes) {
	switch (stage_) {
		case Stage::RESTING:
			if (is_rejected_ && is_back(t_s)) {
				is_rejected_ = false;
				phase_.restart(t_s);
			} else if (!is_rejected_ && has_begun(t_s)) {
				judge_by_task(strokes);
				begin(t_s, value());
				decode(t_s);
			}
			break;
		case Stage::MOVING:
			if (was_nothing(t_s)) {
				enter(Stage::RESTING, t_s);
			} else if (has_arrived(t_s)) {
				arrive(t_s);
			} else {
				at_end_since_s_ = t_s;
			}
			break;
		case Stage::ARRIVED:
			if (is_back(t_s)) {
				enter(Stage::RESTING, t_s);
			}
			break;
	}
}

void GestureFollower::arrive(double t_s) {
	if (mode_ == MotionMode::PAPER || std::max(likeliest_, log_odds_of_all_) >= 0.0) {
		enter(Stage::ARRIVED, t_s);
	} else if (t_s - at_end_since_s_ > DOUBT_S) {
		is_rejected_ = true;
		enter(Stage::RESTING, t_s);
	}
}

void GestureFollower::begin(double t_s, double value) {
	decoder_.reset();
	state_played_ = 0;
	likeliest_ = log_odds_of_all_ = NO_STROKE;
	done_.reset();
	last_.reset();
	at_end_since_s_ = t_s;
	if (mode_ == MotionMode::PAPER) {
		paper_.begin(t_s, phase_of_value(*model_, std::min(value, 0.5)));
	}
	enter(Stage::MOVING, t_s);
}

void GestureFollower::decode(double t_s) {
	decoder_.push(fresh_ ? model_->quantiser.symbol(observation()) : UNSEEN);
	if (decoder_.state() > state_played_) {
		state_played_ = decoder_.state();
		if (mode_ == MotionMode::PAPER) {
			paper_.enter_state(state_played_, t_s - decoder_.lag() * SymbolClock::PERIOD_S, t_s);
		}
	}
}

bool GestureFollower::has_begun(double t_s) const {
	if (mode_ == MotionMode::PAPER) {
		return value() > ONSET_VALUE && observation().y() > ONSET_VELOCITY;
	}
	if (!has_moved_) {
		return false;
	}
	const PhaseEstimate estimate = phase_.at(t_s);
	return estimate.value > (estimate.moving > 0.5 ? ONSET_VALUE : HALF_WAY);
}

bool GestureFollower::was_nothing(double t_s) const {
	if (mode_ == MotionMode::PAPER) {
		return state_played_ == 0 && value() < BACK_VALUE &&
				t_s - stage_began_s_ > ABORT_AFTER * model_->elements.front().duration_mean_s;
	}
	const PhaseEstimate estimate = phase_.at(t_s);
	return estimate.value < BACK_VALUE && (estimate.moving < 0.5 || estimate.phase > ARRIVED_PHASE);
}

bool GestureFollower::has_arrived(double t_s) const {
	if (mode_ == MotionMode::PAPER) {
		return paper_.phase(t_s) >= 1.0;
	}
	const PhaseEstimate estimate = phase_.at(t_s);
	// A hand that does something else is where it is.
	return estimate.phase + 1.0 - estimate.moving > ARRIVED_PHASE && estimate.value > ARRIVED_VALUE;
}

bool GestureFollower::is_back(double t_s) const {
	const double shown = mode_ == MotionMode::PAPER ? value() : phase_.at(t_s).value;
	return shown < BACK_VALUE || (element_.is_periodic() && shown > 1.0 + BACK_VALUE);
}

void GestureFollower::look_for_move(const StrokeFinder &strokes) {
	has_moved_ = feature_->place == nullptr; // its way is no stroke
	for (const Stroke &stroke : strokes.strokes()) {
		has_moved_ = has_moved_ ||
				(!stroke.is_lost && (stroke.to - stroke.from).dot(way_) > SMALLEST_MOVE * task_.amplitude_m);
	}
}

/// While the gesture is not under way nobody asks.
void GestureFollower::judge_by_task(const StrokeFinder &strokes) {
	if (feature_->place == nullptr) {
		likeliest_ = log_odds_ = 0.0;
		return;
	}
	const FeaturePlace start = feature_->is_radius
			? FeaturePlace(0.0, 0.0, 0.0, task_.start_m.x())
			: FeaturePlace(task_.start_m.x(), task_.start_m.y(), task_.start_m.z(), 0.0);
	const auto judge = [&](const Stroke &stroke) {
		return LOG_PRIOR_TASK + task_evidence(stroke, start, way_, task_.amplitude_m);
	};
	log_odds_ = NO_STROKE;
	for (const Stroke &stroke : strokes.strokes()) {
		if (stroke.is_lost) {
			continue;
		}
		log_odds_ = std::max(log_odds_, judge(stroke));
		if ((stroke.to - stroke.from).norm() > LONG_ENOUGH * task_.amplitude_m) {
			likeliest_ = std::max(likeliest_, log_odds_);
		}
	}
	collect(strokes);
	if (done_ && last_) {
		log_odds_of_all_ = judge(joined(*done_, *last_));
		log_odds_ = std::max(log_odds_, log_odds_of_all_);
	}
}

void GestureFollower::collect(const StrokeFinder &strokes) {
	if (stage_ == Stage::RESTING || strokes.strokes().empty() || strokes.strokes().front().is_lost) {
		return;
	}
	const Stroke &now = strokes.strokes().front();
	if (last_ && now.onset_s != last_->onset_s) {
		done_ = done_ ? joined(*done_, *last_) : *last_;
	}
	last_ = now;
}

void GestureFollower::enter(Stage stage, double t_s) {
	const Motion before = motion(t_s);
	// Where the task is known the estimator follows the hand at rest too, and blends by itself.
	// A hand that is elsewhere does not begin there.
	const bool restarts = stage == Stage::RESTING && mode_ == MotionMode::PHASE &&
			(!start_is_known_ || (!is_rejected_ && is_back(t_s)));
	stage_ = stage;
	stage_began_s_ = t_s;
	if (restarts) {
		if (element_.is_periodic()) {
			phase_.reset(); // the same place is another value from now on
		} else {
			phase_.restart(t_s);
		}
	}
	if (stage == Stage::RESTING && (!start_is_known_ || mode_ == MotionMode::PAPER)) {
		blend_.start(t_s, before.value_m, before.velocity_m_s, RELEASE_RATE_PER_S);
	}
}

Motion GestureFollower::synthesised(double t_s) const {
	if (mode_ == MotionMode::PHASE) {
		if (!start_is_known_ && stage_ == Stage::RESTING) {
			return {};
		}
		const PhaseEstimate estimate = phase_.at(t_s);
		return { task_.amplitude_m * estimate.value, task_.amplitude_m * estimate.velocity,
			task_.amplitude_m * estimate.acceleration, stage_ == Stage::RESTING ? 0.0 : estimate.phase };
	}
	return stage_ == Stage::RESTING ? Motion{} : paper_.motion(t_s, task_.amplitude_m);
}

Motion GestureFollower::motion(double t_s) const {
	return blend_.completed(synthesised(t_s), t_s);
}

} // namespace steadyhand
