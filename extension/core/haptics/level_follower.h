#pragma once

#include "haptics/effect.h"
#include "haptics/run.h"
#include "signal/critically_damped.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {

/// The amplitude of one voice: that of its effect, and where this steps what is missing fades out, so that
/// value and slope go on whatever changes; run by run critically damped, over a longer stretch a little only,
/// and by the stretch's end.
///
/// A sine of the amplitude M in 0..1 whose phase moves w a second changes by at most sqrt((M w)^2 + M'^2).
/// Fading at w a second or slower keeps this below w, the bound of the full sine, wherever steps come from;
/// what follows the motion may change by 0.2 w, within 2 % of that bound, and steps where it is faster.
class LevelFollower {
public:
	/// Begins at this amplitude, without fading it in.
	void start(const LevelPoint &level) { end_ = level; }

	/// The amplitude of the next run, or of a stretch that it can follow, whose ends `from` and `to` are
	/// wanted. rad_per_s: w.
	[[nodiscard]] Level follow(
			LevelPoint from, LevelPoint to, double rad_per_s, double length_s, std::size_t runs) {
		return runs == 1 ? follow_run(from, to, rad_per_s, length_s) : go_on(to, length_s, runs);
	}

	/// Whether it can follow a stretch of more than a run: not while a step fades, where more than a little
	/// is missing, where the amplitude changes too fast, or where it might leave 0..most in between.
	[[nodiscard]] bool can_follow_stretch(const LevelPoint &from, const LevelPoint &to, double most,
			double rad_per_s, double stretch_s) const {
		// The points of the cubic by Bezier: it stays in their hull, its slope in that of their differences.
		const double third_s = 1.0 / 3.0 * stretch_s;
		const double second = end_.value + third_s * end_.slope, third = to.value - third_s * to.slope;
		const double fastest = FOLLOWED * rad_per_s;
		return !is_fading_ && std::abs(end_.value - from.value) <= LITTLE &&
				std::abs(end_.slope - from.slope) * third_s <= LITTLE && std::abs(end_.slope) <= fastest &&
				std::abs(third - second) <= fastest * third_s && std::abs(to.slope) <= fastest &&
				std::min(std::min(end_.value, second), std::min(third, to.value)) >= 0.0 &&
				std::max(std::max(end_.value, second), std::max(third, to.value)) <= most &&
				std::abs(to.slope) <= steepest(to.value, stretch_s);
	}

	/// The stretch ends after this share of it.
	void cut(double share) {
		const double rest = 1.0 - share, way = end_.value - start_.value;
		const double from = start_.slope * length_s_, to = end_.slope * length_s_;
		end_ = { start_.value + share * share * (3.0 - 2.0 * share) * way +
					share * rest * (rest * from - share * to),
			(6.0 * share * rest * way + rest * (1.0 - 3.0 * share) * from -
					share * (2.0 - 3.0 * share) * to) /
					length_s_ };
	}

	[[nodiscard]] bool is_silent() const { return end_.value == 0.0 && end_.slope == 0.0; }

private:
	static constexpr double FOLLOWED = 0.2;
	static constexpr double FASTEST_FADE_PER_S = 1000.0;
	static constexpr double NOTHING = 1e-7;
	static constexpr double LITTLE = 0.01;

	LevelPoint start_, end_; ///< of the last stretch
	double length_s_ = 0.0;
	bool is_fading_ = false;

	/// Slope at an end at which no cubic of this length leaves 0..1 by more than a little: its next point by
	/// Bezier is a third of the length on.
	[[nodiscard]] static double steepest(double value, double length_s) {
		return 3.0 * (std::min(value, 1.0 - value) + LITTLE) / length_s;
	}
	[[nodiscard]] static LevelPoint tamed(const LevelPoint &level, double length_s) {
		const double most = std::max(steepest(level.value, length_s), 0.0);
		return { level.value, std::clamp(level.slope, -most, most) };
	}

	[[nodiscard]] Level follow_run(LevelPoint from, LevelPoint to, double rad_per_s, double run_s) {
		end_ = tamed(end_, run_s); // as after start(), or another sample rate
		const double fastest = FOLLOWED * rad_per_s;
		if (std::abs(to.value - from.value) > fastest * run_s || std::abs(from.slope) > fastest ||
				std::abs(to.slope) > fastest) {
			from = to = { to.value, 0.0 };
		}
		const double missing = end_.value - from.value, missing_slope = end_.slope - from.slope;
		is_fading_ = false;
		if (std::abs(missing) > NOTHING || std::abs(missing_slope) * run_s > NOTHING) {
			const CriticallyDamped left =
					critically_damped(missing, missing_slope, std::min(rad_per_s, FASTEST_FADE_PER_S), run_s);
			to.value += left.value;
			to.slope += left.velocity;
			is_fading_ = std::abs(left.value) > NOTHING;
			if (!(to.value > NOTHING) || to.value >= 1.0) {
				to = { to.value >= 1.0 ? 1.0 : 0.0, 0.0 };
			}
		}
		return go_on(tamed(to, run_s), run_s, 1);
	}

	[[nodiscard]] Level go_on(const LevelPoint &to, double length_s, std::size_t runs) {
		start_ = end_;
		end_ = to;
		length_s_ = length_s;
		return Level::hermite(start_.value, start_.slope * length_s, to.value, to.slope * length_s, runs);
	}
};

} // namespace steadyhand
