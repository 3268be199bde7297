#pragma once

#include <cmath>

namespace steadyhand {

/// A larger number, or NaN, is a fault of the source. Squares of larger numbers overflow.
inline constexpr double LARGEST_USABLE = 1e100;

[[nodiscard]] inline bool is_usable(double number) {
	return std::abs(number) <= LARGEST_USABLE;
}

/// Classifies the time stamps of a stream for a recursive filter. So all filters treat clock faults alike.
class SampleClock {
public:
	/// Time stamps closer than this are equal. Device clocks count microseconds at best.
	static constexpr double SAME_INSTANT_S = 1e-7;
	/// A time stamp farther back is a reset of the clock. A nearer one is a late frame.
	static constexpr double CLOCK_RESET_S = 1.0;
	/// After a longer gap the filter starts again. A sensor of 1 Hz stays well below it.
	static constexpr double LONGEST_GAP_S = 10.0;

	enum class Verdict {
		IGNORE,  ///< same time as before, late, or not usable
		START,   ///< first sample, also after a gap or a clock reset: reset the filter
		ADVANCE, ///< step_s() after the last used sample
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
