#pragma once

#include "gesture/gesture_model.h"

#include <Eigen/Core>

#include <cstdint>

namespace steadyhand {

/// What a hypothesis holds of the hand and of the tracker.
enum class Regime : std::uint8_t {
	REST,    ///< the hand has not begun
	SOUND,   ///< the hand makes the gesture, the tracker is right
	UNSOUND, ///< the hand makes the gesture; the tracker errs and is late, the more the further the hand is
	FREE,    ///< the hand does something else, the tracker is right
};

/// How far a deviation goes and how it comes back: critically damped noise.
struct Deviation {
	double amplitudes; ///< standard deviation
	double rate_per_s;
};

/// A regime's numbers (docs/method.md says how they were set); values in amplitudes.
struct RegimeNumbers {
	Deviation hand;      ///< d: what the hand does that the gesture does not say
	Deviation error;     ///< b: the tracker's slow error, at the start of the way
	double error_on_way; ///< b: standard deviation added at the end of the way
	double lag_s;        ///< expected lag at the end of the way
	double lag_deviation_s;
	double gain_deviation; ///< g: how much further or less far than the task asks
};
[[nodiscard]] const RegimeNumbers &regime_numbers(Regime regime);

/// One way in which the frames may have come about: an extended Kalman filter (Bar-Shalom, Li, Kirubarajan
/// 2001) of
///
///     hand(t)    = (1 + g) f(p) + d(t),   p = (t - onset) / duration
///     tracker(t) = (1 + g) f(p - lag f(p) / duration) + d(t) + b(t) + noise
///     f          = (1 - shape) e + shape m;   e: the model's motion elements, m: minimum jerk
///
/// over the state (onset, log duration, lag, g, shape, d, d', b, b'). At rest there is no onset, and f = 0.
class GestureHypothesis {
public:
	/// A frame's place in the evidence.
	struct Trust {
		double outlier = 0.01; ///< probability that the frame says little of the hand
		double weight = 1.0; ///< part of its likelihood that counts, since errors of frames nearby are alike
	};

	struct Hand {
		double value = 0.0, velocity = 0.0, acceleration = 0.0; ///< amplitudes, seconds
		double phase = 0.0;                                     ///< 0..1
	};

	double log_weight = 0.0;

	/// At rest, d from where it should be.
	static GestureHypothesis resting(double d);
	/// The same hand and tracker, on its way since onset_s; deviations: standard.
	[[nodiscard]] GestureHypothesis begun(Regime regime, double onset_s, double onset_deviation_s,
			double log_duration, double log_duration_deviation) const;
	/// The same hand and tracker from now on in another regime.
	[[nodiscard]] GestureHypothesis in(Regime regime) const;

	void predict(const GestureModel &model, double t_s, double dt_s);
	/// Takes in that x was seen at t_s, the time predicted to, and weighs itself by how likely that was
	/// (probabilistic data association: a frame is good, or an outlier).
	void absorb(const GestureModel &model, double t_s, double x, const Trust &trust);
	/// At t_s, not before filtered_s, the time predicted to.
	[[nodiscard]] Hand hand(const GestureModel &model, double t_s, double filtered_s) const;

	[[nodiscard]] bool on_its_way() const { return on_its_way_; }
	[[nodiscard]] Regime regime() const { return regime_; }
	/// d: what the hand does beside the gesture.
	[[nodiscard]] double hand_deviation() const { return mean_[HAND]; }

private:
	enum : Eigen::Index { ONSET, LOG_DURATION, LAG, GAIN, SHAPE, HAND, HAND_RATE, ERROR, ERROR_RATE, STATES };
	using State = Eigen::Matrix<double, STATES, 1>;
	using Covariance = Eigen::Matrix<double, STATES, STATES>;

	State mean_ = State::Zero();
	Covariance covariance_ = Covariance::Zero();
	Regime regime_ = Regime::REST;
	bool on_its_way_ = false;

	void begin_at(Eigen::Index i, double mean, double deviation);
	void damp(Eigen::Index i, const Deviation &noise, double dt_s);
	[[nodiscard]] CurvePoint curve(const GestureModel &model, double phase) const;
	[[nodiscard]] double way(const GestureModel &model, double phase) const;
	/// What the tracker should show at t_s; r_slopes: by how much it changes with each state.
	double expected(const GestureModel &model, double t_s, State &r_slopes) const;
};

} // namespace steadyhand
