#pragma once

#include "haptics/effect.h"
#include "haptics/run.h"
#include "signal/critically_damped.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace steadyhand {

/// The amplitude of one voice from run to run: that of its effect, and where this steps what is missing fades
/// out critically damped, so that value and slope go on whatever changes.
///
/// A sine of the amplitude M in 0..1 whose phase moves w a second changes by at most sqrt((M w)^2 + M'^2).
/// Fading at w a second or slower keeps this below w, the bound of the full sine, wherever steps come from;
/// what follows the motion may change by 0.2 w, within 2 % of that bound, and steps where it is faster.
class LevelFollower {
public:
	/// Begins at this amplitude, without fading it in.
	void start(const LevelPoint &level) { level_ = level; }

	/// The amplitude of the next run, whose ends `from` and `to` are wanted. rad_per_s: w.
	[[nodiscard]] Level follow(LevelPoint from, LevelPoint to, double rad_per_s, double run_s) {
		const double fastest = FOLLOWED * rad_per_s;
		if (std::abs(to.value - from.value) > fastest * run_s || std::abs(from.slope) > fastest ||
				std::abs(to.slope) > fastest) {
			from = to = { to.value, 0.0 };
		}
		const LevelPoint before = level_;
		const double missing = before.value - from.value, missing_slope = before.slope - from.slope;
		level_ = to;
		if (std::abs(missing) > NOTHING || std::abs(missing_slope) * run_s > NOTHING) {
			const CriticallyDamped left =
					critically_damped(missing, missing_slope, std::min(rad_per_s, FASTEST_FADE_PER_S), run_s);
			level_.value += left.value;
			level_.slope += left.velocity;
			if (!(level_.value > NOTHING) || level_.value >= 1.0) {
				level_ = { level_.value >= 1.0 ? 1.0 : 0.0, 0.0 };
			}
		}
		return Level::hermite(before.value, before.slope * run_s, level_.value, level_.slope * run_s);
	}

	[[nodiscard]] bool is_silent() const { return level_.value == 0.0 && level_.slope == 0.0; }

private:
	static constexpr double FOLLOWED = 0.2;
	static constexpr double FASTEST_FADE_PER_S = 1000.0;
	static constexpr double NOTHING = 1e-7;

	LevelPoint level_; ///< at the end of the last run
};

} // namespace steadyhand
