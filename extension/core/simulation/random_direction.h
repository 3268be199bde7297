#pragma once

#include "base/random.h"

#include <Eigen/Core>

namespace steadyhand {

/// Random unit vector, uniform on the sphere.
inline Eigen::Vector3d random_direction(Random &r_random) {
	const double x = r_random.normal();
	const double y = r_random.normal();
	const double z = r_random.normal();
	return Eigen::Vector3d(x, y, z).normalized();
}

} // namespace steadyhand
