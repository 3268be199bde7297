#pragma once

#include <algorithm>
#include <cmath>

namespace steadyhand {

/// The motion's time at the sample that is made next. It goes on by itself, and is drawn to the time that
/// snapshots tell at no more than 2 %, so that the jitter of game frames shifts the motion by a fraction of a
/// millisecond only. What is further off is a pause, a leap or a starved thread: there it steps.
class MotionClock {
public:
	static constexpr double STEP_BEYOND_S = 0.05;

	void seek(double time_s) {
		now_s_ = time_s;
		off_s_ = 0.0;
		is_set_ = true;
	}

	/// Now it should be time_s. What is no number is passed over.
	void follow(double time_s) {
		const double off_s = time_s - now_s_;
		if (!std::isfinite(time_s)) {
			return;
		}
		if (!is_set_ || std::abs(off_s) > STEP_BEYOND_S) {
			seek(time_s);
		} else {
			off_s_ = off_s;
		}
	}

	/// Its time goes on by this for each second of samples, until it is told of again or advanced.
	[[nodiscard]] double pace() const {
		return off_s_ == 0.0 ? 1.0 : 1.0 + std::clamp(PULL_PER_S * off_s_, -MOST_PULL, MOST_PULL);
	}

	/// dt_s of samples have been made.
	void advance(double dt_s) {
		const double pace_now = pace();
		now_s_ += pace_now * dt_s;
		off_s_ -= (pace_now - 1.0) * dt_s;
	}

	[[nodiscard]] double now_s() const { return now_s_; }

private:
	static constexpr double PULL_PER_S = 2.0;
	static constexpr double MOST_PULL = 0.02;

	double now_s_ = 0.0;
	double off_s_ = 0.0;
	bool is_set_ = false;
};

} // namespace steadyhand
