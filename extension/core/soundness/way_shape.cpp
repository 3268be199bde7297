#include "soundness/way_shape.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

/// A hand that is no further has yet to set out.
constexpr double SET_OUT = 0.05;
/// Between these it is on its way: before, a bow explains everything; after, hands correct themselves.
constexpr double FROM = 0.15, TO = 0.8;
constexpr int FEWEST = 5; ///< a bow goes through three
/// Root mean square distance from the bow at which either kind of tracker is as likely, for each amplitude
/// that the hand has come.
constexpr double EVEN = 0.009;
/// Nats for each time that it is e times as far, and in all.
constexpr double NATS = 1.9, MOST = 2.0;
constexpr double SMALLEST = 1e-9;    ///< squared distance
constexpr double REGULARISED = 1e-9; ///< a hand that all but stands has no bow

} // namespace

void WayShape::push(double x, const FeaturePlace &place, double noise) {
	if (x < SET_OUT) {
		frames_ = {};
		frames_.first = place;
		log_ratio_ = 0.0;
		has_start_ = true;
	}
	const Eigen::Vector3d powers(1.0, x, x * x);
	const FeaturePlace gone = place - frames_.first;
	frames_.powers += powers * powers.transpose();
	frames_.places += powers * gone.transpose();
	frames_.squares += gone.squaredNorm();
	++frames_.count;
	if (has_start_ && frames_.count >= FEWEST && x > FROM && x < TO) {
		// Along the way there is no distance, and no noise, from a bow over the way.
		const double squared = std::max(squared_distance_from_bow() - 2.0 * noise * noise, SMALLEST);
		log_ratio_ = std::clamp(0.5 * NATS * std::log(squared / (EVEN * EVEN * x * x)), 0.0, MOST);
	}
}

/// Mean over the frames: places less their least squares fit.
double WayShape::squared_distance_from_bow() const {
	const Eigen::Matrix3d powers = frames_.powers + REGULARISED * Eigen::Matrix3d::Identity();
	const double explained = frames_.places.cwiseProduct(powers.ldlt().solve(frames_.places)).sum();
	return std::max(frames_.squares - explained, 0.0) / frames_.count;
}

} // namespace steadyhand
