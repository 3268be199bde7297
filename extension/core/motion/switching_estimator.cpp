#include "motion/switching_estimator.h"

#include "base/parameters.h"
#include "motion/motion.h"
#include "signal/minimum_jerk.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace steadyhand {
namespace {

constexpr std::array TRACKERS{ TrackerMode::SOUND, TrackerMode::LAGGING };
/// After a longer gap, hypotheses are born only in its last part of this length.
constexpr double LONGEST_GAP_S = 2.0;

double mode_probability(TrackerMode tracker, double lagging) {
	return tracker == TrackerMode::SOUND ? 1.0 - lagging : lagging;
}

/// Probability of a switch with rate per_s within dt_s.
double switch_probability(double per_s, double dt_s) {
	return -std::expm1(-per_s * dt_s);
}

} // namespace

SwitchingEstimator::SwitchingEstimator(const GestureModel &model, double amplitude_m, std::size_t hypotheses,
		double latency_s, double gain_spread) :
		curve_(model),
		amplitude_m_(amplitude_m), hypotheses_(hypotheses), latency_s_(latency_s),
		gain_spread_(gain_spread), hold_process_{ parameters::HOLD_SPEED, parameters::HOLD_RATE_PER_S },
		free_process_{ parameters::FREE_SPEED_M_S / amplitude_m, parameters::FREE_RATE_PER_S } {
	const double step = 2.0 * parameters::WIDEST_DURATION / static_cast<double>(DURATIONS - 1);
	log_duration_deviation_ = 0.55 * step * parameters::LOG_DURATION_SPREAD; // so that neighbours overlap
	double total = 0.0;
	for (std::size_t k = 0; k < DURATIONS; ++k) {
		const double z = step * static_cast<double>(k) - parameters::WIDEST_DURATION;
		log_durations_[k] = std::log(model.duration_mean_s) + parameters::LOG_DURATION_SPREAD * z;
		duration_weights_[k] = std::exp(-0.5 * z * z);
		total += duration_weights_[k];
	}
	for (double &weight : duration_weights_) {
		weight /= total;
	}
	for (Belief *belief : { &now_, &after_[0], &after_[1] }) {
		belief->gestures.reserve(hypotheses + TRACKERS.size() * DURATIONS);
	}
}

void SwitchingEstimator::reset() {
	now_.time_s = now_.measured_s = NEVER_S;
	now_.gestures.clear();
	now_.hold = now_.free = {};
	now_.log_fault = 0.0;
	blend_ = {};
	acceleration_step_ = 0.0;
}

void SwitchingEstimator::reset_at(double t_s, double x) {
	reset();
	reset_s_ = t_s;
	reset_x_ = x;
}

/// Starts HOLD and FREE at position x. A fast hand raises the weight of FREE.
void SwitchingEstimator::begin(double t_s, double x, double v) {
	const double noise = parameters::MEASUREMENT_NOISE * parameters::MEASUREMENT_NOISE;
	const auto start = [&](const HandProcess &process, double v_expected) {
		const double off = v / process.speed, variance = process.speed * process.speed;
		return CurvelessMode{ std::exp(-0.5 * off * off) / process.speed, now_.hold.lagging,
			{ x, v_expected, noise, 0.0, variance } };
	};
	now_.gestures.clear();
	now_.has_faulted = false;
	now_.free = start(free_process_, v);
	now_.hold = start(hold_process_, 0.0);
	now_.time_s = t_s;
	// Half a period later: births lie between the frames of usual rates, whatever the rounding of stamps.
	now_.next_birth_s = t_s + 0.5 * parameters::BIRTH_PERIOD_S;
	normalise();
}

void SwitchingEstimator::restart(double t_s, double shift) {
	if (!has_hand()) {
		return;
	}
	change(t_s, [&] {
		HandMixture shown;
		shown.add(now_.hold.weight, now_.hold.hand);
		shown.add(now_.free.weight, now_.free.hand);
		for (const GestureFilter &gesture : now_.gestures) {
			const GestureFilter::Prediction p = gesture.predict_measurement(curve_, now_.time_s);
			shown.add(gesture.weight, { p.x, 0.0, p.variance, 0.0, 0.0 });
		}
		begin(now_.time_s, shown.state().x + shift, shown.state().v);
		after_[0] = after_[1] = now_;
	});
}

/// Applies a change at t_s and blends the step of the output.
template <class Change> void SwitchingEstimator::change(double t_s, Change apply) {
	const MotionEstimate before = at(t_s);
	apply();
	cached_s_ = NAN;
	const MotionEstimate now = unblended(t_s);
	acceleration_step_ = before.acceleration - before.correction - now.acceleration;
	blend_.start(
			t_s, before.value - now.value, before.velocity - now.velocity, parameters::FRAME_BLEND_PER_S);
}

void SwitchingEstimator::push(const Measurement &measurement, double x) {
	const double t_s = measurement.t_s;
	if (!has_hand()) {
		const double since_s = t_s - reset_s_;
		begin(t_s, x,
				since_s > 0.0 && since_s < parameters::SAME_MOVEMENT_S ? (x - reset_x_) / since_s : 0.0);
		now_.measured_s = now_.changed_s = t_s;
		now_.changed_x = x;
		after_[0] = after_[1] = now_;
		cached_s_ = NAN;
		return;
	}
	if (measurement.is_usable() && !measurement.replaces_last) {
		is_last_used_ = t_s - now_.measured_s >= parameters::LEAST_FRAME_S;
	}
	if (measurement.is_usable() && !is_last_used_) {
		return;
	}
	change(t_s, [&] {
		if (measurement.replaces_last) {
			now_ = after_[1]; // the frames were not lost but late: the wait for them is no fault
		}
		predict(t_s);
		const bool reappears = measurement.status == MeasurementStatus::REAPPEARED;
		if (measurement.status == MeasurementStatus::OUTLIER) {
			count_jump();
		} else if (reappears || measurement.status == MeasurementStatus::FROZEN) {
			count_fault(parameters::LOG_FAULTS);
		}
		if (!measurement.is_usable()) {
			return;
		}
		now_.log_fault = 0.0;
		const double noise = measurement.noise_m / amplitude_m_, since_s = t_s - now_.measured_s;
		const ElementReading reading{ t_s, x,
			noise * noise + parameters::MEASUREMENT_NOISE * parameters::MEASUREMENT_NOISE,
			since_s / (since_s + parameters::ALIKE_S) };
		const std::size_t old_count = now_.gestures.size();
		if (reappears) {
			spawn_unseen_gestures(reading, t_s - now_.changed_s);
		}
		correct(reading, old_count);
		if (x != now_.changed_x) {
			now_.changed_x = x;
			now_.changed_s = t_s;
		}
		// A time without faults is evidence of a sound tracker.
		update_tracker_modes(-parameters::FAULTS_PER_S * std::min(since_s, parameters::BIRTH_PERIOD_S));
		now_.measured_s = t_s;
		prune();
		if (!measurement.replaces_last) {
			std::swap(after_[0], after_[1]);
		}
		after_[0] = now_;
	});
}

void SwitchingEstimator::wait(double t_s, bool is_overdue) {
	if (!has_hand() || t_s <= now_.time_s) {
		return;
	}
	change(t_s, [&] {
		predict(t_s);
		if (is_overdue) {
			count_fault(parameters::LOG_FAULTS);
		}
	});
}

/// Births have a fixed grid in time, so that the estimate does not depend on the times of the calls.
void SwitchingEstimator::predict(double t_s) {
	now_.next_birth_s = std::max(now_.next_birth_s, t_s - LONGEST_GAP_S);
	for (; now_.next_birth_s <= t_s; now_.next_birth_s += parameters::BIRTH_PERIOD_S) {
		step(now_.next_birth_s);
		spawn_gestures(now_.next_birth_s);
		prune();
	}
	step(t_s);
}

void SwitchingEstimator::step(double t_s) {
	const double dt_s = t_s - now_.time_s;
	if (dt_s <= 0.0) {
		return;
	}
	now_.time_s = t_s;
	hold_process_.predict(now_.hold.hand, dt_s);
	free_process_.predict(now_.free.hand, dt_s);
	for (const TrackerMode tracker : TRACKERS) {
		const DampedTransition transition(
				GestureFilter::deviation(tracker), GestureFilter::deviation_rate_per_s(tracker), dt_s);
		for (GestureFilter &gesture : now_.gestures) {
			if (gesture.tracker() == tracker) {
				gesture.predict(transition, dt_s, t_s);
			}
		}
	}
	switch_modes(dt_s);
	if (now_.log_fault > 0.0) {
		const double more = std::min(parameters::LOG_FAULTS_PER_S * dt_s,
				std::max(parameters::MOST_LOG_FAULTS - now_.log_fault, 0.0));
		now_.log_fault += more;
		update_tracker_modes(more);
	}
}

/// Switches between GESTURE, HOLD and FREE. HOLD and FREE continue from the tracker's position, even if it
/// lags.
void SwitchingEstimator::switch_modes(double dt_s) {
	const double to_free = switch_probability(parameters::GESTURE_TO_FREE_PER_S, dt_s);
	const double to_hold = switch_probability(parameters::GESTURE_TO_HOLD_PER_S, dt_s);
	const double hold_to_free = switch_probability(parameters::HOLD_TO_FREE_PER_S, dt_s);
	const double free_to_hold = switch_probability(parameters::FREE_TO_HOLD_PER_S, dt_s);
	const auto at_rest = [&](const HandState &hand) {
		return HandState{ hand.x, 0.0, hand.xx, 0.0, hold_process_.speed * hold_process_.speed };
	};
	HandMixture held, freed;
	double held_lagging = 0.0, freed_lagging = 0.0;
	const auto hold = [&](double weight, const HandState &hand, double lagging) {
		held.add(weight, hand);
		held_lagging += weight * lagging;
	};
	const auto free = [&](double weight, const HandState &hand, double lagging) {
		freed.add(weight, hand);
		freed_lagging += weight * lagging;
	};
	HandState leaving = now_.hold.hand;
	leaving.vv = free_process_.speed * free_process_.speed;
	hold(now_.hold.weight * (1.0 - hold_to_free), now_.hold.hand, now_.hold.lagging);
	hold(now_.free.weight * free_to_hold, at_rest(now_.free.hand), now_.free.lagging);
	free(now_.free.weight * (1.0 - free_to_hold), now_.free.hand, now_.free.lagging);
	free(now_.hold.weight * hold_to_free, leaving, now_.hold.lagging);
	for (GestureFilter &gesture : now_.gestures) {
		if (is_unseen(gesture)) {
			continue; // no measurement shows that it has begun, so it cannot have ended
		}
		const GestureFilter::Prediction &p = gesture.cached_prediction(curve_, now_.time_s);
		const double rate = 1.0 / gesture.duration_s();
		const HandState shown{ p.x, p.velocity, p.variance, 0.0, 0.25 * rate * rate };
		const double lagging = gesture.tracker() == TrackerMode::LAGGING ? 1.0 : 0.0;
		hold(gesture.weight * to_hold, at_rest(shown), lagging);
		free(gesture.weight * to_free, shown, lagging);
		gesture.weight *= 1.0 - to_hold - to_free;
	}
	const double anew = switch_probability(parameters::TRACKER_CHANGES_PER_S, dt_s);
	const auto set_mode = [&](CurvelessMode &r_mode, const HandMixture &mixture, double lagging) {
		if (mixture.weight() > 0.0) {
			lagging = (1.0 - anew) * lagging / mixture.weight() + anew * parameters::LAGGING_SHARE;
			r_mode = { mixture.weight(), lagging, mixture.state() };
		}
	};
	set_mode(now_.hold, held, held_lagging);
	set_mode(now_.free, freed, freed_lagging);
}

/// Applies evidence on the tracker mode. log_ratio: log of P(event | LAGGING) / P(event | SOUND).
void SwitchingEstimator::update_tracker_modes(double log_ratio) {
	const double factor = std::exp(-log_ratio);
	now_.hold.update_tracker_modes(factor);
	now_.free.update_tracker_modes(factor);
	for (GestureFilter &gesture : now_.gestures) {
		gesture.weight *= gesture.tracker() == TrackerMode::SOUND ? factor : 1.0;
	}
	normalise();
}

/// After a jump the error of a LAGGING tracker is unknown.
void SwitchingEstimator::count_jump() {
	const bool is_new = count_fault(parameters::LOG_JUMPS);
	for (GestureFilter &gesture : now_.gestures) {
		if (is_new && gesture.tracker() == TrackerMode::LAGGING) {
			gesture.widen_error();
		}
	}
}

/// Applies the evidence of a fault once; true the first time. While the fault lasts, step() adds more.
bool SwitchingEstimator::count_fault(double log_ratio) {
	now_.has_faulted = true;
	const bool is_new = now_.log_fault == 0.0;
	if (is_new) {
		now_.log_fault = log_ratio;
		update_tracker_modes(log_ratio);
	}
	return is_new;
}

/// Likelihood that a hand at rest in this position begins a gesture, relative to a hand at the start. The
/// onset may be off the start, and the tracker may deviate.
double SwitchingEstimator::start_likelihood(TrackerMode tracker) const {
	const double z =
			now_.hold.hand.x / std::hypot(parameters::START_SPREAD, GestureFilter::deviation(tracker));
	return std::exp(-0.5 * z * z);
}

void SwitchingEstimator::add(
		TrackerMode tracker, double weight, const GestureFilter::Onset &onset, const HandState &from) {
	GestureFilter gesture(tracker, onset, from);
	gesture.weight = weight;
	now_.gestures.push_back(gesture);
}

void SwitchingEstimator::spawn_gestures(double t_s) {
	const double begin = now_.hold.weight * parameters::ONSETS_PER_S * parameters::BIRTH_PERIOD_S;
	double begun = 0.0;
	for (const TrackerMode tracker : TRACKERS) {
		const double begun_weight =
				begin * start_likelihood(tracker) * mode_probability(tracker, now_.hold.lagging);
		begun += begun_weight;
		for (std::size_t k = 0; k < DURATIONS; ++k) {
			const double weight = begun_weight * duration_weights_[k];
			if (weight > parameters::LEAST_WEIGHT * now_.hold.weight) {
				add(tracker, weight,
						{ t_s, 0.5 * parameters::BIRTH_PERIOD_S, log_durations_[k], log_duration_deviation_,
								gain_spread_ },
						now_.hold.hand);
			}
		}
	}
	now_.hold.weight -= begun;
}

/// Adds hypotheses of gestures that began in a gap of gap_s before the reading. Their curves pass through it.
void SwitchingEstimator::spawn_unseen_gestures(const ElementReading &reading, double gap_s) {
	if (reading.x < parameters::START_SPREAD || reading.x >= 1.0) {
		return;
	}
	const double phase = curve_.phase_of(reading.x), slope = curve_.at(phase).slope;
	for (const TrackerMode tracker : TRACKERS) {
		const double deviation = GestureFilter::deviation(tracker);
		const double velocity = GestureFilter::deviation_rate_per_s(tracker) * deviation;
		const double error = std::sqrt(deviation * deviation + reading.variance);
		for (std::size_t k = 0; k < DURATIONS; ++k) {
			const double duration_s = std::exp(log_durations_[k]), elapsed_s = phase * duration_s;
			const double speed = slope / duration_s;
			if (elapsed_s > gap_s + parameters::BIRTH_PERIOD_S || speed <= 0.0) {
				continue;
			}
			add(tracker,
					now_.hold.weight * start_likelihood(tracker) * parameters::ONSETS_PER_S *
							mode_probability(tracker, now_.hold.lagging) * duration_weights_[k] / speed,
					{ reading.t_s - elapsed_s, error / speed, log_durations_[k], log_duration_deviation_,
							gain_spread_ },
					{ 0.0, 0.0, deviation * deviation, 0.0, velocity * velocity });
		}
	}
}

/// count: number of gestures to update. Those after them were spawned from this reading.
void SwitchingEstimator::correct(const ElementReading &reading, std::size_t count) {
	for (std::size_t i = 0; i < count; ++i) {
		GestureFilter &gesture = now_.gestures[i];
		gesture.correct(gesture.cached_prediction(curve_, reading.t_s), reading);
	}
	for (CurvelessMode *other : { &now_.hold, &now_.free }) {
		other->weight *= other->hand.correct(reading);
	}
}

void SwitchingEstimator::normalise() {
	double total = now_.hold.weight + now_.free.weight;
	for (const GestureFilter &gesture : now_.gestures) {
		total += gesture.weight;
	}
	if (!(total > 0.0)) {
		now_.hold.weight = total = 1.0;
	}
	now_.hold.weight /= total;
	now_.free.weight /= total;
	for (GestureFilter &gesture : now_.gestures) {
		gesture.weight /= total;
	}
}

void SwitchingEstimator::prune() {
	double best = std::max(now_.hold.weight, now_.free.weight);
	for (const GestureFilter &gesture : now_.gestures) {
		best = std::max(best, gesture.weight);
	}
	std::erase_if(now_.gestures, [&](const GestureFilter &gesture) {
		return !(gesture.weight > parameters::LEAST_WEIGHT * best);
	});
	if (now_.gestures.size() > hypotheses_) {
		const auto last = now_.gestures.begin() + static_cast<std::ptrdiff_t>(hypotheses_);
		std::ranges::nth_element(now_.gestures, last, std::greater(), &GestureFilter::weight);
		now_.gestures.erase(last, now_.gestures.end());
	}
}

/// Weighted mean of all hypotheses at t_s.
MotionEstimate SwitchingEstimator::mean(double t_s) const {
	MotionEstimate estimate;
	const double ahead_s = t_s + latency_s_, since_s = std::max(ahead_s - now_.time_s, 0.0);
	const double fading = std::exp(-parameters::DEVIATION_RATE_PER_S * since_s);
	double total = now_.hold.weight + now_.free.weight, unseen = 0.0;
	for (const GestureFilter &gesture : now_.gestures) {
		total += gesture.weight;
		if (is_unseen(gesture)) {
			unseen += gesture.weight;
			continue;
		}
		const double late_s = now_.has_faulted && gesture.tracker() == TrackerMode::LAGGING
				? parameters::FAULTY_LATENCY_S
				: 0.0;
		const GestureFilter::Hand hand = gesture.hand(curve_, ahead_s + late_s, since_s, fading);
		estimate.value += gesture.weight * hand.value;
		estimate.velocity += gesture.weight * hand.velocity;
		estimate.acceleration += gesture.weight * hand.acceleration;
		estimate.phase += gesture.weight * hand.phase;
		estimate.remaining += gesture.weight * (1.0 - hand.phase);
		(hand.phase > parameters::VISIBLE_PHASE ? estimate.gesture : estimate.hold) += gesture.weight;
	}
	const auto add_mode = [&](const CurvelessMode &other, const HandProcess &process, double weight) {
		const double velocity = other.hand.v * std::exp(-process.rate_per_s * since_s);
		const double value = other.hand.x + process.displacement_per_velocity_s(since_s) * other.hand.v;
		estimate.value += weight * value;
		estimate.velocity += weight * velocity;
		estimate.acceleration -= weight * process.rate_per_s * velocity;
		estimate.phase += weight * minimum_jerk_share(value);
	};
	add_mode(now_.hold, hold_process_, now_.hold.weight + unseen);
	add_mode(now_.free, free_process_, now_.free.weight);
	estimate.hold = (estimate.hold + now_.hold.weight + unseen) / total;
	estimate.gesture /= total;
	estimate.remaining /= total;
	estimate.value /= total;
	estimate.velocity /= total;
	estimate.acceleration /= total;
	estimate.phase = std::clamp(estimate.phase / total, 0.0, 1.0);
	return estimate;
}

MotionEstimate SwitchingEstimator::unblended(double t_s) const {
	if (!has_hand()) {
		return {};
	}
	if (cached_s_ != t_s) {
		cached_ = mean(std::max(t_s, now_.time_s));
		cached_s_ = t_s;
	}
	return cached_;
}

MotionEstimate SwitchingEstimator::at(double t_s) const {
	MotionEstimate estimate = unblended(t_s);
	const CriticallyDamped missing = blend_.at(t_s);
	estimate.value += missing.value;
	estimate.velocity += missing.velocity;
	estimate.acceleration += missing.acceleration;
	estimate.correction = missing.acceleration - acceleration_step_ * blend_.share_left(t_s);
	return estimate;
}

} // namespace steadyhand
