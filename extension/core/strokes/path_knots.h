#pragma once

#include "gesture/feature.h"
#include "signal/ring.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace steadyhand {

/// Path of the hand: positions at least APART_S apart, with straight lines between them, also over dropouts.
class PathKnots {
public:
	static constexpr double APART_S = 0.05;

	/// Deletes the path before this position.
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

	/// Position at t_s. Before the oldest knot it is constant, as after the newest position.
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
	/// Greatest distance, from since_s to until_s, of the hand from its position half of APART_S before
	/// until_s.
	[[nodiscard]] double max_distance_m(double since_s, double until_s) const {
		const FeaturePlace last_m = place_m(until_s - 0.5 * APART_S);
		double most_m2 = (last_m - place_m(since_s)).squaredNorm();
		for (std::size_t i = knots_.size(); i > 0 && knots_[i - 1].t_s >= since_s; --i) {
			if (knots_[i - 1].t_s <= until_s) {
				most_m2 = std::max(most_m2, (last_m - knots_[i - 1].place_m).squaredNorm());
			}
		}
		return std::sqrt(most_m2);
	}

private:
	static constexpr std::size_t KNOTS = 128; ///< at least 6.4 s: a slow stroke and the time before it

	struct Place {
		double t_s = 0.0;
		FeaturePlace place_m = FeaturePlace::Zero();
	};
	Ring<Place, KNOTS> knots_;
	Place newest_;
};

} // namespace steadyhand
