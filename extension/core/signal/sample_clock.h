#pragma once

#include <cmath>

namespace steadyhand {

/// Beyond this (and NaN) a number is a fault of the source: squares of it would overflow.
inline constexpr double LARGEST_USABLE = 1e100;

[[nodiscard]] inline bool is_usable(double number) {
	return std::abs(number) <= LARGEST_USABLE;
}

/// Decides what a stream's next stamp means to a recursive filter, so that every filter treats faults of the
/// clock alike.
class SampleClock {
public:
	/// Stamps closer than this are the same instant: a device clock counts microseconds at best, and a
	/// difference quotient over less is noise.
	static constexpr double SAME_INSTANT_S = 1e-7;
	/// A stamp this far back is a clock that was set anew; less is a frame that came late.
	static constexpr double CLOCK_RESET_S = 1.0;
	/// After a gap this long what was known of the motion is worthless; a sensor of 1 Hz stays well below it.
	static constexpr double LONGEST_GAP_S = 10.0;

	enum class Verdict {
		IGNORE,  ///< same instant as before, late, or not usable
		START,   ///< first sample, or first after a gap or a reset of the clock: forget the past
		ADVANCE, ///< step_s() after the last sample that was used
	};

	[[nodiscard]] Verdict judge(double t_s, double x) {
		if (!is_usable(t_s) || !is_usable(x)) {
			return Verdict::IGNORE;
		}
		step_s_ = t_s - last_s_;
		const bool connected = started_ && step_s_ > -CLOCK_RESET_S && step_s_ < LONGEST_GAP_S;
		if (connected && step_s_ < SAME_INSTANT_S) {
			return Verdict::IGNORE;
		}
		started_ = true;
		last_s_ = t_s;
		return connected ? Verdict::ADVANCE : Verdict::START;
	}

	[[nodiscard]] double step_s() const { return step_s_; } ///< after ADVANCE

private:
	double last_s_ = 0.0;
	double step_s_ = 0.0;
	bool started_ = false;
};

} // namespace steadyhand
