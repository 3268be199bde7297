#include "metrics/lag_search.h"

#include "metrics/tracker_alignment.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace steadyhand {

namespace {

constexpr int LARGEST_SHIFT = static_cast<int>(TrackerAlignment::LARGEST_LAG_S * ALIGNMENT_GRID_HZ);
/// Higher speeds are cut off at it: they come from jumps that last longer than the window.
constexpr double SPEED_QUANTILE = 0.9;
/// Peaks lower by less than this are compared by their residuals: steady waving has several peaks.
constexpr double RIVAL_PEAK = 0.2;
/// Around the peak of the correlation, which is good to some ms.
constexpr double REFINED_WITHIN_S = 0.02;
constexpr double LAG_TOLERANCE_S = 2e-5;
/// A correlation needs half of the least overlap.
constexpr double LEAST_SPEEDS = 0.5 * TrackerAlignment::LEAST_OVERLAP_S * ALIGNMENT_GRID_HZ;

/// Cut off at SPEED_QUANTILE.
std::vector<double> limited_speeds(const SmoothedTrack &track) {
	std::vector<double> known;
	for (std::size_t i = 0; i < track.known.size(); ++i) {
		if (track.is_known(i)) {
			known.push_back(track.speeds_m_s[i]);
		}
	}
	const auto place =
			known.begin() + static_cast<std::ptrdiff_t>(SPEED_QUANTILE * static_cast<double>(known.size()));
	std::nth_element(known.begin(), place, known.end());
	std::vector<double> limited = track.speeds_m_s;
	for (double &speed : limited) {
		speed = std::min(speed, *place);
	}
	return limited;
}

/// Pearson's correlation of both speeds for each shift of -LARGEST_SHIFT..LARGEST_SHIFT, where both are
/// known.
std::vector<double> correlations(const SmoothedPair &tracks) {
	const std::vector<double> reference = limited_speeds(tracks.reference);
	const std::vector<double> other = limited_speeds(tracks.other);
	const auto count = static_cast<std::ptrdiff_t>(tracks.size());
	std::vector<double> all;
	for (std::ptrdiff_t shift = -LARGEST_SHIFT; shift <= LARGEST_SHIFT; ++shift) {
		double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, yy = 0.0, xy = 0.0;
		for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(0, -shift);
				i < count - std::max<std::ptrdiff_t>(0, shift); ++i) {
			const auto at = static_cast<std::size_t>(i), shifted = static_cast<std::size_t>(i + shift);
			if (tracks.reference.is_known(at) && tracks.other.is_known(shifted)) {
				const double one = reference[at], two = other[shifted];
				n += 1.0;
				x += one;
				y += two;
				xx += one * one;
				yy += two * two;
				xy += one * two;
			}
		}
		const double spread = (n * xx - x * x) * (n * yy - y * y);
		const bool is_enough = n >= LEAST_SPEEDS && spread > 0.0;
		all.push_back(is_enough ? (n * xy - x * y) / std::sqrt(spread) : 0.0);
	}
	return all;
}

/// Of the smoothed tracks after the best transform, without outliers of their own.
double residual_at(const SmoothedPair &tracks, double lag_s) {
	const Pairs pairs = tracks.pairs(lag_s);
	if (pairs.size() < 3) {
		return std::numeric_limits<double>::infinity();
	}
	const Pairs kept = without_outliers(pairs);
	return rms(rigid_fit(kept).residuals_m(kept));
}

} // namespace

Pairs SmoothedPair::pairs(double lag_s) const {
	const double shift = lag_s * ALIGNMENT_GRID_HZ;
	const double whole = std::floor(shift);
	const double share = shift - whole;
	PairList list(size());
	for (std::size_t i = 0; i < size(); ++i) {
		const auto before = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) +
				static_cast<std::ptrdiff_t>(whole)); // wraps around below 0, which is not known
		if (reference.is_known(i) && other.is_known(before) && other.is_known(before + 1)) {
			list.add(reference.positions_m[i],
					(1.0 - share) * other.positions_m[before] + share * other.positions_m[before + 1]);
		}
	}
	return list.take();
}

double coarse_lag_s(const SmoothedPair &tracks) {
	const std::vector<double> all = correlations(tracks);
	const double highest = *std::max_element(all.begin(), all.end());
	double best_lag_s = std::numeric_limits<double>::quiet_NaN();
	double least_m = std::numeric_limits<double>::infinity();
	for (std::size_t i = 1; i + 1 < all.size(); ++i) {
		const double before = all[i - 1], here = all[i], after = all[i + 1];
		if (here < before || here <= after || here < highest - RIVAL_PEAK ||
				here < TrackerAlignment::LEAST_CORRELATION) {
			continue;
		}
		const double peak = 0.5 * (before - after) / (before - 2.0 * here + after); // of a parabola
		const double lag_s = (static_cast<double>(i) - LARGEST_SHIFT + peak) / ALIGNMENT_GRID_HZ;
		const double residual_m = residual_at(tracks, lag_s);
		if (residual_m < least_m) {
			least_m = residual_m;
			best_lag_s = lag_s;
		}
	}
	return best_lag_s;
}

/// Golden section search of the least residual.
double refined_lag_s(const SmoothedPair &tracks, double coarse_s) {
	constexpr double SECTION = 1.0 / std::numbers::phi;
	double low = coarse_s - REFINED_WITHIN_S, high = coarse_s + REFINED_WITHIN_S;
	double left = high - SECTION * (high - low), right = low + SECTION * (high - low);
	double at_left = residual_at(tracks, left), at_right = residual_at(tracks, right);
	while (high - low > LAG_TOLERANCE_S) {
		if (at_left < at_right) {
			high = right;
			right = left;
			at_right = at_left;
			left = high - SECTION * (high - low);
			at_left = residual_at(tracks, left);
		} else {
			low = left;
			left = right;
			at_left = at_right;
			right = low + SECTION * (high - low);
			at_right = residual_at(tracks, right);
		}
	}
	return 0.5 * (low + high);
}

} // namespace steadyhand
