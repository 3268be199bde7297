#pragma once

#include <algorithm>
#include <cmath>

namespace steadyhand {

/// The motion's time at the sample that is made next. It goes on by itself, and is drawn to the time that
/// snapshots tell at no more than 2 %, so that the jitter of game frames shifts the motion by a fraction of a
/// millisecond only. What is further off is a pause, a leap or a starved thread: there it steps. Where it
/// would have to again and again, by steps alike, the motion is slower or faster than samples (slow motion),
/// and from then on so is the clock.
class MotionClock {
public:
	static constexpr double STEP_BEYOND_S = 0.05;

	void seek(double time_s) {
		rate_ = 1.0;
		last_rate_ = 0.0;
		step_to(time_s);
	}

	/// Now it should be time_s. What is no number is passed over.
	void follow(double time_s) {
		const double off_s = time_s - now_s_;
		if (!std::isfinite(time_s)) {
			return;
		}
		if (!is_set_) {
			seek(time_s);
		} else if (std::abs(off_s) > STEP_BEYOND_S) {
			learn_rate(time_s);
			step_to(time_s);
		} else {
			off_s_ = off_s;
		}
	}

	/// Its time goes on by this, which is above 0, for each second of samples, until it is told of again or
	/// advanced.
	[[nodiscard]] double pace() const {
		return off_s_ == 0.0 ? rate_ : rate_ + std::clamp(PULL_PER_S * off_s_, -MOST_PULL, MOST_PULL);
	}

	/// dt_s of samples have been made.
	void advance(double dt_s) {
		const double pace_now = pace();
		now_s_ += pace_now * dt_s;
		off_s_ -= (pace_now - rate_) * dt_s;
		made_s_ += dt_s;
	}

	[[nodiscard]] double now_s() const { return now_s_; }

private:
	static constexpr double PULL_PER_S = 2.0;
	static constexpr double MOST_PULL = 0.02;
	/// A step that comes later than this after the last one is one of its own.
	static constexpr double STEPS_APART_S = 2.0;
	/// Two steps tell one rate within this factor: frames and blocks are as long as the time between them.
	static constexpr double ALIKE = 1.5;
	static constexpr double LEAST_RATE = 0.05, MOST_RATE = 4.0;

	double now_s_ = 0.0;
	double off_s_ = 0.0;
	bool is_set_ = false;
	double rate_ = 1.0;         ///< of the motion's time to the samples'
	double last_rate_ = 0.0;    ///< as the last step told it; 0: it was one of its own
	double stepped_to_s_ = 0.0; ///< by the last step
	double made_s_ = 0.0;       ///< samples, since

	void learn_rate(double time_s) {
		const bool is_again = made_s_ > 0.0 && made_s_ <= STEPS_APART_S && time_s > stepped_to_s_;
		const double rate = is_again ? (time_s - stepped_to_s_) / made_s_ : 0.0;
		const bool is_alike = is_again && rate <= ALIKE * last_rate_ && last_rate_ <= ALIKE * rate;
		rate_ = is_alike ? std::clamp(rate, LEAST_RATE, MOST_RATE) : 1.0;
		last_rate_ = rate;
	}

	void step_to(double time_s) {
		now_s_ = stepped_to_s_ = time_s;
		off_s_ = made_s_ = 0.0;
		is_set_ = true;
	}
};

} // namespace steadyhand
