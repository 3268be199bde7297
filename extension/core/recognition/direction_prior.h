#pragma once

#include <Eigen/Core>

#include <array>

namespace steadyhand {

/// How much likelier the direction of a motion is if it is a gesture's than if it is any: a density over the
/// sphere, against the even one. Even within a cone about the gesture's axis, and falling off as a Gaussian
/// beyond.
class DirectionPrior {
public:
	/// deg, both > 0: half the opening of the cone, and the deviation beyond it.
	DirectionPrior(double cone_deg, double deviation_deg);

	/// way_m: from the onset. axis: unit vector. jitter_m: of a tracked point, which turns short ways. 1
	/// where the way has no direction.
	[[nodiscard]] double ratio(
			const Eigen::Vector3d &way_m, const Eigen::Vector3d &axis, double jitter_m) const;

private:
	static constexpr std::size_t WIDTHS = 32;

	double cone_rad_;
	double deviation_rad_;
	/// The density at the axis against the even one, for deviations in steps of a tenth of a radian.
	std::array<double, WIDTHS> at_axis_{};
};

} // namespace steadyhand
