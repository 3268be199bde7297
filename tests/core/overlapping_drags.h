#pragma once

#include "minimum_jerk_drag.h"

#include <vector>

namespace steadyhand::test {

/// Where drags along one axis have taken the hand, m; they may overlap.
inline double x_m(const std::vector<Drag> &drags, double t_s) {
	double sum = 0.0;
	for (const Drag &drag : drags) {
		sum += drag.x_m(t_s);
	}
	return sum;
}

} // namespace steadyhand::test
