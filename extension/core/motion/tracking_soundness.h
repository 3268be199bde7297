#pragma once

#include "gesture/feature.h"
#include "motion/tracker_noise.h"
#include "motion/tracker_silence.h"
#include "motion/tracker_standstill.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {

/// How far a tracker is to be believed, judged by the motion alone, because it says little about its own
/// errors: gaps between stamps, values that repeat or stop dead, steps that no hand makes, in whichever
/// direction. Evidence fades over seconds.
class TrackingSoundness {
public:
	/// x: the motion element; place: where the hand is, from any origin that stays, always zero where the
	/// feature has no place. Both in amplitudes.
	void push(double t_s, double x, const FeaturePlace &place = FeaturePlace::Zero()) {
		fault_ = {};
		jumped_ = returned_ = strayed_ = false;
		const double frame_s = std::max(t_s - t_s_, SHORTEST_S);
		t_s_ = t_s;
		if (frames_ > 0) {
			weigh(frame_s, x, place);
		} else {
			silence_.start(t_s);
			standstill_.start(t_s, x);
			news_s_ = way_s_ = t_s;
			x_ = x;
			place_ = place;
		}
		frames_ = std::min(frames_ + 1, 2);
	}

	/// 0: nothing wrong has been seen .. 1.
	[[nodiscard]] double unsoundness() const { return 1.0 - std::exp(-evidence_.now); }
	/// The same, remembered for longer: what is known of this tracker, not of this moment.
	[[nodiscard]] double lasting_unsoundness() const { return 1.0 - std::exp(-evidence_.lasting); }
	/// Evidence that the newest frame adds, 1: as bad as a jump. Below 0 where it takes the one before back,
	/// which was a single frame elsewhere.
	[[nodiscard]] double fault() const { return fault_.now; }
	[[nodiscard]] bool frozen() const { return silence_.is_frozen(); }
	/// The newest frame shows where the hand is.
	[[nodiscard]] bool told() const { return silence_.told(); }
	/// The newest value is off the way that the ones before it were on, further than a hand can bend it.
	[[nodiscard]] bool jumped() const { return jumped_; }
	/// The newest frame is the first in a while that tells where the hand is: what it did since news_s() is
	/// not known.
	[[nodiscard]] bool returned() const { return returned_; }
	/// How much the values shake from frame to frame: standard deviation of the white noise that would do so.
	[[nodiscard]] double jitter() const { return jitter_; }
	/// Evidence of the gap since the newest frame, if none came until t_s: what fault() would then say of it.
	[[nodiscard]] double missing(double t_s) const { return frames_ > 0 ? gap_fault(t_s - t_s_) : 0.0; }
	/// When a frame last told something new; not of the newest frame while that has jumped() or returned().
	[[nodiscard]] double news_s() const { return news_s_; }

private:
	static constexpr double MEMORY_S = 1.0;
	static constexpr double LASTING_MEMORY_S = 5.0;
	static constexpr double SHORTEST_S = 1e-4;
	/// Trackers double or triple an interval every second or so while all is well (1-3 % of intervals).
	static constexpr double GAP_PERIODS = 4.0;
	static constexpr double FULL_GAP_S = 0.061; ///< a gap of this length is as bad as a jump
	/// Amplitudes: a 0.15 s drag, the fastest that is studied, peaks at 1.875 / 0.15.
	static constexpr double FASTEST_PER_S = 12.5;
	static constexpr double SMALLEST_JUMP = 0.03;
	/// And speeds up by at most 5.77 / 0.15^2 (Flash & Hogan 1985).
	static constexpr double SHARPEST_PER_S2 = 250.0;
	static constexpr double SMALLEST_BEND = 0.02;  ///< of a jump; less is the tracker's shaking
	static constexpr double SMALLEST_STRAY = 0.06; ///< in any direction: hands are not held to the way
	/// What shakes further is judged by its own noise, in standard deviations: that of a bend is 2.4, of a
	/// step 1.4. A stray counts for long: not even the tails of a circle's radius, whose noise is the
	/// posture's, are to be one.
	static constexpr double SHAKEN_BEND = 8.0;
	static constexpr double SHAKEN_STRAY = 40.0;
	static constexpr double SHAKEN_STEP = 6.0;
	/// A tracker that strays beside the way has erred; along the way it may be right.
	static constexpr double STRAY_FAULT = 0.3;
	/// A frame off the way is an outlier where the next one is so much nearer to that way than to it.
	static constexpr double NEARER = 0.5;
	static constexpr double BLIND_S = 0.05;
	static constexpr double BLIND_STEP = 0.04;
	static constexpr double FROZEN_FRAME = 0.5;
	/// White noise of deviation s bends frames by 2 s sqrt(3 / pi) in the mean.
	static constexpr double JITTER_PER_BEND = 0.5117;
	static constexpr double JITTER_SHARE = 0.05;                         ///< a frame's
	static constexpr double FIRST_PERIOD_S = 0.004, LAST_PERIOD_S = 0.1; ///< what the first interval may say

	/// The velocity that a hand would go on with.
	template <typename Velocity> struct Way {
		Velocity before_leap; ///< a leap says nothing of the hand's velocity,
		Velocity latest;      ///< but two in a row that agree do

		void go(const Velocity &velocity, bool leapt) {
			latest = velocity;
			before_leap = leapt ? before_leap : velocity;
		}
	};
	/// Of a fault, or of all so far.
	struct Evidence {
		double now = 0.0;
		double lasting = 0.0;
	};
	/// A frame from which one leapt away.
	struct Leap {
		double t_s = 0.0;
		double x = 0.0;
		FeaturePlace place = FeaturePlace::Zero();
		Evidence fault;
	};

	double t_s_ = 0.0;
	double x_ = 0.0; ///< of the newest frame that does not repeat the one before
	FeaturePlace place_ = FeaturePlace::Zero();
	TrackerSilence silence_;
	TrackerStandstill standstill_;
	TrackerNoise noise_;
	double news_s_ = 0.0;
	double period_s_ = 0.01; ///< between frames
	Evidence evidence_;
	Evidence fault_;
	double way_s_ = 0.0; ///< of the newest frame that the ways took in
	Way<double> step_way_{ 0.0, 0.0 };
	Way<FeaturePlace> place_way_{ FeaturePlace::Zero(), FeaturePlace::Zero() };
	Leap leap_;
	bool leapt_ = false; ///< the newest frame that told something did
	double jitter_ = 0.0;
	int frames_ = 0;
	bool jumped_ = false;
	bool returned_ = false;
	bool strayed_ = false; ///< as jumped_, in any direction

	[[nodiscard]] double gap_fault(double frame_s) const {
		return frame_s > GAP_PERIODS * period_s_ ? std::min(1.0, (frame_s - 2.0 * period_s_) / FULL_GAP_S)
												 : 0.0;
	}
	static double size(double step) { return std::abs(step); }
	static double size(const FeaturePlace &step) { return step.norm(); }
	/// By how much a step differs from going on.
	template <typename Step> double bend_of(const Way<Step> &way, const Step &step, double dt_s) const {
		return frames_ < 2
				? 0.0
				: std::min(size(Step(step - way.before_leap * dt_s)), size(Step(step - way.latest * dt_s)));
	}

	void weigh(double frame_s, double x, const FeaturePlace &place) {
		if (frames_ == 1) {
			period_s_ = std::clamp(frame_s, FIRST_PERIOD_S, LAST_PERIOD_S);
			silence_.expect(period_s_);
		}
		fault_.now = gap_fault(frame_s);
		Evidence taken_back;
		const bool repeats = x == x_ && place == place_;
		if (!repeats && !standstill_.stands(t_s_, x, jitter_)) {
			if (leapt_ && was_outlier(x, place)) {
				taken_back = leap_.fault;
				forget_outlier();
			}
			follow(x, place);
		} else {
			if (repeats) {
				standstill_.repeat();
			}
			silence_.repeat(t_s_);
			if (silence_.is_silent()) {
				stand();
			}
		}
		if (silence_.is_frozen()) {
			fault_.now += FROZEN_FRAME;
		}
		fault_.lasting = strayed_ ? std::max(fault_.now, 1.0) : fault_.now;
		leap_.fault = fault_;
		fault_.now -= taken_back.now;
		fault_.lasting -= taken_back.lasting;
		evidence_.now = std::max(evidence_.now * std::exp(-frame_s / MEMORY_S) + fault_.now, 0.0);
		evidence_.lasting =
				std::max(evidence_.lasting * std::exp(-frame_s / LASTING_MEMORY_S) + fault_.lasting, 0.0);
		period_s_ = TrackerSilence::followed(period_s_, frame_s);
	}

	/// A repeated value that stands for a hand, or a tracker, that does not move.
	void stand() {
		if (!silence_.is_frozen()) {
			noise_.push(0.0);
		}
		step_way_.go(0.0, false);
		place_way_.go(FeaturePlace::Zero(), false);
		way_s_ = t_s_;
		leapt_ = false;
	}

	/// The frame before was the only one off the way.
	[[nodiscard]] bool was_outlier(double x, const FeaturePlace &place) const {
		const double dt_s = t_s_ - leap_.t_s;
		const FeaturePlace place_off = place - leap_.place - place_way_.before_leap * dt_s;
		const double off = std::hypot(x - leap_.x - step_way_.before_leap * dt_s, place_off.norm());
		return off < NEARER * std::hypot(x - x_, (place - place_).norm());
	}
	/// It is as if it had not been.
	void forget_outlier() {
		x_ = leap_.x;
		place_ = leap_.place;
		way_s_ = leap_.t_s;
		step_way_.latest = step_way_.before_leap;
		place_way_.latest = place_way_.before_leap;
		standstill_.forget();
	}

	void follow(double x, const FeaturePlace &place) {
		const double dt_s = std::max(t_s_ - way_s_, SHORTEST_S);
		const double step = x - x_;
		const FeaturePlace place_step = place - place_;
		judge(dt_s, step, place_step);
		leapt_ = jumped_ || strayed_;
		leap_.t_s = way_s_;
		leap_.x = x_;
		leap_.place = place_;
		step_way_.go(step / dt_s, jumped_ || returned_);
		place_way_.go(place_step / dt_s, strayed_ || returned_);
		way_s_ = t_s_;
		if (!jumped_) {
			news_s_ = returned_ ? news_s_ : t_s_;
		}
		silence_.change(t_s_, step, place_step);
		standstill_.tell(t_s_, x, jitter_);
		x_ = x;
		place_ = place;
	}

	/// Steps: in dt_s.
	void judge(double dt_s, double step, const FeaturePlace &place_step) {
		const double bend = bend_of(step_way_, step, dt_s);
		const double stray = bend_of(place_way_, place_step, dt_s);
		if (frames_ > 1) {
			noise_.push(step - step_way_.latest * dt_s);
		}
		const bool may_shake = bend > SMALLEST_BEND || stray > SMALLEST_STRAY;
		const double noise = may_shake ? noise_.deviation() : 0.0;
		const double sharpest = SHARPEST_PER_S2 * dt_s * dt_s;
		jumped_ = bend > sharpest + std::max(SMALLEST_BEND, SHAKEN_BEND * noise);
		strayed_ = stray > sharpest + std::max(SMALLEST_STRAY, SHAKEN_STRAY * noise);
		returned_ = t_s_ - news_s_ > BLIND_S && std::abs(step) > std::max(BLIND_STEP, SHAKEN_STEP * noise);
		if (frames_ > 1) {
			const double shake = std::min(bend, std::max(SMALLEST_BEND, SHAKEN_STEP * noise));
			jitter_ += JITTER_SHARE * (JITTER_PER_BEND * shake - jitter_);
		}
		if (std::abs(step) > FASTEST_PER_S * dt_s + std::max(SMALLEST_JUMP, SHAKEN_STEP * noise)) {
			fault_.now += 1.0;
		} else if (strayed_) {
			fault_.now += STRAY_FAULT;
		}
	}
};

} // namespace steadyhand
