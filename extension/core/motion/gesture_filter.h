#pragma once

#include "motion/hand_filter.h"
#include "motion/reference_table.h"

#include <Eigen/Core>

#include <cmath>
#include <cstdint>

namespace steadyhand {

enum class TrackerMode : std::uint8_t {
	SOUND,  ///< measures the hand's position
	LAGGING ///< has a lag that grows with the hand's progress, and a slow error
};

/// Transition over dt_s of critically damped noise, x'' = -2 a x' - a^2 x + white noise. deviation:
/// stationary standard deviation of x. a: rate_per_s.
struct DampedTransition {
	double xx, xv, vx, vv;               ///< transition matrix of [x, x']
	double noise_xx, noise_xv, noise_vv; ///< covariance that the noise adds

	DampedTransition(double deviation, double rate_per_s, double dt_s);
};

/// One hypothesis of an active gesture: an extended Kalman filter. Its state is onset, log duration, gain,
/// shape, the tracker's lag, and a slow deviation d with its velocity. With a SOUND tracker d is the hand's
/// deviation from the curve; with a LAGGING tracker it is the tracker's error.
///
///     hand(t)    = (1 + gain) f(p) + d(t)                        p = (t - onset) / duration
///     tracker(t) = (1 + gain) f(p - lag s e(p) / duration) + d(t) + noise,    f = (1 - shape) e + shape m
///
/// e: the model's reference curve. m: minimum jerk. s: fraction of the lag that builds up in the duration.
/// Positions are in amplitudes.
/// Bar-Shalom, Li, Kirubarajan 2001, section 10.3.
class GestureFilter {
public:
	/// SIZE is one more than the number of states, so that a column fills whole SIMD registers.
	enum Index : std::uint8_t {
		ONSET,
		LOG_DURATION,
		GAIN,
		SHAPE,
		LAG,
		DEVIATION,
		DEVIATION_VELOCITY,
		SIZE = 8
	};
	using Vector = Eigen::Matrix<double, SIZE, 1>;
	using Matrix = Eigen::Matrix<double, SIZE, SIZE>;

	struct Onset {
		double t_s, deviation_s;
		double log_duration, log_duration_deviation;
		double gain_deviation;
	};
	struct Prediction {
		double x = 0.0;
		double variance = 0.0;              ///< without measurement noise
		double velocity = 0.0;              ///< of the reference curve, 1/s
		Vector slope = Vector::Zero();      ///< d x / d state
		Vector covariance = Vector::Zero(); ///< between the state and x
	};
	/// Motion of the hand, without the tracker's lag and error. Amplitudes and seconds.
	struct Hand {
		double value, velocity, acceleration, phase;
	};

	double weight = 0.0;

	GestureFilter() = default;
	/// from: state of the hand at the onset, relative to the start.
	GestureFilter(TrackerMode tracker, const Onset &onset, const HandState &from);

	[[nodiscard]] TrackerMode tracker() const { return tracker_; }
	[[nodiscard]] double onset_s() const { return mean_(ONSET); }
	[[nodiscard]] double duration_s() const { return duration_s_; }
	[[nodiscard]] const Vector &mean() const { return mean_; }
	[[nodiscard]] const Matrix &covariance() const { return covariance_; }

	/// Predicts the state to t_s, dt_s after the last prediction. transition: of the deviation over dt_s.
	void predict(const DampedTransition &transition, double dt_s, double t_s);
	[[nodiscard]] Prediction predict_measurement(const ReferenceTable &curve, double t_s) const;
	/// predict_measurement(), cached until the state or t_s changes.
	const Prediction &cached_prediction(const ReferenceTable &curve, double t_s);
	/// Kalman update. Multiplies the weight by the likelihood of the reading.
	void correct(const Prediction &prediction, const ElementReading &reading);
	/// The tracker has jumped: adds the stationary variance to that of d.
	void widen_error();
	/// The hand at t_s. since_s: t_s minus the time of the last predict(). fading: exp(-rate since_s), with
	/// the rate of the deviation.
	[[nodiscard]] Hand hand(const ReferenceTable &curve, double t_s, double since_s, double fading) const;

	/// Of d: stationary standard deviation, and rate.
	[[nodiscard]] static double deviation(TrackerMode tracker) {
		return tracker == TrackerMode::SOUND ? parameters::DEVIATION : parameters::LAGGING_ERROR;
	}
	[[nodiscard]] static double deviation_rate_per_s(TrackerMode tracker) {
		return tracker == TrackerMode::SOUND ? parameters::DEVIATION_RATE_PER_S
											 : parameters::LAGGING_ERROR_RATE_PER_S;
	}

private:
	TrackerMode tracker_ = TrackerMode::SOUND;
	double duration_s_ = 1.0;
	double cached_s_ = NAN; ///< time of cached_; NAN if the state has changed since
	Prediction cached_;
	Vector mean_ = Vector::Zero();
	Matrix covariance_ = Matrix::Zero();
};

} // namespace steadyhand
