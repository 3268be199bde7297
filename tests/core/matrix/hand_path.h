#pragma once

#include "signal/minimum_jerk.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace steadyhand::matrix {

enum class Profile : std::uint8_t { MINIMUM_JERK, CONSTANT_SPEED };

/// One straight movement of the index tip. It starts and ends at rest (CONSTANT_SPEED: abruptly).
struct Stroke {
	double onset_s = 0.0;
	double duration_s = 1.0;
	Eigen::Vector3d way_m = Eigen::Vector3d::Zero();
	Profile profile = Profile::MINIMUM_JERK;

	[[nodiscard]] double end_s() const { return onset_s + duration_s; }
	[[nodiscard]] double share(double t_s) const {
		const double s = std::clamp((t_s - onset_s) / duration_s, 0.0, 1.0);
		return profile == Profile::MINIMUM_JERK ? minimum_jerk(s).value : s;
	}
};

/// The index tip's true place as a closed form of time: a sum of strokes.
struct HandPath {
	Eigen::Vector3d from_m = Eigen::Vector3d::Zero();
	std::vector<Stroke> strokes;

	[[nodiscard]] Eigen::Vector3d place_m(double t_s) const {
		Eigen::Vector3d place_m = from_m;
		for (const Stroke &stroke : strokes) {
			place_m += stroke.share(t_s) * stroke.way_m;
		}
		return place_m;
	}
};

} // namespace steadyhand::matrix
