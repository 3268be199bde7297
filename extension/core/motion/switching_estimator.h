#pragma once

#include "base/parameters.h"
#include "motion/gesture_filter.h"
#include "motion/output_blend.h"
#include "motion/quality.h"
#include "tracking/measurement.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace steadyhand {

/// Estimated motion at one instant, in amplitudes and seconds.
struct MotionEstimate {
	double value = 0.0;
	double velocity = 0.0;
	double acceleration = 0.0;
	double phase = 0.0;      ///< mean phase, 0..1
	double gesture = 0.0;    ///< probability of GESTURE from VISIBLE_PHASE on, its end included
	double remaining = 0.0;  ///< mean of 1 - phase, with 0 for HOLD and FREE
	double hold = 0.0;       ///< probability that the hand rests: HOLD, or GESTURE below VISIBLE_PHASE
	double correction = 0.0; ///< part of the acceleration that only blends the last correction
};

/// `phase` mode: a switching Kalman filter (Bar-Shalom, Li, Kirubarajan 2001, chapter 11). Modes of the hand:
/// HOLD, FREE, GESTURE. Modes of the tracker: SOUND, LAGGING. HOLD and FREE are one filter each. GESTURE is a
/// Gaussian sum (Alspach & Sorenson 1972, doi:10.1109/TAC.1972.1100034) over onset and duration. The output
/// is the weighted mean of all.
///
/// LAGGING trackers have faults more often than SOUND ones, so faults are evidence of LAGGING. Frames with
/// outliers and repetitions give only this evidence.
///
/// Only the constructor allocates.
class SwitchingEstimator {
public:
	/// amplitude_m: of the task. hypotheses: most GESTURE hypotheses, 2..MOST_HYPOTHESES. latency_s: the
	/// tracker's; the estimate is this far ahead of the frames. gain_spread: standard deviation of the
	/// endpoint, amplitudes.
	SwitchingEstimator(const GestureModel &model, double amplitude_m,
			std::size_t hypotheses = DEFAULT_HYPOTHESES, double latency_s = 0.0,
			double gain_spread = parameters::GAIN_SPREAD);

	/// Adds a frame. Stamps must not decrease. x: the motion element, amplitudes.
	void push(const Measurement &measurement, double x);
	/// Predicts to t_s without a frame. is_overdue: the tracker should have sent one (dropout).
	void wait(double t_s, bool is_overdue);
	/// Drops all gestures: the hand is in HOLD or FREE at its position. shift: added to this position.
	void restart(double t_s, double shift = 0.0);
	/// Resets to the state after construction.
	void reset();
	/// reset(), for a frame that is not estimated. If the next push() follows soon, both frames together give
	/// the initial velocity.
	void reset_at(double t_s, double x);

	/// Estimate at t_s, which must not be before the last frame.
	[[nodiscard]] MotionEstimate at(double t_s) const;
	/// at(), without the blend of the last change.
	[[nodiscard]] MotionEstimate unblended(double t_s) const;

private:
	static constexpr double NEVER_S = -std::numeric_limits<double>::infinity();

	/// HOLD or FREE: a hand that follows no curve.
	struct CurvelessMode {
		double weight = 0.0;
		double lagging = parameters::LAGGING_SHARE; ///< probability of LAGGING in this mode
		HandState hand;

		/// Applies evidence on the tracker mode. factor: P(event | SOUND) / P(event | LAGGING).
		void update_tracker_modes(double factor) {
			const double likelihood = (1.0 - lagging) * factor + lagging;
			weight *= likelihood;
			lagging /= likelihood;
		}
	};

	ReferenceTable curve_;
	double amplitude_m_;
	std::size_t hypotheses_;
	double latency_s_;
	double gain_spread_;
	HandProcess hold_process_, free_process_;
	static constexpr std::size_t DURATIONS = 5; ///< of new hypotheses
	std::array<double, DURATIONS> log_durations_{}, duration_weights_{};
	double log_duration_deviation_ = 0.0;

	/// State after the measurements so far.
	struct Belief {
		double time_s = NEVER_S;     ///< all filters are predicted to this time
		double measured_s = NEVER_S; ///< last used measurement
		double changed_s = NEVER_S;  ///< last used measurement with another value than the one before
		double changed_x = 0.0;      ///< its value
		double next_birth_s = 0.0;
		CurvelessMode hold, free;
		std::vector<GestureFilter> gestures;
		double log_fault = 0.0;   ///< evidence of the present fault, nats; 0: no fault
		bool has_faulted = false; ///< a LAGGING tracker is then later by FAULTY_LATENCY_S
	};
	Belief now_;
	bool is_last_used_ = true; ///< the newest usable measurement is far enough in time from the one before
	/// After the newest usable measurement and the one before it. A burst counts as one measurement.
	std::array<Belief, 2> after_;
	double reset_s_ = NEVER_S, reset_x_ = 0.0; ///< last frame of reset_at()
	OutputBlend blend_;
	double acceleration_step_ = 0.0; ///< step of the acceleration at the last change

	/// Result of the last unblended(), and its time; NAN after a change.
	mutable MotionEstimate cached_;
	mutable double cached_s_ = NAN;

	[[nodiscard]] MotionEstimate mean(double t_s) const;
	[[nodiscard]] bool has_hand() const { return now_.time_s > NEVER_S; }
	/// Began after the last measurement.
	[[nodiscard]] bool is_unseen(const GestureFilter &gesture) const {
		return gesture.onset_s() > now_.measured_s;
	}
	void begin(double t_s, double x, double v);
	void predict(double t_s);
	void step(double t_s);
	void switch_modes(double dt_s);
	void update_tracker_modes(double log_ratio);
	void count_jump();
	bool count_fault(double log_ratio);
	void spawn_gestures(double t_s);
	void spawn_unseen_gestures(const ElementReading &reading, double gap_s);
	void add(TrackerMode tracker, double weight, const GestureFilter::Onset &onset, const HandState &from);
	void correct(const ElementReading &reading, std::size_t count);
	void normalise();
	void prune();
	[[nodiscard]] double start_likelihood(TrackerMode tracker) const;
	template <class Change> void change(double t_s, Change apply);
};

} // namespace steadyhand
