#include "motion/motion_outlook.h"

#include "signal/critically_damped.h"
#include "signal/minimum_jerk.h"

#include <algorithm>

namespace steadyhand {
namespace {

constexpr double NEGLIGIBLE = 1e-5; ///< weight beside the best one's 1

} // namespace

void MotionOutlook::look(const HypothesisBank &bank, double filtered_s) {
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
			const double way = weight * course.gain;
			courses_[count_++] = { course.onset_s, course.rate_per_s, way * (1.0 - course.shape),
				way * course.shape, weight };
			moving_ += weight;
		}
	}
}

PhaseEstimate MotionOutlook::at(const ElementCurve &curve, double t_s) const {
	PhaseEstimate estimate;
	estimate.moving = moving_;
	const double dt_s = std::max(t_s - filtered_s_, 0.0);
	for (std::size_t i = 0; i < REGIMES; ++i) {
		const auto &[x, v] = hand_[i];
		if (x == 0.0 && v == 0.0) {
			continue;
		}
		const CriticallyDamped hand =
				critically_damped(x, v, regime_numbers(static_cast<Regime>(i)).hand.rate_per_s, dt_s);
		estimate.value += hand.value;
		estimate.velocity += hand.velocity;
		estimate.acceleration += hand.acceleration;
	}
	for (std::size_t i = 0; i < count_; ++i) {
		const Course &course = courses_[i];
		const double rate = course.rate_per_s;
		const double phase = (t_s - course.onset_s) * rate;
		if (phase > 0.0) {
			const CurvePoint elements = curve.at(phase);
			const Polynomial::Point smooth = minimum_jerk(phase);
			estimate.value += course.elements * elements.value + course.smooth * smooth.value;
			estimate.velocity += rate * (course.elements * elements.slope + course.smooth * smooth.first);
			estimate.acceleration +=
					rate * rate * (course.elements * elements.curvature + course.smooth * smooth.second);
			estimate.phase += course.weight * std::min(phase, 1.0);
		}
	}
	return estimate;
}

} // namespace steadyhand
