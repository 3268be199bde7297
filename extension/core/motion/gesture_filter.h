#pragma once

#include "motion/hand_filter.h"
#include "motion/reference_table.h"

#include <Eigen/Core>

#include <cmath>
#include <cstdint>

namespace steadyhand {

enum class TrackerMode : std::uint8_t {
	SOUND,  ///< shows where the hand is
	LAGGING ///< has a lag that grows along the way, and an error
};

/// Transition of critically damped noise of variance 1, x'' = -2 a x' - a^2 x + white, over a time.
struct DampedTransition {
	double xx, xv, vx, vv; ///< of [x, x']
	double noise_xx, noise_xv, noise_vv;

	DampedTransition(double rate_per_s, double dt_s);
};

/// One hypothesis of a gesture that has begun: an extended Kalman filter over when it began, how long it
/// takes, how far it goes, its shape, the tracker's lag, and a slow deviation, which is the hand's before a
/// sound tracker and the tracker's error before one that lags:
///
///     hand(t)    = (1 + gain) f(p) + d(t)                        p = (t - onset) / duration
///     tracker(t) = (1 + gain) f(p - lag s f(p) / duration) + d(t) + noise,    f = (1 - shape) e + shape m
///
/// e is the model's reference curve, m minimum jerk, s the share of the lag that builds up in the duration.
/// Bar-Shalom, Li, Kirubarajan 2001, section 10.3.
class GestureFilter {
public:
	/// SIZE: one more than there are, so that a column is whole SIMD registers.
	enum Index : std::uint8_t { ONSET, LOG_DURATION, GAIN, SHAPE, LAG, DEVIATION, DEVIATION_RATE, SIZE = 8 };
	using Vector = Eigen::Matrix<double, SIZE, 1>;
	using Matrix = Eigen::Matrix<double, SIZE, SIZE>;

	struct Onset {
		double t_s, deviation_s;
		double log_duration, log_duration_deviation;
		double gain_deviation;
	};
	struct Prediction {
		double x = 0.0;
		double variance = 0.0;              ///< without the measurement's noise
		double velocity = 0.0;              ///< of the model's curve there
		Vector slope = Vector::Zero();      ///< d x / d state
		Vector covariance = Vector::Zero(); ///< of the state with x
	};
	/// Of the hand: without the tracker's lag and error.
	struct Hand {
		double value, velocity, acceleration, phase;
	};

	double weight = 0.0;

	GestureFilter() = default;
	/// from: the hand at the onset, beside the start.
	GestureFilter(TrackerMode tracker, const Onset &onset, const HandState &from);

	[[nodiscard]] TrackerMode tracker() const { return tracker_; }
	[[nodiscard]] double onset_s() const { return mean_(ONSET); }
	[[nodiscard]] double duration_s() const { return duration_s_; }
	[[nodiscard]] const Vector &mean() const { return mean_; }
	[[nodiscard]] const Matrix &covariance() const { return covariance_; }

	/// dt_s: to t_s, from the last time; transition: of its deviation.
	void predict(const DampedTransition &transition, double dt_s, double t_s);
	[[nodiscard]] Prediction measured(const ReferenceTable &curve, double t_s) const;
	/// The same, kept for the next call.
	const Prediction &keep_measured(const ReferenceTable &curve, double t_s);
	/// Takes in a reading; the weight becomes what the hypothesis and it are worth together.
	void correct(const Prediction &prediction, const ElementReading &reading);
	/// The tracker has jumped: of its error nothing is known.
	void forget_error(double deviation);
	/// At t_s. since_s: since the time that it was predicted to; fading: of the deviation, exp(-rate
	/// since_s).
	[[nodiscard]] Hand hand(const ReferenceTable &curve, double t_s, double since_s, double fading) const;

	/// Standard deviation of the deviation where the curve is at `gone`.
	[[nodiscard]] static double deviation(TrackerMode tracker, double gone);
	[[nodiscard]] static double deviation_rate_per_s(TrackerMode tracker);

private:
	TrackerMode tracker_ = TrackerMode::SOUND;
	double duration_s_ = 1.0;
	double kept_s_ = NAN; ///< the instant of kept_; NAN: the state has changed since
	Prediction kept_;
	Vector mean_ = Vector::Zero();
	Matrix covariance_ = Matrix::Zero();
};

} // namespace steadyhand
