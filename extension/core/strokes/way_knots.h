#pragma once

#include "gesture/feature.h"
#include "signal/ring.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace steadyhand {

/// Where the hand was: places some time apart, straight on between them, also where frames are missing.
class WayKnots {
public:
	static constexpr double APART_S = 0.05;

	/// Nothing before this place counts.
	void restart(double t_s, const FeaturePlace &place_m) {
		knots_.clear();
		newest_ = { t_s, place_m };
		knots_.push(newest_);
	}
	/// t_s must increase.
	void push(double t_s, const FeaturePlace &place_m) {
		newest_ = { t_s, place_m };
		if (t_s - knots_.newest().t_s >= APART_S) {
			knots_.push(newest_);
		}
	}

	/// Where the hand was at t_s; before all that is kept, the oldest place, from the newest on that.
	[[nodiscard]] FeaturePlace place_m(double t_s) const {
		if (t_s >= newest_.t_s) {
			return newest_.place_m;
		}
		const Place *after = &newest_;
		for (std::size_t i = knots_.size(); i > 0; --i) {
			const Place &before = knots_[i - 1];
			if (before.t_s <= t_s) {
				const double share = (t_s - before.t_s) / (after->t_s - before.t_s);
				return before.place_m + share * (after->place_m - before.place_m);
			}
			after = &before;
		}
		return after->place_m;
	}
	/// How far the hand was between the two times from where it was at then_s, at most.
	[[nodiscard]] double stray_m(double since_s, double then_s) const {
		const FeaturePlace still = place_m(then_s - 0.5 * APART_S);
		double stray_m2 = (still - place_m(since_s)).squaredNorm();
		for (std::size_t i = knots_.size(); i > 0 && knots_[i - 1].t_s >= since_s; --i) {
			if (knots_[i - 1].t_s <= then_s) {
				stray_m2 = std::max(stray_m2, (still - knots_[i - 1].place_m).squaredNorm());
			}
		}
		return std::sqrt(stray_m2);
	}

private:
	static constexpr std::size_t KNOTS = 128; ///< of slow strokes too, with what was before them

	struct Place {
		double t_s = 0.0;
		FeaturePlace place_m = FeaturePlace::Zero();
	};
	Ring<Place, KNOTS> knots_;
	Place newest_;
};

} // namespace steadyhand
