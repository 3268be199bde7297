#pragma once

#include "metrics/rigid_fit.h"
#include "metrics/smoothed_track.h"

#include <cstddef>

namespace steadyhand {

/// Of the smoothed tracks. Hands move at up to about 4 Hz.
constexpr double ALIGNMENT_GRID_HZ = 100.0;

/// Both smoothed tracks on one grid.
struct SmoothedPair {
	SmoothedTrack reference, other;

	[[nodiscard]] std::size_t size() const { return reference.known.size(); }

	/// At lag_s, at most LARGEST_LAG_S.
	[[nodiscard]] Pairs pairs(double lag_s) const;
};

/// From the correlation of both speeds, good to some ms. Of the peaks that rival the highest, the one whose
/// tracks fit best; not a number where there is none.
[[nodiscard]] double coarse_lag_s(const SmoothedPair &tracks);

/// The lag near `coarse_s` that leaves the least residual of a rigid transform.
[[nodiscard]] double refined_lag_s(const SmoothedPair &tracks, double coarse_s);

} // namespace steadyhand
