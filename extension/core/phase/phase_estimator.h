#pragma once

#include "gesture/gesture_model.h"
#include "motion/output_blend.h"
#include "phase/element_curve.h"
#include "phase/fault_evidence.h"
#include "phase/frame_bursts.h"
#include "phase/halted_hand.h"
#include "phase/hypothesis_bank.h"
#include "phase/hypothesis_births.h"
#include "phase/motion_outlook.h"
#include "soundness/rest_wander.h"
#include "soundness/tracking_soundness.h"

#include <cmath>
#include <limits>

namespace steadyhand {

/// `phase` mode: a Gaussian sum (Alspach & Sorenson 1972, doi:10.1109/TAC.1972.1100034) of hypotheses about
/// when the gesture began, how long it takes, and in which regime hand and tracker are; each is an extended
/// Kalman filter of its own (gesture_hypothesis.h). What is put out is their weighted mean.
///
/// - Hypotheses branch off the one at rest at a constant rate while the hand is seen, and are seeded from
///   what is seen when the tracker comes back from a gap, a freeze or a jump, between the frames of a slow
///   camera, or where a frame was where none had expected the hand: a gesture that begins unseen is caught.
/// - A jump is the tracker's: it may lead away from the hand or back to it (tracker_jump.h).
/// - Faults of the tracker (tracking_soundness.h) speak for the regime in which it errs.
/// - The output never steps: what a frame changes is blended in, in value and in velocity.
///
/// docs/method.md has the equations and the numbers. After construction nothing is allocated.
class PhaseEstimator {
public:
	/// model must outlive the estimator. latency_s: how old what a frame shows always is; the estimate is
	/// that much ahead of the frames. gain_spread: how many times as freely as with a task a hand may go
	/// further than 1, or less far. knows_end: there is something at 1 that hands go to.
	explicit PhaseEstimator(const GestureModel &model, const PhaseEffort &effort = {}, double latency_s = 0.0,
			double gain_spread = 1.0, bool knows_end = true);

	/// A frame in which the motion element x was seen; t_s must not decrease. place: as TrackingSoundness
	/// takes it. In amplitudes.
	void push(double t_s, double x, const FeaturePlace &place = FeaturePlace::Zero());
	/// Of frames that come in bursts the newest of each is used: the one that is due by t_s.
	void release(double t_s);
	/// The same of frames of the past, for half of the cost: until catch_up() at() does not know of them, and
	/// changes without a transition then.
	/// False where it is passed over: it comes too soon after the last one.
	bool recall(double t_s, double x, const FeaturePlace &place);
	void catch_up() { look(now_.filtered_s); }
	/// The same of a hand that is not followed: the tracker is judged, for a thirtieth of the cost, at() is
	/// 0, and the next push() finds the hand as a first one does.
	void doze(double t_s, double x, const FeaturePlace &place);
	/// No frame came until t_s: one that should have is a fault already while it is missing.
	void wait(double t_s);
	/// The gesture is over at t_s, not before the last frame: what comes next may be another one. shift: what
	/// was x is x + shift from now on.
	void restart(double t_s, double shift = 0.0);
	/// As made: nothing of what was seen connects with what comes next.
	void reset() {
		forget_hand();
		soundness_ = {};
		rest_ = {};
		wanders_to_ = 0.0;
		absorbed_s_ = NEVER_S;
		falling_behind_s_ = 0.0;
	}

	/// At t_s, not before the last push.
	[[nodiscard]] PhaseEstimate at(double t_s) const;
	/// The same without what is blended in of the last change.
	[[nodiscard]] PhaseEstimate expected(double t_s) const;

private:
	static_assert(HypothesisBank::MOST_AFTER_PRUNE + PhaseEffort::MOST_WANDERING + 2 +
							HypothesisBank::MOST_SLIDING_BACK + 2 * PhaseEffort::MOST_DURATIONS <=
					HypothesisBank::MOST_ADDED,
			"a frame may set one free; a jump doubles each, trebles those that are free and on a way, lets "
			"some slide back, and seeds; a branching adds fewer");

	static constexpr double NEVER_S = -std::numeric_limits<double>::infinity();

	/// What the frames so far say of the hand.
	struct Belief {
		HypothesisBank bank{ PhaseEffort{} };
		HaltedHand halted{};
		LossCount loss{};
		double filtered_s = 0.0;  ///< the filters are at this time
		double back_s = INFINITY; ///< by then a tracker that slides back from a jump is back
		double seen_s = 0.0;      ///< the hand was last, by a tracker that is not frozen
		double told_s = NEVER_S;  ///< a frame last told where the hand is
		double told_x = 0.0;      ///< where that was
		double next_branch_s = 0.0;
		double branched_s = 0.0; ///< told_s at the last branching of one that stands
		double branched_x = 0.0; ///< and told_x
		double missing = 0.0;    ///< fault of the gap since the last frame that has been counted
		int surprises = 0;       ///< the last frames that told something, which none of them expected
	};

	/// What was believed before a frame that leapt off the way: if the tracker is back on it soon, it is
	/// again.
	struct BeforeLeap {
		double leap_s = NEVER_S; ///< when that was
		double leap = 0.0;       ///< how far
		double fault = 0.0;      ///< that it had
		Belief belief{};
	};

	ElementCurve curve_;
	HypothesisBirths births_;
	double branch_period_s_;
	double latency_s_;
	bool knows_end_;
	double falling_behind_s_ = 0.0; ///< latency beyond that, of a tracker that has erred
	TrackingSoundness soundness_;
	RestWander rest_;         ///< of what is shown near the start
	double wanders_to_ = 0.0; ///< what is shown no further than this may be at rest
	Belief now_;
	BeforeLeap before_leap_;
	MotionOutlook outlook_;       ///< of the bank
	double absorbed_s_ = NEVER_S; ///< when a frame was last used
	FrameBursts bursts_;
	OutputBlend blend_;              ///< of what the last change of the estimate would step by
	double acceleration_step_ = 0.0; ///< the same of the acceleration

	void begin(double t_s, double d, double velocity);
	void forget_hand();
	void judge(double t_s, double x, const FeaturePlace &place);
	void use(const FrameBursts::Frame &frame, double t_s);
	void look(double t_s) {
		outlook_.look(now_.bank, curve_, t_s, ahead_s(), now_.seen_s, mistaken(), now_.halted.is_halted(),
				wanders_to_);
	}
	/// How far a free hand that is shown beside the end may be at it, as the tracker has erred.
	[[nodiscard]] double mistaken() const { return knows_end_ ? soundness_.lasting_unsoundness() : 0.0; }
	void branch_until(double t_s);
	void prune();
	[[nodiscard]] bool jumps_back(double t_s, double x) const;
	void weigh(double t_s, double x);
	void absorb(double t_s, double x, double fault, bool jumps);
	void count_lost();
	[[nodiscard]] bool has_set_out_unseen(double step_s, double x) const;
	void count_frame(double t_s, double dt_s, double shown_dt_s, double x, double fault, bool jumps);
	/// What a frame shows is so old.
	[[nodiscard]] double ahead_s() const { return latency_s_ + falling_behind_s_; }
	/// Keeps the output where `before` had it.
	void blend_from(const PhaseEstimate &before, double t_s);
};

} // namespace steadyhand
