#include "motion/phase_estimator.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace steadyhand {
namespace {

// Deviations in amplitudes, times in seconds. Set on synthetic subjects of the tuning population and on other
// recordings than those that are evaluated; the figures change little over a factor of two in any of them
// (docs/method.md).
constexpr double GAIN_DEVIATION = 0.05; ///< g: endpoint spread of aimed movements
constexpr double HAND_DEVIATION = 0.03; ///< d
constexpr double HAND_MEMORY_S = 0.25; ///< while the hand does what the gesture says; longer the less it does
constexpr double SOUND_ERROR = 0.02;   ///< b while nothing wrong has been seen
constexpr double UNSOUND_ERROR = 0.10; ///< b, added at full unsoundness
constexpr double ERROR_MEMORY_S = 1.0;
constexpr double UNSOUND_LAG_S = 0.10; ///< at full unsoundness, at the far end of the way
constexpr double NOISE = 0.004;        ///< white part of a tracker's error
constexpr double TAIL = 3.0;           ///< degrees of freedom of the innovation's Student t
constexpr double ONSETS_PER_S = 2.0;   ///< how soon a hand at rest begins
constexpr double BRANCH_PERIOD_S = 0.02;
constexpr double SHORTEST_S = 0.15; ///< of the durations that are studied
constexpr double LONGEST_S = 4.0;
constexpr double SURPRISE_GAIN = 0.15; ///< a sound frame's share in the mean
constexpr double LARGEST_SURPRISE = 100.0;
constexpr double BLEND_RATE_PER_S = 100.0; ///< 1 / 10 ms
constexpr double NEGLIGIBLE =
		-16.0; ///< log weight against the best: contributes less than the tracker's noise

const double AT_REST = std::numeric_limits<double>::infinity();

bool likelier(double a, double b) {
	return a > b;
}

} // namespace

PhaseEstimator::PhaseEstimator(const GestureModel &model) : model_(&model) {
	// Log-normal about the model's mean, never narrower than a factor of 1.5: people differ from the
	// recordings.
	const double relative = model.duration_deviation_s / model.duration_mean_s;
	const double spread = std::max(std::sqrt(std::log1p(relative * relative)), 0.4);
	const double centre = std::log(model.duration_mean_s) - 0.5 * spread * spread;
	double total = 0.0;
	for (int k = 0; k < DURATIONS; ++k) {
		const double z = 2.2 * (2.0 * k / (DURATIONS - 1) - 1.0); // evenly over +-2.2 deviations
		const auto i = static_cast<std::size_t>(k);
		durations_s_[i] = std::clamp(std::exp(centre + spread * z), SHORTEST_S, LONGEST_S);
		log_prior_[i] = -0.5 * z * z;
		total += std::exp(log_prior_[i]);
	}
	for (double &log_prior : log_prior_) {
		log_prior -= std::log(total);
	}
}

void PhaseEstimator::begin(double t_s) {
	Hypothesis rest;
	rest.onset_s = AT_REST;
	rest.gg = GAIN_DEVIATION * GAIN_DEVIATION;
	rest.dd = HAND_DEVIATION * HAND_DEVIATION;
	rest.bb = SOUND_ERROR * SOUND_ERROR;
	hypotheses_[0] = rest;
	count_ = 1;
	filtered_s_ = blended_s_ = t_s;
	next_branch_s_ = t_s + BRANCH_PERIOD_S;
}

void PhaseEstimator::restart() {
	if (count_ == 0) {
		return;
	}
	const PhaseEstimate before = at(filtered_s_);
	begin(filtered_s_);
	hypotheses_[0].d = before.value;
	surprise_ = 1.0;
	blend_from(before, filtered_s_);
}

CurvePoint PhaseEstimator::curve(const Hypothesis &hypothesis, double t_s) const {
	if (hypothesis.onset_s == AT_REST) {
		return {};
	}
	const double phase = (t_s - hypothesis.onset_s) / hypothesis.duration_s;
	if (phase <= 0.0) {
		return {};
	}
	CurvePoint point = evaluate(*model_, phase);
	if (phase >= 1.0) {
		return { point.value, 0.0, 0.0 };
	}
	point.slope /= hypothesis.duration_s;
	point.curvature /= hypothesis.duration_s * hypothesis.duration_s;
	return point;
}

void PhaseEstimator::advance(double t_s) {
	if (count_ == 0) {
		return;
	}
	// After a pause of hours only the last seconds can hold an onset that still matters.
	next_branch_s_ = std::max(next_branch_s_, t_s - 2.0 * LONGEST_S);
	while (next_branch_s_ <= t_s) {
		branch(next_branch_s_);
		next_branch_s_ += BRANCH_PERIOD_S;
	}
}

void PhaseEstimator::branch(double t_s) {
	const PhaseEstimate before = at(t_s);
	constexpr double STARTS = ONSETS_PER_S * BRANCH_PERIOD_S;
	for (std::size_t k = 0; k < DURATIONS; ++k) {
		Hypothesis &started = hypotheses_[static_cast<std::size_t>(count_++)];
		started = hypotheses_[0];
		started.onset_s = t_s - 0.5 * BRANCH_PERIOD_S;
		started.duration_s = durations_s_[k];
		started.log_weight += std::log(STARTS) + log_prior_[k];
	}
	hypotheses_[0].log_weight += std::log1p(-STARTS);
	drop_unlikely();
	blend_from(before, t_s);
}

void PhaseEstimator::drop_unlikely() {
	if (count_ <= KEPT) {
		return;
	}
	std::nth_element(hypotheses_.begin() + 1, hypotheses_.begin() + KEPT, hypotheses_.begin() + count_,
			[](const Hypothesis &a, const Hypothesis &b) { return likelier(a.log_weight, b.log_weight); });
	count_ = KEPT;
}

double PhaseEstimator::hand_memory_s() const {
	return HAND_MEMORY_S * std::sqrt(surprise_);
}

void PhaseEstimator::predict(double t_s) {
	const double dt_s = std::max(t_s - filtered_s_, 0.0);
	filtered_s_ = t_s;
	const double keep_d = std::exp(-dt_s / hand_memory_s());
	const double keep_b = std::exp(-dt_s / ERROR_MEMORY_S);
	const double error = SOUND_ERROR + UNSOUND_ERROR * soundness_.unsoundness();
	const double add_d = HAND_DEVIATION * HAND_DEVIATION * surprise_ * (1.0 - keep_d * keep_d);
	const double add_b = error * error * (1.0 - keep_b * keep_b);
	for (int i = 0; i < count_; ++i) {
		Hypothesis &h = hypotheses_[static_cast<std::size_t>(i)];
		h.d *= keep_d;
		h.b *= keep_b;
		h.gd *= keep_d;
		h.gb *= keep_b;
		h.dd = h.dd * keep_d * keep_d + add_d;
		h.db *= keep_d * keep_b;
		h.bb = h.bb * keep_b * keep_b + add_b;
	}
}

double PhaseEstimator::absorb(Hypothesis &r_hypothesis, double f, double x) {
	Hypothesis &h = r_hypothesis;
	// The frame sees f g + d + b: pg, pd, pb are the covariances of the three with it.
	const double pg = h.gg * f + h.gd + h.gb;
	const double pd = h.gd * f + h.dd + h.db;
	const double pb = h.gb * f + h.db + h.bb;
	const double variance = pg * f + pd + pb + NOISE * NOISE;
	const double innovation = x - (f * (1.0 + h.g) + h.d + h.b);
	const double squared = innovation * innovation / variance;
	h.log_weight -= 0.5 * (TAIL + 1.0) * std::log1p(squared / TAIL) + 0.5 * std::log(variance);
	// A Student t is a Gaussian of unknown variance: an outlier is likely one of a large variance, and moves
	// little.
	const double inflated = variance * std::max(1.0, (TAIL + squared) / (TAIL + 1.0));
	const double kg = pg / inflated, kd = pd / inflated, kb = pb / inflated;
	h.g += kg * innovation;
	h.d += kd * innovation;
	h.b += kb * innovation;
	h.gg -= kg * pg;
	h.gd -= kg * pd;
	h.gb -= kg * pb;
	h.dd -= kd * pd;
	h.db -= kd * pb;
	h.bb -= kb * pb;
	return squared;
}

void PhaseEstimator::correct(double t_s, double x) {
	const double lag_s = UNSOUND_LAG_S * soundness_.unsoundness();
	double best = -std::numeric_limits<double>::infinity();
	double squared_sum = 0.0, weight_sum = 0.0;
	for (int i = 0; i < count_; ++i) {
		Hypothesis &h = hypotheses_[static_cast<std::size_t>(i)];
		const double weight = std::exp(h.log_weight);
		const double now = curve(h, t_s).value;
		const double f = lag_s > 0.0 ? curve(h, t_s - lag_s * now).value : now;
		squared_sum += weight * absorb(h, f, x);
		weight_sum += weight;
		best = std::max(best, h.log_weight);
	}
	for (int i = 0; i < count_; ++i) {
		hypotheses_[static_cast<std::size_t>(i)].log_weight -= best;
	}
	const double sound = 1.0 - soundness_.unsoundness();
	const double share = SURPRISE_GAIN * sound * sound;
	surprise_ += share * (squared_sum / weight_sum - surprise_);
	surprise_ = std::clamp(surprise_, 1.0, LARGEST_SURPRISE);
}

void PhaseEstimator::push(double t_s, double x) {
	if (count_ == 0) {
		begin(t_s);
		hypotheses_[0].d = x;
	}
	advance(t_s);
	const PhaseEstimate before = at(t_s);
	soundness_.push(t_s, x);
	predict(t_s);
	if (!soundness_.frozen()) { // a repeated value is no news of the hand
		correct(t_s, x);
	}
	blend_from(before, t_s);
}

PhaseEstimate PhaseEstimator::expected(double t_s) const {
	PhaseEstimate estimate;
	const double memory_s = hand_memory_s();
	const double keep_d = std::exp(-std::max(t_s - filtered_s_, 0.0) / memory_s);
	double total = 0.0;
	for (int i = 0; i < count_; ++i) {
		const Hypothesis &h = hypotheses_[static_cast<std::size_t>(i)];
		if (h.log_weight < NEGLIGIBLE) {
			continue;
		}
		const double weight = std::exp(h.log_weight);
		const CurvePoint point = curve(h, t_s);
		const double d = h.d * keep_d;
		total += weight;
		estimate.value += weight * (point.value * (1.0 + h.g) + d);
		estimate.velocity += weight * (point.slope * (1.0 + h.g) - d / memory_s);
		estimate.acceleration += weight * (point.curvature * (1.0 + h.g) + d / (memory_s * memory_s));
		if (h.onset_s != AT_REST) {
			estimate.moving += weight;
			estimate.phase += weight * std::clamp((t_s - h.onset_s) / h.duration_s, 0.0, 1.0);
		}
	}
	if (total > 0.0) {
		estimate.value /= total;
		estimate.velocity /= total;
		estimate.acceleration /= total;
		estimate.phase /= total;
		estimate.moving /= total;
	}
	return estimate;
}

PhaseEstimate PhaseEstimator::at(double t_s) const {
	if (count_ == 0) {
		return {};
	}
	PhaseEstimate estimate = expected(t_s);
	// Critically damped from the last change: (v + c s) exp(-k s), c = v' + k v.
	const double s = std::max(t_s - blended_s_, 0.0);
	const double fading = std::exp(-BLEND_RATE_PER_S * s);
	const double c = blend_velocity_ + BLEND_RATE_PER_S * blend_value_;
	const double left = blend_value_ + c * s;
	estimate.value += left * fading;
	estimate.velocity += (c - BLEND_RATE_PER_S * left) * fading;
	estimate.acceleration += BLEND_RATE_PER_S * (BLEND_RATE_PER_S * left - 2.0 * c) * fading;
	return estimate;
}

void PhaseEstimator::blend_from(const PhaseEstimate &before, double t_s) {
	const PhaseEstimate now = expected(t_s);
	blend_value_ = before.value - now.value;
	blend_velocity_ = before.velocity - now.velocity;
	blended_s_ = t_s;
}

} // namespace steadyhand
