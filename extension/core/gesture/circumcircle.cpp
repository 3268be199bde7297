#include "gesture/circumcircle.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {

std::optional<double> circumradius(
		const Eigen::Vector2d &p, const Eigen::Vector2d &q, const Eigen::Vector2d &r) {
	Eigen::Vector2d qr = r - q, rp = p - r, pq = q - p;
	const double scale = std::max(
			{ qr.lpNorm<Eigen::Infinity>(), rp.lpNorm<Eigen::Infinity>(), pq.lpNorm<Eigen::Infinity>() });
	if (!(scale > 0.0) || !std::isfinite(scale)) {
		return std::nullopt;
	}
	// Lengths relative to the longest side cannot overflow.
	qr /= scale;
	rp /= scale;
	pq /= scale;
	const double area_twice = std::abs(pq.x() * rp.y() - pq.y() * rp.x());
	const Eigen::Array3d squares(qr.squaredNorm(), rp.squaredNorm(), pq.squaredNorm());
	const Eigen::Array3d weights = squares * (squares.sum() - 2.0 * squares); // times 16 K^2
	const double norm = 4.0 * area_twice * area_twice;                        // 16 K^2
	if (area_twice == 0.0 || weights.matrix().norm() > ERROR_GAIN_MAX * norm) {
		return std::nullopt;
	}
	return scale * std::sqrt(squares.prod()) / (2.0 * area_twice);
}

} // namespace steadyhand
