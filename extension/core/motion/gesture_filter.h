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

/// A measurement of the motion element, in amplitudes, and how it is weighed.
struct ElementReading {
	double t_s = 0.0;
	double x = 0.0;
	double variance = 0.0; ///< of its white noise
	double power = 1.0;    ///< of its likelihood: how far its error is its own
};

/// Likelihood of a measurement at this distance from its prediction: a normal density mixed with an
/// outlier's.
struct ReadingLikelihood {
	double density;
	double share; ///< probability that it is no outlier

	ReadingLikelihood(double error, double variance);
	/// The factor of a covariance's reduction by the gain and its transpose: that of a mixture's moments.
	[[nodiscard]] double reduction(double error, double variance) const {
		return share * (variance - (1.0 - share) * error * error);
	}
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
	enum Index : std::uint8_t { ONSET, LOG_DURATION, GAIN, SHAPE, LAG, DEVIATION, DEVIATION_RATE, SIZE };
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
		double phase = 0.0;                 ///< as the tracker shows it
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
	[[nodiscard]] double duration_s() const { return std::exp(mean_(LOG_DURATION)); }
	[[nodiscard]] const Vector &mean() const { return mean_; }
	[[nodiscard]] const Matrix &covariance() const { return covariance_; }

	/// dt_s: to t_s, from the last time; transition: of its deviation.
	void predict(const DampedTransition &transition, double dt_s, double t_s);
	[[nodiscard]] Prediction measured(const ReferenceTable &curve, double t_s) const;
	/// Takes in a reading; the weight becomes what the hypothesis and it are worth together.
	void correct(const Prediction &prediction, const ElementReading &reading);
	/// The tracker has jumped: of its error nothing is known.
	void forget_error(double deviation);
	/// At t_s, the deviation faded since from_s, the time that it was predicted to.
	[[nodiscard]] Hand hand(const GestureModel &model, double from_s, double t_s) const;

	/// Standard deviation of the deviation where the curve is at `gone`.
	[[nodiscard]] static double deviation(TrackerMode tracker, double gone);
	[[nodiscard]] static double deviation_rate_per_s(TrackerMode tracker);

private:
	TrackerMode tracker_ = TrackerMode::SOUND;
	Vector mean_ = Vector::Zero();
	Matrix covariance_ = Matrix::Zero();
};

} // namespace steadyhand
