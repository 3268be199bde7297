#include "motion/gesture_hypothesis.h"

#include "signal/minimum_jerk.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace steadyhand {
namespace {

constexpr double NOISE = 0.004; ///< white part of a tracker's error, amplitudes
/// Of an outlier, amplitudes: jumps of some centimetres.
constexpr double OUTLIER_DEVIATION = 0.3;
constexpr double IMPOSSIBLE = 1e-30;
/// Durations that a hypothesis may come to.
const double LOG_SHORTEST = std::log(0.12);
const double LOG_LONGEST = std::log(6.0);
/// Of the minimum jerk's share in the curve: people differ from the recordings.
constexpr double SHAPE_MEAN = 0.3;
constexpr double SHAPE_DEVIATION = 0.3;

constexpr Deviation SMALL_ERROR{ 0.005, 2.0 };
constexpr std::array<RegimeNumbers, 4> NUMBERS{
	RegimeNumbers{ { 0.045, 4.5 }, SMALL_ERROR, 0.0, 0.0, 0.0, 0.05 },
	RegimeNumbers{ { 0.08, 4.0 }, SMALL_ERROR, 0.0, 0.0, 0.0, 0.05 },
	RegimeNumbers{ { 0.015, 8.0 }, { 0.01, 5.0 }, 0.06, 0.12, 0.06, 0.04 },
	RegimeNumbers{ { 0.5, 4.0 }, SMALL_ERROR, 0.0, 0.0, 0.0, 0.05 },
};

/// Critically damped motion x'' = -2 a x' - a^2 x over a time: [x, x'] is multiplied by this.
struct Transition {
	double xx, xv, vx, vv;

	Transition(double a, double dt_s) {
		const double fading = std::exp(-a * dt_s);
		xx = fading * (1.0 + a * dt_s);
		xv = fading * dt_s;
		vx = -fading * a * a * dt_s;
		vv = fading * (1.0 - a * dt_s);
	}
};

} // namespace

const RegimeNumbers &regime_numbers(Regime regime) {
	return NUMBERS[static_cast<std::size_t>(regime)];
}

void GestureHypothesis::begin_at(Eigen::Index i, double mean, double deviation) {
	mean_[i] = mean;
	covariance_(i, i) = deviation * deviation;
}

GestureHypothesis GestureHypothesis::resting(double d) {
	GestureHypothesis h;
	const RegimeNumbers &numbers = regime_numbers(Regime::REST);
	h.begin_at(HAND, d, numbers.hand.amplitudes);
	h.begin_at(HAND_RATE, 0.0, numbers.hand.amplitudes * numbers.hand.rate_per_s);
	h.begin_at(ERROR, 0.0, numbers.error.amplitudes);
	h.begin_at(ERROR_RATE, 0.0, numbers.error.amplitudes * numbers.error.rate_per_s);
	return h;
}

GestureHypothesis GestureHypothesis::begun(Regime regime, double onset_s, double onset_deviation_s,
		double log_duration, double log_duration_deviation) const {
	GestureHypothesis h = in(regime);
	const RegimeNumbers &numbers = regime_numbers(regime);
	h.on_its_way_ = true;
	h.begin_at(ONSET, onset_s, onset_deviation_s);
	h.begin_at(LOG_DURATION, log_duration, log_duration_deviation);
	h.begin_at(LAG, numbers.lag_s, numbers.lag_deviation_s);
	h.begin_at(GAIN, 0.0, numbers.gain_deviation);
	h.begin_at(SHAPE, SHAPE_MEAN, SHAPE_DEVIATION);
	return h;
}

GestureHypothesis GestureHypothesis::in(Regime regime) const {
	GestureHypothesis h = *this;
	h.regime_ = regime;
	return h;
}

CurvePoint GestureHypothesis::curve(const GestureModel &model, double phase) const {
	const CurvePoint elements = evaluate_onwards(model, phase);
	const Polynomial::Point smooth = minimum_jerk(phase);
	const double share = mean_[SHAPE];
	return { elements.value + share * (smooth.value - elements.value),
		elements.slope + share * (smooth.first - elements.slope),
		elements.curvature + share * (smooth.second - elements.curvature) };
}

double GestureHypothesis::way(const GestureModel &model, double phase) const {
	return std::clamp(curve(model, phase).value, 0.0, 1.0);
}

void GestureHypothesis::predict(const GestureModel &model, double t_s, double dt_s) {
	const RegimeNumbers &numbers = regime_numbers(regime_);
	Deviation error = numbers.error;
	if (on_its_way_ && numbers.error_on_way > 0.0) {
		error.amplitudes +=
				numbers.error_on_way * way(model, (t_s - mean_[ONSET]) * std::exp(-mean_[LOG_DURATION]));
	}
	damp(HAND, numbers.hand, dt_s);
	damp(ERROR, error, dt_s);
}

void GestureHypothesis::damp(Eigen::Index i, const Deviation &noise, double dt_s) {
	const double a = noise.rate_per_s;
	const Transition by(a, dt_s);
	const double x = mean_[i], v = mean_[i + 1];
	mean_[i] = by.xx * x + by.xv * v;
	mean_[i + 1] = by.vx * x + by.vv * v;

	const Eigen::Matrix<double, 1, STATES> row_x = covariance_.row(i), row_v = covariance_.row(i + 1);
	covariance_.row(i) = by.xx * row_x + by.xv * row_v;
	covariance_.row(i + 1) = by.vx * row_x + by.vv * row_v;
	const State column_x = covariance_.col(i), column_v = covariance_.col(i + 1);
	covariance_.col(i) = by.xx * column_x + by.xv * column_v;
	covariance_.col(i + 1) = by.vx * column_x + by.vv * column_v;

	// As much noise as keeps the stationary variances: s of x, a^2 s of x'.
	const double s = noise.amplitudes * noise.amplitudes, sv = a * a * s;
	const double cross = by.xx * by.vx * s + by.xv * by.vv * sv;
	covariance_(i, i) += s - (by.xx * by.xx * s + by.xv * by.xv * sv);
	covariance_(i, i + 1) -= cross;
	covariance_(i + 1, i) -= cross;
	covariance_(i + 1, i + 1) += sv - (by.vx * by.vx * s + by.vv * by.vv * sv);
}

double GestureHypothesis::expected(const GestureModel &model, double t_s, State &r_slopes) const {
	r_slopes.setZero();
	r_slopes[HAND] = r_slopes[ERROR] = 1.0;
	const double beside = mean_[HAND] + mean_[ERROR];
	if (!on_its_way_) {
		return beside;
	}
	const double rate = std::exp(-mean_[LOG_DURATION]);
	const double now = (t_s - mean_[ONSET]) * rate;
	const double gone = mean_[LAG] > 0.0 ? way(model, now) : 0.0;
	const double phase = now - mean_[LAG] * gone * rate;
	if (phase <= 0.0) {
		return beside;
	}
	const CurvePoint elements = evaluate_onwards(model, phase);
	const Polynomial::Point smooth = minimum_jerk(phase);
	const double gain = 1.0 + mean_[GAIN];
	const double value = elements.value + mean_[SHAPE] * (smooth.value - elements.value);
	const double slope = gain * (elements.slope + mean_[SHAPE] * (smooth.first - elements.slope));
	r_slopes[ONSET] = -slope * rate;
	r_slopes[LOG_DURATION] = -slope * phase;
	r_slopes[LAG] = -slope * gone * rate;
	r_slopes[GAIN] = value;
	r_slopes[SHAPE] = gain * (smooth.value - elements.value);
	return gain * value + beside;
}

void GestureHypothesis::absorb(const GestureModel &model, double t_s, double x, const Trust &trust) {
	State slopes;
	const double innovation = x - expected(model, t_s, slopes);
	const State seen = covariance_ * slopes;
	const double variance = slopes.dot(seen) + NOISE * NOISE;
	const double squared = innovation * innovation;
	const double broad = variance + OUTLIER_DEVIATION * OUTLIER_DEVIATION;
	const double good = (1.0 - trust.outlier) * std::exp(-0.5 * squared / variance) / std::sqrt(variance);
	const double bad = trust.outlier * std::exp(-0.5 * squared / broad) / std::sqrt(broad);
	log_weight += trust.weight * std::log(std::max(good + bad, IMPOSSIBLE));

	const double share = good + bad > 0.0 ? good / (good + bad) : 0.0;
	const State gain = seen / variance;
	mean_ += gain * (share * innovation);
	covariance_ -= gain * gain.transpose() * (share * variance - share * (1.0 - share) * squared);
	mean_[LOG_DURATION] = std::clamp(mean_[LOG_DURATION], LOG_SHORTEST, LOG_LONGEST);
	mean_[LAG] = std::max(mean_[LAG], 0.0);
}

GestureHypothesis::Hand GestureHypothesis::hand(
		const GestureModel &model, double t_s, double filtered_s) const {
	const double a = regime_numbers(regime_).hand.rate_per_s;
	const double dt_s = std::max(t_s - filtered_s, 0.0);
	const double fading = std::exp(-a * dt_s);
	const double c = mean_[HAND_RATE] + a * mean_[HAND];
	const double left = mean_[HAND] + c * dt_s;
	Hand hand{ left * fading, (c - a * left) * fading, a * (a * left - 2.0 * c) * fading, 0.0 };
	if (!on_its_way_) {
		return hand;
	}
	const double rate = std::exp(-mean_[LOG_DURATION]);
	const double phase = (t_s - mean_[ONSET]) * rate;
	if (phase > 0.0) {
		const CurvePoint point = curve(model, phase);
		const double gain = 1.0 + mean_[GAIN];
		hand.value += gain * point.value;
		hand.velocity += gain * point.slope * rate;
		hand.acceleration += gain * point.curvature * rate * rate;
		hand.phase = std::min(phase, 1.0);
	}
	return hand;
}

} // namespace steadyhand
