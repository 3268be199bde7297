#pragma once

#include "gesture/feature.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace steadyhand {

/// How far a tracker is to be believed, judged by the motion alone, because it says little about its own
/// errors: gaps between stamps, values that repeat to the last bit, steps that no hand makes, in whichever
/// direction. Evidence fades over seconds.
class TrackingSoundness {
public:
	/// x: the motion element; place: where the hand is, from any origin that stays, always zero where the
	/// feature has no place. Both in amplitudes.
	void push(double t_s, double x, const FeaturePlace &place = FeaturePlace::Zero()) {
		fault_ = 0.0;
		jumped_ = returned_ = strayed_ = false;
		if (frames_ > 0) {
			weigh(std::max(t_s - t_s_, SHORTEST_S), t_s, x, place);
		} else {
			news_s_ = t_s;
		}
		t_s_ = t_s;
		x_ = x;
		place_ = place;
		frames_ = std::min(frames_ + 1, 2);
	}

	/// 0: nothing wrong has been seen .. 1.
	[[nodiscard]] double unsoundness() const { return 1.0 - std::exp(-evidence_); }
	/// The same, remembered for longer: what is known of this tracker, not of this moment.
	[[nodiscard]] double lasting_unsoundness() const { return 1.0 - std::exp(-lasting_evidence_); }
	/// Evidence that the newest frame adds, 1: as bad as a jump.
	[[nodiscard]] double fault() const { return fault_; }
	/// The tracker repeats itself: the value stands still to the last bit although the hand was on its way,
	/// or although it had been trembling as every hand and sensor does. Exact stillness of a track that never
	/// trembled is rest.
	[[nodiscard]] bool frozen() const {
		return repeats_ >= FROZEN_REPEATS &&
				(std::abs(speed_) > RESTING_PER_S || std::popcount(turns_) >= TREMBLING_TURNS);
	}
	/// The newest value is off the way that the ones before it were on, further than a hand can bend it.
	[[nodiscard]] bool jumped() const { return jumped_; }
	/// The newest frame is the first in a while that tells where the hand is: what it did since news_s() is
	/// not known.
	[[nodiscard]] bool returned() const { return returned_; }
	/// How much the values shake from frame to frame: standard deviation of the white noise that would do so.
	[[nodiscard]] double jitter() const { return jitter_; }
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
	static constexpr double SMALLEST_BEND = 0.02;
	static constexpr double SMALLEST_STRAY = 0.06; ///< in any direction: hands are not held to the way
	/// A tracker that strays beside the way has erred; along the way it may be right.
	static constexpr double STRAY_FAULT = 0.3;
	static constexpr int FROZEN_REPEATS = 2;
	static constexpr double BLIND_S = 0.05;
	static constexpr double BLIND_STEP = 0.04;
	static constexpr double RESTING_PER_S = 0.25;
	static constexpr int TREMBLING_TURNS = 3;  ///< of the last 16 steps, those against the one before
	static constexpr double SPEED_SHARE = 0.4; ///< a frame's share in the recent speed
	static constexpr double FROZEN_FRAME = 0.5;
	/// White noise of deviation s bends frames by 2 s sqrt(3 / pi) in the mean.
	static constexpr double JITTER_PER_BEND = 0.5117;
	static constexpr double JITTER_SHARE = 0.05;  ///< a frame's
	static constexpr double LARGEST_SHAKE = 0.02; ///< a bend beyond is a jump's
	/// The period follows a sensor that slows down within some frames, and a burst of frames slowly.
	static constexpr double PERIOD_GROWTH = 1.2;
	static constexpr double PERIOD_SHARE = 0.1;
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

	double t_s_ = 0.0;
	double x_ = 0.0;
	FeaturePlace place_ = FeaturePlace::Zero();
	double news_s_ = 0.0;
	double period_s_ = 0.01;
	double evidence_ = 0.0;
	double lasting_evidence_ = 0.0;
	double fault_ = 0.0;
	double speed_ = 0.0; ///< of steps that are news, smoothed
	Way<double> step_way_{ 0.0, 0.0 };
	Way<FeaturePlace> place_way_{ FeaturePlace::Zero(), FeaturePlace::Zero() };
	double step_ = 0.0;
	double jitter_ = 0.0;
	std::uint16_t turns_ = 0;
	int repeats_ = 0;
	int frames_ = 0;
	bool jumped_ = false;
	bool returned_ = false;
	bool strayed_ = false; ///< as jumped_, in any direction

	static double size(double step) { return std::abs(step); }
	static double size(const FeaturePlace &step) { return step.norm(); }
	/// By how much a step differs from going on.
	template <typename Step> double bend_of(const Way<Step> &way, const Step &step, double dt_s) const {
		return frames_ < 2
				? 0.0
				: std::min(size(Step(step - way.before_leap * dt_s)), size(Step(step - way.latest * dt_s)));
	}

	void weigh(double dt_s, double t_s, double x, const FeaturePlace &place) {
		const double step = x - x_;
		const FeaturePlace place_step = place - place_;
		const double bend = bend_of(step_way_, step, dt_s);
		const double stray = bend_of(place_way_, place_step, dt_s);
		const double sharpest = SHARPEST_PER_S2 * dt_s * dt_s;
		jumped_ = bend > sharpest + SMALLEST_BEND;
		strayed_ = stray > sharpest + SMALLEST_STRAY;
		returned_ = t_s - news_s_ > BLIND_S && std::abs(step) > BLIND_STEP;
		if (frames_ > 1 && step != 0.0) {
			jitter_ += JITTER_SHARE * (JITTER_PER_BEND * std::min(bend, LARGEST_SHAKE) - jitter_);
		}
		step_way_.go(step / dt_s, jumped_ || returned_);
		place_way_.go(place_step / dt_s, strayed_ || returned_);

		if (frames_ == 1) {
			period_s_ = std::clamp(dt_s, FIRST_PERIOD_S, LAST_PERIOD_S);
		}
		if (dt_s > GAP_PERIODS * period_s_) {
			fault_ += std::min(1.0, (dt_s - 2.0 * period_s_) / FULL_GAP_S);
		}
		if (std::abs(step) > FASTEST_PER_S * dt_s + SMALLEST_JUMP) {
			fault_ += 1.0;
		} else if (strayed_) {
			fault_ += STRAY_FAULT;
		}
		if (step == 0.0) {
			repeats_ = std::min(repeats_ + 1, FROZEN_REPEATS);
		} else {
			repeats_ = 0;
			if (!jumped_) {
				news_s_ = returned_ ? news_s_ : t_s;
			}
			speed_ += SPEED_SHARE * (step / dt_s - speed_);
			turns_ = static_cast<std::uint16_t>((turns_ << 1U) | (step * step_ < 0.0 ? 1U : 0U));
			step_ = step;
		}
		if (frozen()) {
			fault_ += FROZEN_FRAME;
		}
		evidence_ = evidence_ * std::exp(-dt_s / MEMORY_S) + fault_;
		lasting_evidence_ = lasting_evidence_ * std::exp(-dt_s / LASTING_MEMORY_S) +
				(strayed_ ? std::max(fault_, 1.0) : fault_);
		period_s_ = dt_s > period_s_ ? std::min(period_s_ * PERIOD_GROWTH, dt_s)
									 : period_s_ + PERIOD_SHARE * (dt_s - period_s_);
	}
};

} // namespace steadyhand
