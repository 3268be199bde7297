#pragma once

#include "phase/hypothesis_group.h"
#include "signal/minimum_jerk.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace steadyhand::test {

/// GestureHypothesis by the textbook: an extended Kalman filter with dense matrices, what was seen linearised
/// by differences, and what is known of the states carried over to other ones by matrix products.
struct DenseHypothesis {
	using Vector = Eigen::Matrix<double, 9, 1>;
	using Matrix = Eigen::Matrix<double, 9, 9>;
	enum State { D, DV, B, BV, ONSET, LOG_DURATION, GAIN, SHAPE, LAG };
	static constexpr double NOISE = 0.0032, OUTLIER_DEVIATION = 0.21;

	const GestureModel *model;
	Vector mean = Vector::Zero();
	Matrix covariance = Matrix::Zero();
	Regime regime = Regime::REST;
	TrackerError error = TrackerError::SLIGHT;
	bool on_its_way = false;
	double log_weight = 0.0;

	static DenseHypothesis resting(const GestureModel &model, double d) {
		DenseHypothesis h{ .model = &model };
		const Deviation &hand = regime_numbers(Regime::REST).hand;
		h.begin(D, d, hand.amplitudes);
		h.begin(DV, 0.0, hand.amplitudes * hand.rate_per_s);
		h.forget_error();
		return h;
	}

	/// Nothing of it has to do with the other states.
	void begin(State i, double at, double deviation) {
		mean[i] = at;
		covariance.row(i).setZero();
		covariance.col(i).setZero();
		covariance(i, i) = deviation * deviation;
	}
	void forget_error() {
		const Deviation &at_start = error_numbers(error).at_start;
		begin(B, 0.0, at_start.amplitudes);
		begin(BV, 0.0, at_start.amplitudes * at_start.rate_per_s);
	}
	void be_in(Regime next) {
		regime = next;
		error = regime_numbers(next).error;
	}
	void begin_way(Regime next, double onset_s, double onset_deviation_s, double log_duration,
			double log_duration_deviation) {
		be_in(next);
		const RegimeNumbers &numbers = regime_numbers(next);
		on_its_way = true;
		begin(ONSET, onset_s, onset_deviation_s);
		begin(LOG_DURATION, log_duration, log_duration_deviation);
		begin(GAIN, 0.0, numbers.gain_deviation);
		begin(SHAPE, 0.36, 0.33);
		const double lags = 1.0 / (1.0 + 0.39 * std::exp(-log_duration));
		begin(LAG, lags * numbers.lag_s, lags * numbers.lag_deviation_s);
	}
	/// The states become `by` x them, and `off` more.
	void carry_over(const Matrix &by, const Vector &off) {
		mean = by * mean + off;
		covariance = by * covariance * by.transpose();
	}

	/// d becomes 1 + g + d, and the hand is free.
	void leave_end() {
		Matrix by = Matrix::Identity();
		by(D, GAIN) = 1.0;
		by.bottomRightCorner<5, 5>().setZero();
		carry_over(by, Vector::Unit(D));
		on_its_way = false;
		be_in(Regime::FREE);
	}

	[[nodiscard]] double f(double phase, double shape) const {
		const double elements = evaluate_onwards(*model, phase).value;
		return std::clamp(elements + shape * (minimum_jerk(phase).value - elements), 0.0, 1.0);
	}
	[[nodiscard]] double shown(const Vector &m, double t_s) const {
		if (!on_its_way) {
			return m[D] + m[B];
		}
		const double rate = std::exp(-m[LOG_DURATION]), now = (t_s - m[ONSET]) * rate;
		const double phase = now - m[LAG] * f(now, m[SHAPE]) * rate;
		const double elements = evaluate_onwards(*model, phase).value;
		return (1.0 + m[GAIN]) * (elements + m[SHAPE] * (minimum_jerk(phase).value - elements)) + m[D] + m[B];
	}

	/// x'' = -c x'
	static Eigen::Matrix2d slowing(double dt_s) {
		const double left = std::exp(-FREE_SLOWING_PER_S * dt_s);
		return Eigen::Matrix2d{ { 1.0, (1.0 - left) / FREE_SLOWING_PER_S }, { 0.0, left } };
	}
	/// White noise as it comes in on the way of a free hand, a part of the time after the other.
	static Eigen::Matrix2d free_noise(double dt_s) {
		constexpr int PARTS = 1000;
		const Deviation &hand = regime_numbers(Regime::FREE).hand;
		const double speed = hand.amplitudes * hand.rate_per_s;
		Eigen::Matrix2d noise = Eigen::Matrix2d::Zero();
		for (int part = 0; part < PARTS; ++part) {
			const Eigen::Vector2d left = slowing(dt_s * (part + 0.5) / PARTS).col(1);
			noise += 2.0 * FREE_SLOWING_PER_S * speed * speed * (dt_s / PARTS) * left * left.transpose();
		}
		return noise;
	}

	void predict(double t_s, double dt_s) {
		const Deviation &hand = regime_numbers(regime).hand, &at_start = error_numbers(error).at_start;
		const double way =
				on_its_way ? f((t_s - mean[ONSET]) * std::exp(-mean[LOG_DURATION]), mean[SHAPE]) : 0.0;
		Matrix transition = Matrix::Identity(), noise = Matrix::Zero();
		const auto damp = [&](State at, double a, double s) {
			Eigen::Matrix2d step;
			step << 1.0 + a * dt_s, dt_s, -a * a * dt_s, 1.0 - a * dt_s;
			step *= std::exp(-a * dt_s);
			const Eigen::Matrix2d resting = s * s * Eigen::Vector2d(1.0, a * a).asDiagonal().toDenseMatrix();
			transition.block<2, 2>(at, at) = step;
			noise.block<2, 2>(at, at) = resting - step * resting * step.transpose();
		};
		damp(D, hand.rate_per_s, hand.amplitudes);
		damp(B, at_start.rate_per_s, at_start.amplitudes + error_numbers(error).on_way * way);
		if (regime == Regime::FREE) {
			transition.block<2, 2>(D, D) = slowing(dt_s);
			noise.block<2, 2>(D, D) = free_noise(dt_s);
		}
		if (on_its_way) {
			// That phase (t - onset) / duration stays: d onset = -(t - onset) d log duration.
			Vector pace = Vector::Unit(LOG_DURATION);
			pace[ONSET] = -std::min(t_s - mean[ONSET], std::exp(mean[LOG_DURATION]));
			noise += 0.2 * 0.2 * dt_s * pace * pace.transpose();
		}
		mean = transition * mean;
		covariance = transition * covariance * transition.transpose() + noise;
	}

	[[nodiscard]] Vector slopes(double t_s) const {
		Vector slopes;
		for (Eigen::Index j = 0; j < mean.size(); ++j) {
			constexpr double H = 1e-6;
			Vector up = mean, down = mean;
			up[j] += H;
			down[j] -= H;
			slopes[j] = (shown(up, t_s) - shown(down, t_s)) / (2.0 * H);
		}
		if (on_its_way) {
			// The way behind which a tracker lags counts as known.
			const double rate = std::exp(-mean[LOG_DURATION]), now = (t_s - mean[ONSET]) * rate;
			const double gone = f(now, mean[SHAPE]), seen = now - mean[LAG] * gone * rate;
			const auto at = [&](double phase, double shape) {
				Vector m = Vector::Zero();
				m[ONSET] = -phase;
				m[GAIN] = mean[GAIN];
				m[SHAPE] = shape;
				return shown(m, 0.0);
			};
			constexpr double H = 1e-6;
			const double slope = (at(seen + H, mean[SHAPE]) - at(seen - H, mean[SHAPE])) / (2.0 * H);
			slopes[ONSET] = -slope * rate;
			slopes[LOG_DURATION] = -slope * seen;
			slopes[SHAPE] = at(seen, 1.0) - at(seen, 0.0);
			slopes[LAG] = -slope * gone * rate;
		}
		return slopes;
	}

	/// What the frame is, good or an outlier that says nothing, is not known: of the two normal densities
	/// after it the mean and covariance (Bar-Shalom, Li, Kirubarajan 2001, eq. 1.4.16-8, 1.4.16-9). The
	/// weight without sqrt(2 pi).
	void absorb(double t_s, double x, const HypothesisGroup::Trust &trust) {
		const Vector h = slopes(t_s), shared = covariance * h;
		const double shakes = error_numbers(error).noise;
		const double variance = h.dot(shared) + NOISE * NOISE + trust.jitter * trust.jitter + shakes * shakes;
		const double off = x - shown(mean, t_s);
		const auto density = [off](double v) { return std::exp(-0.5 * off * off / v) / std::sqrt(v); };
		const double good = (1.0 - trust.outlier) * density(variance),
					 bad = trust.outlier * density(variance + OUTLIER_DEVIATION * OUTLIER_DEVIATION);
		log_weight += trust.weight * std::log(std::max(good + bad, 1e-30));
		const double share = good / (good + bad);
		const Vector step = shared * off / variance, to_mean = (1.0 - share) * step;
		const Matrix less = shared * shared.transpose() / variance;
		covariance = share * (covariance - less + to_mean * to_mean.transpose()) +
				(1.0 - share) * (covariance + share * step * (share * step).transpose());
		mean += share * step;
		mean[LAG] = std::max(mean[LAG], 0.0);
		mean[LOG_DURATION] = std::clamp(mean[LOG_DURATION], std::log(0.12), std::log(8.0));
	}
};

} // namespace steadyhand::test
