#pragma once

#include "gesture/gesture_model.h"
#include "motion/tracking_soundness.h"

#include <array>

namespace steadyhand {

/// What is believed of the motion at an instant; values in amplitudes, time in seconds.
struct PhaseEstimate {
	double value = 0.0;
	double velocity = 0.0;
	double acceleration = 0.0;
	double phase = 0.0;  ///< 0..1, expected
	double moving = 0.0; ///< probability that the gesture has begun
};

/// `phase` mode: a Gaussian-sum filter (Alspach & Sorenson 1972, doi:10.1109/TAC.1972.1100034) over when the
/// gesture began and how long it will take. Each hypothesis holds an onset, a duration and a Kalman filter of
/// three numbers:
///
///     hand(t)    = (1 + g) f((t - onset) / duration) + d        f: the model's motion elements
///     tracker(t) = hand(t - lag) + b
///
/// g: how much further or less far the hand goes than the task asks; d: what the hand does that the gesture
/// does not say (corrections, stops, reversals); b: the tracker's slow error. How a deviation is shared
/// between d and b is decided by how sound the tracking has looked: sound tracking is followed, unsound
/// tracking is weighed against what the gesture makes likely. d grows when sound frames keep contradicting
/// the gesture. docs/method.md has the equations and the numbers.
///
/// New hypotheses branch off the one at rest at a constant rate, seen or unseen, so that a gesture that
/// begins in a gap is caught when the hand is seen again. The output never steps: what a frame changes is
/// blended in, in value and in velocity. After construction nothing is allocated.
class PhaseEstimator {
public:
	/// model must outlive the estimator.
	explicit PhaseEstimator(const GestureModel &model);

	/// A frame in which the motion element was seen, x in amplitudes; t_s must not decrease.
	void push(double t_s, double x);
	/// All that is due by t_s, without a frame.
	void advance(double t_s);
	/// The gesture is over: what comes next may be another one.
	void restart();

	/// At t_s, not before the last push or advance.
	[[nodiscard]] PhaseEstimate at(double t_s) const;

private:
	static constexpr int DURATIONS = 12;
	static constexpr int KEPT = 160;

	struct Hypothesis {
		double onset_s = 0.0; ///< +infinity: at rest
		double duration_s = 1.0;
		double log_weight = 0.0;
		double g = 0.0, d = 0.0, b = 0.0;                                  ///< means
		double gg = 0.0, gd = 0.0, gb = 0.0, dd = 0.0, db = 0.0, bb = 0.0; ///< covariance
	};

	const GestureModel *model_;
	std::array<double, DURATIONS> durations_s_{};
	std::array<double, DURATIONS> log_prior_{};
	TrackingSoundness soundness_;
	std::array<Hypothesis, KEPT + DURATIONS> hypotheses_{}; ///< the first is the one at rest
	int count_ = 0;
	double filtered_s_ = 0.0; ///< the filters are at this time
	double next_branch_s_ = 0.0;
	double surprise_ = 1.0;    ///< recent mean of the normalised innovation squared, at least 1
	double blend_value_ = 0.0; ///< output minus estimate when it last changed
	double blend_velocity_ = 0.0;
	double blended_s_ = 0.0; ///< and when that was

	void begin(double t_s);
	void branch(double t_s);
	void drop_unlikely();
	[[nodiscard]] double hand_memory_s() const;
	void predict(double t_s);
	void correct(double t_s, double x);
	[[nodiscard]] PhaseEstimate expected(double t_s) const;
	/// Keeps the output where `before` had it.
	void blend_from(const PhaseEstimate &before, double t_s);
	[[nodiscard]] CurvePoint curve(const Hypothesis &hypothesis, double t_s) const;
	/// Adds one hypothesis' innovation to what is known; returns its square over its variance.
	static double absorb(Hypothesis &r_hypothesis, double f, double x);
};

} // namespace steadyhand
