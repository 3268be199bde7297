#pragma once

#include "base/parameters.h"
#include "motion/estimator_effort.h"
#include "motion/gesture_filter.h"
#include "motion/output_blend.h"
#include "tracking/measurement.h"

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace steadyhand {

/// The motion at an instant; values in amplitudes, time in seconds.
struct MotionEstimate {
	double value = 0.0;
	double velocity = 0.0;
	double acceleration = 0.0;
	double phase = 0.0;      ///< 0..1, expected
	double gesture = 0.0;    ///< probability that the hand makes the gesture, or has just made it
	double remaining = 0.0;  ///< phase that the gesture still has, expected; 0 of a hand that makes none
	double hold = 0.0;       ///< probability that it holds still, or rests
	double correction = 0.0; ///< part of the acceleration that hides what a frame changed
};

/// `phase` mode: a switching Kalman filter (Bar-Shalom, Li, Kirubarajan 2001, chapter 11) over what the hand
/// does, HOLD, FREE or the gesture, and over the tracker, which is sound or lags. HOLD and FREE are one
/// filter each; the gesture is a Gaussian sum (Alspach & Sorenson 1972, doi:10.1109/TAC.1972.1100034) over
/// when it began and how long it takes. The output is the mean of all.
///
/// Of a faulty tracker only its rates of faults are known: they are likelier before one that lags. Frames
/// that TrackerMonitor takes for outliers or repetitions change nothing else.
///
/// Allocates when made.
class SwitchingEstimator {
public:
	/// amplitude_m: of the task. latency_s: how old what a frame shows
	/// always is; the estimate is that much ahead of the frames. gain_spread: standard deviation of how far
	/// hands go, amplitudes.
	SwitchingEstimator(const GestureModel &model, double amplitude_m, const EstimatorEffort &effort = {},
			double latency_s = 0.0, double gain_spread = parameters::GAIN_SPREAD);

	/// A frame; stamps must not decrease. x: the motion element, amplitudes.
	void push(const Measurement &measurement, double x);
	/// No frame came until t_s. is_overdue: one should have.
	void wait(double t_s, bool is_overdue);
	/// Forgets all gestures; the hand holds where it is. shift: added to x from now on.
	void restart(double t_s, double shift = 0.0);
	/// As made.
	void reset();
	/// The same, but for a frame of a hand that is not followed: it tells how fast that is where it is
	/// followed next.
	void pass_over(double t_s, double x);

	/// At t_s, not before the last frame.
	[[nodiscard]] MotionEstimate at(double t_s) const;
	/// The same without what is blended in of the last change.
	[[nodiscard]] MotionEstimate expected(double t_s) const;

private:
	static constexpr double NEVER_S = -std::numeric_limits<double>::infinity();

	/// A hand that follows no curve.
	struct Other {
		double weight = 0.0;
		double lagging = parameters::LAGGING_SHARE; ///< probability that its tracker lags
		HandState hand;

		/// The tracker did something that is `factor` times as likely of a sound one as of one that lags.
		void judge_tracker(double factor) {
			const double likelihood = (1.0 - lagging) * factor + lagging;
			weight *= likelihood;
			lagging /= likelihood;
		}
	};

	ReferenceTable curve_;
	double amplitude_m_;
	EstimatorEffort effort_;
	double latency_s_;
	double gain_spread_;
	HandProcess hold_process_, free_process_;
	std::array<double, EstimatorEffort::MOST_DURATIONS> log_durations_{}, duration_weights_{};
	double log_duration_deviation_ = 0.0;

	/// State after the measurements so far.
	struct Belief {
		double time_s = NEVER_S;                     ///< that all are predicted to
		double seen_s = NEVER_S;                     ///< when a measurement last said where the hand is
		double changed_s = NEVER_S, changed_x = 0.0; ///< and when one last said something new
		double next_birth_s = 0.0;
		Other hold, free;
		std::vector<GestureFilter> gestures;
		double log_fault = 0.0; ///< evidence of the fault that goes on; 0: none does
		double faulty_latency_s = 0.0;
	};
	Belief now_;
	bool is_last_used_ = true; ///< the newest usable measurement, or the one that it replaces
	Belief before_last_;       ///< before the newest usable measurement
	double passed_s_ = NEVER_S, passed_x_ = 0.0; ///< the last frame that was passed over
	OutputBlend blend_;
	double acceleration_step_ = 0.0; ///< of the last change

	/// The mean of the hypotheses is evaluated at knots from the last change on, when it is asked for, and
	/// kept: an output each millisecond is a quintic between two of them.
	static constexpr double KNOT_S = 0.01;
	struct Knot {
		double number = -1.0; ///< after the last change; -1: not evaluated
		MotionEstimate mean;
	};
	double mean_s_ = 0.0; ///< of knot 0
	mutable std::array<Knot, 2> knots_;

	[[nodiscard]] MotionEstimate mean(double t_s) const;
	[[nodiscard]] const MotionEstimate &knot(double number) const;
	void start_knots(double t_s);
	[[nodiscard]] bool has_hand() const { return now_.time_s > NEVER_S; }
	void begin(double t_s, double x, double v);
	void predict(double t_s);
	void step(double t_s);
	void switch_modes(double dt_s);
	void judge_tracker(double log_ratio);
	void count_fault(bool is_jump);
	void give_birth(double t_s);
	void seed(const ElementReading &reading, double gap_s);
	void add(TrackerMode tracker, double weight, const GestureFilter::Onset &onset, const HandState &from);
	void correct(const ElementReading &reading, std::size_t count);
	void normalise();
	void prune();
	[[nodiscard]] double nearness(TrackerMode tracker) const;
	template <class Change> void change(double t_s, Change apply);
};

} // namespace steadyhand
