#include "motion/gesture_hypothesis.h"

#include "signal/minimum_jerk.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

constexpr double NOISE = 0.0051; ///< white part of a tracker's error, amplitudes
/// Of an outlier, amplitudes: jumps of some centimetres.
constexpr double OUTLIER_DEVIATION = 0.21;
/// A tracker falls behind gradually: in a shorter gesture it comes to less of its lag.
constexpr double LAG_SETTLING_S = 0.39;
const double LOG_IMPOSSIBLE = std::log(1e-30);
constexpr double LARGEST_LOG = 700.0;
/// Durations that a hypothesis may come to.
const double LOG_SHORTEST = std::log(0.12);
const double LOG_LONGEST = std::log(6.0);
/// Of the minimum jerk's share in the curve: people differ from the recordings.
constexpr double SHAPE_MEAN = 0.36;
constexpr double SHAPE_DEVIATION = 0.33;

} // namespace

void GestureHypothesis::begin_at(Eigen::Index i, double mean, double deviation) {
	mean_[i] = mean;
	covariance_(i, i) = deviation * deviation;
}

GestureHypothesis GestureHypothesis::resting(double d) {
	GestureHypothesis h;
	const RegimeNumbers &numbers = regime_numbers(Regime::REST);
	h.begin_at(HAND, d, numbers.hand.amplitudes);
	h.begin_at(HAND_RATE, 0.0, numbers.hand.amplitudes * numbers.hand.rate_per_s);
	h.begin_error();
	return h;
}

void GestureHypothesis::begin_error() {
	const Deviation &error = regime_numbers(regime_).error;
	begin_at(ERROR, 0.0, error.amplitudes);
	begin_at(ERROR_RATE, 0.0, error.amplitudes * error.rate_per_s);
}

GestureHypothesis GestureHypothesis::begun(Regime regime, double onset_s, double onset_deviation_s,
		double log_duration, double log_duration_deviation) const {
	GestureHypothesis h = in(regime);
	const RegimeNumbers &numbers = regime_numbers(regime);
	h.on_its_way_ = true;
	h.extent_ = numbers.lag_deviation_s > 0.0 ? Extent::ALL : Extent::WITHOUT_LAG;
	h.begin_at(ONSET, onset_s, onset_deviation_s);
	h.begin_at(LOG_DURATION, log_duration, log_duration_deviation);
	h.begin_at(GAIN, 0.0, numbers.gain_deviation);
	h.begin_at(SHAPE, SHAPE_MEAN, SHAPE_DEVIATION);
	h.rate_per_s_ = std::exp(-log_duration);
	const double lags = 1.0 / (1.0 + LAG_SETTLING_S * h.rate_per_s_);
	h.begin_at(LAG, lags * numbers.lag_s, lags * numbers.lag_deviation_s);
	return h;
}

GestureHypothesis GestureHypothesis::in(Regime regime) const {
	GestureHypothesis h = *this;
	h.regime_ = regime;
	return h;
}

GestureHypothesis GestureHypothesis::displaced(double deviation) const {
	GestureHypothesis h = *this;
	h.covariance_(ERROR, ERROR) += deviation * deviation;
	return h;
}

void GestureHypothesis::forget_error() {
	covariance_.middleRows<2>(ERROR).setZero();
	covariance_.middleCols<2>(ERROR).setZero();
	begin_error();
}

double GestureHypothesis::way(const ElementCurve &curve, double phase) const {
	const double elements = curve.at(phase).value;
	return std::clamp(elements + mean_[SHAPE] * (minimum_jerk(phase).value - elements), 0.0, 1.0);
}

void GestureHypothesis::predict(const ElementCurve &curve, double t_s, const Passages &passages) {
	const Passage &passage = passages[static_cast<std::size_t>(regime_)];
	const RegimeNumbers &numbers = regime_numbers(regime_);
	double error = numbers.error.amplitudes;
	if (on_its_way_ && numbers.error_on_way > 0.0) {
		error += numbers.error_on_way * way(curve, (t_s - mean_[ONSET]) * rate_per_s_);
	}
	switch (extent_) {
		case Extent::AT_REST:
			return predict_first<static_cast<int>(Extent::AT_REST)>(error * error, passage);
		case Extent::WITHOUT_LAG:
			return predict_first<static_cast<int>(Extent::WITHOUT_LAG)>(error * error, passage);
		case Extent::ALL:
			return predict_first<static_cast<int>(Extent::ALL)>(error * error, passage);
	}
}

/// The covariance becomes F P F' + Q, where F differs from unity in two pairs of states alone: a deviation
/// and its rate, of the hand and of the tracker.
template <int N> void GestureHypothesis::predict_first(double error_variance, const Passage &passage) {
	const double hand = regime_numbers(regime_).hand.amplitudes;
	Eigen::Matrix<double, N, DAMPED, Eigen::DontAlign> next;
	for (const Eigen::Index i : { HAND, ERROR }) {
		const Damping &by = i == HAND ? passage.hand : passage.error;
		const double x = mean_[i], v = mean_[i + 1];
		mean_[i] = by.xx * x + by.xv * v;
		mean_[i + 1] = by.vx * x + by.vv * v;
		const auto column_x = covariance_.col(i).template head<N>(),
				   column_v = covariance_.col(i + 1).template head<N>();
		next.col(i) = by.xx * column_x + by.xv * column_v;
		next.col(i + 1) = by.vx * column_x + by.vv * column_v;
	}
	for (const Eigen::Index i : { HAND, ERROR }) {
		const Damping &by = i == HAND ? passage.hand : passage.error;
		const double variance = i == HAND ? hand * hand : error_variance;
		const Eigen::Matrix<double, 1, DAMPED> row_x = next.row(i), row_v = next.row(i + 1);
		next.row(i) = by.xx * row_x + by.xv * row_v;
		next.row(i + 1) = by.vx * row_x + by.vv * row_v;
		next(i, i) += variance * by.noise_x;
		next(i + 1, i) += variance * by.noise_xv;
		next(i + 1, i + 1) += variance * by.noise_v;
	}
	covariance_.template topLeftCorner<N, DAMPED>() = next;
	for (Eigen::Index j = 1; j < N; ++j) { // stays symmetric
		const Eigen::Index above = std::min<Eigen::Index>(j, DAMPED);
		covariance_.col(j).head(above) = covariance_.row(j).head(above).transpose();
	}
}

double GestureHypothesis::expected(const ElementCurve &curve, double t_s, State &r_slopes) const {
	const double beside = mean_[HAND] + mean_[ERROR];
	if (!on_its_way_) {
		return beside;
	}
	const double rate = rate_per_s_;
	const double now = (t_s - mean_[ONSET]) * rate;
	const double gone = mean_[LAG] > 0.0 ? way(curve, now) : 0.0;
	const double phase = now - mean_[LAG] * gone * rate;
	if (phase <= 0.0) {
		return beside;
	}
	const CurvePoint elements = curve.at(phase);
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

void GestureHypothesis::absorb(const ElementCurve &curve, double t_s, double x, const Trust &trust) {
	State slopes = State::Zero();
	slopes[HAND] = slopes[ERROR] = 1.0;
	const double innovation = x - expected(curve, t_s, slopes);
	switch (extent_) {
		case Extent::AT_REST:
			return absorb_first<static_cast<int>(Extent::AT_REST)>(innovation, slopes, trust);
		case Extent::WITHOUT_LAG:
			return absorb_first<static_cast<int>(Extent::WITHOUT_LAG)>(innovation, slopes, trust);
		case Extent::ALL:
			return absorb_first<static_cast<int>(Extent::ALL)>(innovation, slopes, trust);
	}
}

template <int N>
void GestureHypothesis::absorb_first(double innovation, const State &slopes, const Trust &trust) {
	using Column = Eigen::Matrix<double, N, 1, Eigen::DontAlign>;
	Column seen = covariance_.col(HAND).template head<N>() + covariance_.col(ERROR).template head<N>();
	for (Eigen::Index j = ONSET; j < N; ++j) {
		seen += slopes[j] * covariance_.col(j).template head<N>();
	}
	const double variance = slopes.template head<N>().dot(seen) + NOISE * NOISE + trust.jitter * trust.jitter;
	const double precision = 1.0 / variance;
	const double broad_precision = 1.0 / (variance + OUTLIER_DEVIATION * OUTLIER_DEVIATION);
	const double half_squared = 0.5 * innovation * innovation;
	// Of an outlier against a good frame; beyond LARGEST_LOG the exponential would be infinite, and none is
	// good.
	const double log_ratio = half_squared * (precision - broad_precision);
	const double bad = trust.outlier * std::sqrt(broad_precision);
	double good_share = 0.0, log_likelihood = 0.0;
	if (log_ratio < LARGEST_LOG) {
		const double good = (1.0 - trust.outlier) * std::sqrt(precision);
		const double sum = good + bad * std::exp(log_ratio);
		good_share = good / sum;
		log_likelihood = std::log(sum) - half_squared * precision;
	} else {
		log_likelihood = std::log(bad) - half_squared * broad_precision;
	}
	log_weight += trust.weight * std::max(log_likelihood, LOG_IMPOSSIBLE);

	mean_.template head<N>() += seen * (good_share * innovation * precision);
	const double less = good_share * precision * (1.0 - 2.0 * (1.0 - good_share) * half_squared * precision);
	for (Eigen::Index j = 0; j < N; ++j) {
		covariance_.col(j).template head<N>() -= (seen * seen[j]) * less; // in this order it stays symmetric
	}
	if (on_its_way_) {
		mean_[LOG_DURATION] = std::clamp(mean_[LOG_DURATION], LOG_SHORTEST, LOG_LONGEST);
		mean_[LAG] = std::max(mean_[LAG], 0.0);
		rate_per_s_ = std::exp(-mean_[LOG_DURATION]);
	}
}

} // namespace steadyhand
