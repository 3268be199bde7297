#include "motion/motion_outlook.h"

#include "signal/critically_damped.h"
#include "signal/minimum_jerk.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

/// A motion that had not come this far when it was last seen could as well not have begun.
constexpr double VISIBLE_PHASE = 0.06;
constexpr double WAITING_LENGTH = 0.05; ///< phase that a motion still makes that waits to be seen
constexpr double NEGLIGIBLE = 1e-5;     ///< weight beside the best one's 1

} // namespace

MotionOutlook::MotionOutlook(double ahead_s) :
		ahead_s_(ahead_s), fading_from_(fading(ahead_s)), fading_to_(fading(ahead_s + PIECE_S)) {}

MotionOutlook::Fading MotionOutlook::fading(double dt_s) {
	Fading all;
	for (std::size_t i = 0; i < REGIMES; ++i) {
		all[i] = std::exp(-regime_numbers(static_cast<Regime>(i)).hand.rate_per_s * dt_s);
	}
	return all;
}

void MotionOutlook::look(
		const HypothesisBank &bank, const ElementCurve &curve, double filtered_s, double seen_s) {
	filtered_s_ = filtered_s;
	count_ = 0;
	hand_.fill({});
	moving_ = 0.0;
	double total = 0.0;
	for (const GestureHypothesis &h : bank.all()) {
		total += h.weight > NEGLIGIBLE ? h.weight : 0.0;
	}
	for (const GestureHypothesis &h : bank.all()) {
		if (h.weight <= NEGLIGIBLE) {
			continue;
		}
		const double weight = h.weight / total;
		Wandering &hand = hand_[static_cast<std::size_t>(h.regime())];
		hand.x += weight * h.hand_deviation();
		hand.v += weight * h.hand_deviation_rate();
		if (h.on_its_way()) {
			const GestureHypothesis::Course course = h.course();
			const double seen_phase = (seen_s - course.onset_s) * course.rate_per_s;
			const bool waits = seen_phase < VISIBLE_PHASE || h.regime() == Regime::FREE;
			const double waits_from = waits ? std::max(seen_phase, 0.0) : INFINITY;
			const double way = weight * course.gain;
			courses_[count_++] = { course.onset_s, course.rate_per_s, way * (1.0 - course.shape),
				way * course.shape, weight, waits_from };
			moving_ += weight;
		}
	}
	const auto [from, rate_per_s] = mean(curve, ahead_s_, fading_from_);
	const PhaseEstimate to = mean(curve, ahead_s_ + PIECE_S, fading_to_).estimate;
	piece_ = QuinticPiece::between({ from.value, from.velocity, from.acceleration },
			{ to.value, to.velocity, to.acceleration }, PIECE_S);
	piece_from_s_ = filtered_s + ahead_s_;
	const double bend = (to.phase - from.phase) / PIECE_S - rate_per_s;
	phase_ = { from.phase, rate_per_s, bend / PIECE_S };
}

/// dt_s: since the hypotheses' time
MotionOutlook::Mean MotionOutlook::mean(const ElementCurve &curve, double dt_s, const Fading &fading) const {
	Mean mean;
	PhaseEstimate &estimate = mean.estimate;
	estimate.moving = moving_;
	const double t_s = filtered_s_ + dt_s;
	for (std::size_t i = 0; i < REGIMES; ++i) {
		const auto &[x, v] = hand_[i];
		if (x == 0.0 && v == 0.0) {
			continue;
		}
		const CriticallyDamped hand = critically_damped(
				x, v, regime_numbers(static_cast<Regime>(i)).hand.rate_per_s, dt_s, fading[i]);
		estimate.value += hand.value;
		estimate.velocity += hand.velocity;
		estimate.acceleration += hand.acceleration;
	}
	for (std::size_t i = 0; i < count_; ++i) {
		const Course &course = courses_[i];
		double rate = course.rate_per_s;
		double phase = (t_s - course.onset_s) * rate;
		if (phase > course.waits_from) {
			const double slowed = std::exp((course.waits_from - phase) / WAITING_LENGTH);
			phase = course.waits_from + WAITING_LENGTH * (1.0 - slowed);
			rate *= slowed;
		}
		if (phase > 0.0) {
			const CurvePoint elements = curve.at(phase);
			const Polynomial::Point smooth = minimum_jerk(phase);
			estimate.value += course.elements * elements.value + course.smooth * smooth.value;
			estimate.velocity += rate * (course.elements * elements.slope + course.smooth * smooth.first);
			estimate.acceleration +=
					rate * rate * (course.elements * elements.curvature + course.smooth * smooth.second);
			estimate.phase += course.weight * std::min(phase, 1.0);
			mean.phase_rate_per_s += phase < 1.0 ? course.weight * rate : 0.0;
		}
	}
	return mean;
}

} // namespace steadyhand
