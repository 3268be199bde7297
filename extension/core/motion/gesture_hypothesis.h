#pragma once

#include "motion/element_curve.h"
#include "motion/regime.h"

#include <Eigen/Core>

namespace steadyhand {

/// One way in which the frames may have come about: an extended Kalman filter (Bar-Shalom, Li, Kirubarajan
/// 2001) of
///
///     hand(t)    = (1 + g) f(p) + d(t),   p = (t - onset) / duration
///     tracker(t) = (1 + g) f(p - lag f(p) / duration) + d(t) + b(t) + noise
///     f          = (1 - shape) e + shape m;   e: the model's motion elements, m: minimum jerk
///
/// over the state (d, d', b, b', onset, log duration, g, shape, lag). At rest there is no onset, and f = 0:
/// the filter is of the first four alone; and of the first eight where there is no lag.
class GestureHypothesis {
public:
	/// A frame's place in the evidence.
	struct Trust {
		double outlier = 0.01; ///< probability that the frame says little of the hand
		double jitter = 0.0;   ///< standard deviation that its noise has beside the least that any has
		double weight = 1.0; ///< part of its likelihood that counts, since errors of frames nearby are alike
	};

	/// Of a hand that makes the gesture: (1 + g) f((t - onset_s) * rate_per_s)
	struct Course {
		double onset_s, rate_per_s, gain, shape; ///< gain: 1 + g
	};

	double log_weight = 0.0;
	double weight = 1.0; ///< exp(log_weight) when that was last made relative (HypothesisBank)

	/// At rest, d from where it should be.
	static GestureHypothesis resting(double d);
	/// The same hand and tracker, on its way since onset_s; deviations: standard.
	[[nodiscard]] GestureHypothesis begun(Regime regime, double onset_s, double onset_deviation_s,
			double log_duration, double log_duration_deviation) const;
	/// The same hand and tracker from now on in another regime.
	[[nodiscard]] GestureHypothesis in(Regime regime) const;

	/// The same, but that the tracker has jumped: it shows the hand beside where it is from now on.
	[[nodiscard]] GestureHypothesis displaced(double deviation) const;
	/// The tracker's error is as if nothing were known of it.
	void forget_error();

	/// passages: over the time from the one predicted to before.
	void predict(const ElementCurve &curve, double t_s, const Passages &passages);
	/// Takes in that x was seen at t_s, the time predicted to, and weighs itself by how likely that was
	/// (probabilistic data association: a frame is good, or an outlier).
	void absorb(const ElementCurve &curve, double t_s, double x, const Trust &trust);

	[[nodiscard]] bool on_its_way() const { return on_its_way_; }
	[[nodiscard]] Regime regime() const { return regime_; }
	/// Only of one on its way.
	[[nodiscard]] Course course() const {
		return { mean_[ONSET], rate_per_s_, 1.0 + mean_[GAIN], mean_[SHAPE] };
	}
	/// d: what the hand does beside the gesture, and d'.
	[[nodiscard]] double hand_deviation() const { return mean_[HAND]; }
	[[nodiscard]] double hand_deviation_rate() const { return mean_[HAND_RATE]; }

private:
	enum : Eigen::Index {
		HAND,
		HAND_RATE,
		ERROR,
		ERROR_RATE,
		ONSET,
		LOG_DURATION,
		GAIN,
		SHAPE,
		LAG,
		UNUSED,
		STATES
	};
	static constexpr Eigen::Index DAMPED = ONSET; ///< the states before it
	/// How many of the states may differ from zero. Even numbers, which processors compute in pairs.
	enum class Extent : std::uint8_t { AT_REST = 4, WITHOUT_LAG = 8, ALL = 10 };
	// Unaligned, so that the classes that hold it may be allocated anywhere.
	using State = Eigen::Matrix<double, STATES, 1, Eigen::DontAlign>;
	using Covariance = Eigen::Matrix<double, STATES, STATES, Eigen::DontAlign>;

	State mean_ = State::Zero();
	Covariance covariance_ = Covariance::Zero();
	double rate_per_s_ = 1.0; ///< exp(-log duration)
	Extent extent_ = Extent::AT_REST;
	Regime regime_ = Regime::REST;
	bool on_its_way_ = false;

	void begin_at(Eigen::Index i, double mean, double deviation);
	void begin_error();
	template <int N> void predict_first(double error_variance, const Passage &passage);
	template <int N> void absorb_first(double innovation, const State &slopes, const Trust &trust);
	/// f(phase) in 0..1
	[[nodiscard]] double way(const ElementCurve &curve, double phase) const;
	/// What the tracker should show at t_s; r_slopes: by how much it changes with each state.
	double expected(const ElementCurve &curve, double t_s, State &r_slopes) const;
};

} // namespace steadyhand
