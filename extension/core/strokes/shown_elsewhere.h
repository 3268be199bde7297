#pragma once

#include "gesture/feature.h"
#include "soundness/hands.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace steadyhand {

/// Tells when a tracker shows something else for the hand, as another hand, and when it is back: of a hand
/// that went on meanwhile all but its way back would be a step of the tracker's. Only what no hand does is
/// told, and only where the way back leads to about where the hand was going.
class ShownElsewhere {
public:
	enum class Sight : std::uint8_t {
		ON_ITS_WAY,
		LEAVES,  ///< this frame is off the way, and those after it
		RETURNS, ///< what came since LEAVES, but for this frame, did not show the hand
	};

	/// t_s must not decrease; a place that repeats the last one is no news.
	Sight look(double t_s, const FeaturePlace &place_m) {
		const double dt_s = t_s - last_.t_s;
		if (!(dt_s > 0.0) || place_m == last_.place_m) {
			return Sight::ON_ITS_WAY;
		}
		const Frame before = last_;
		const FeaturePlace step_m = place_m - before.place_m;
		const double off_m = (step_m - before.velocity_m_s * dt_s).norm();
		// What is shown for longer than a frame is held.
		const bool leaps = off_m > SMALLEST_M + FASTEST_M_S * std::min(dt_s, LONGEST_FRAME_S);
		last_ = { t_s, place_m, leaps ? FeaturePlace(FeaturePlace::Zero()) : FeaturePlace(step_m / dt_s) };
		if (!leaps) {
			return Sight::ON_ITS_WAY;
		}
		const double away_s = t_s - left_.t_s;
		if (away_s > LONGEST_S) {
			left_ = before;
			return Sight::LEAVES;
		}
		const FeaturePlace way_m = place_m - left_.place_m;
		if ((way_m - left_.velocity_m_s * away_s).norm() > NEARER * step_m.norm()) {
			return Sight::ON_ITS_WAY;
		}
		last_.velocity_m_s = way_m / away_s;
		left_.t_s = NEVER_S;
		return Sight::RETURNS;
	}

private:
	static constexpr double NEVER_S = -std::numeric_limits<double>::infinity();
	static constexpr double SMALLEST_M = 0.03; ///< off where the hand would go on to
	static constexpr double LONGEST_S = 0.4;   ///< elsewhere
	/// The way back ends so much nearer to where the hand would have gone than it begins.
	static constexpr double NEARER = 0.5;

	struct Frame {
		double t_s = NEVER_S;
		FeaturePlace place_m = FeaturePlace::Zero();
		FeaturePlace velocity_m_s = FeaturePlace::Zero();
	};
	Frame last_; ///< that was news
	Frame left_; ///< the last one before what is elsewhere
};

} // namespace steadyhand
