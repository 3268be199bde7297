#pragma once

#include "draws.h"
#include "hand_plan.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace steadyhand::bench {

/// Whether the recogniser gets the start and amplitude of each gesture.
enum class Context { WITH_TASK, WITHOUT_TASK };

/// A movement from the start of a gesture to its end.
struct PlannedMovement {
	std::size_t gesture; ///< index into GESTURES
	HandPose direction;  ///< of length 1
	double amplitude_m, duration_s;

	[[nodiscard]] Eigen::Vector3d axis() const { return direction.head<3>(); }
	[[nodiscard]] bool grows_circle() const { return direction(3) > 0.0; }
};

/// Movements of average amplitude and duration.
inline const std::array<PlannedMovement, 6> MOVEMENTS{ {
		{ 0, { 1.0, 0.0, 0.0, 0.0 }, 0.2, 0.8 },
		{ 0, { -1.0, 0.0, 0.0, 0.0 }, 0.2, 0.8 },
		{ 1, { 0.0, -1.0, 0.0, 0.0 }, 0.2, 0.8 },
		{ 1, { 0.0, 1.0, 0.0, 0.0 }, 0.2, 0.8 },
		{ 2, { 0.0, 0.0, -1.0, 0.0 }, 0.15, 0.35 },
		{ 3, { 0.0, 0.0, 0.0, 1.0 }, 0.03, 0.6 },
} };

/// A consecutive range of MOVEMENTS.
struct MovementRange {
	std::size_t first, count;

	[[nodiscard]] std::size_t at(std::size_t i) const { return first + i % count; }
	[[nodiscard]] std::size_t draw(Draws &draws) const { return first + draws.below(count); }
};
inline constexpr MovementRange ALL{ 0, 6 }, BUT_ZOOMS{ 0, 5 }, DRAGS{ 0, 4 }, TAPS{ 4, 1 }, ZOOMS{ 5, 1 };

/// A random variation of a movement. Without a task the amplitude varies less, because it is unknown.
inline PlannedMovement draw_movement(std::size_t index, Context context, Draws &draws) {
	PlannedMovement movement = MOVEMENTS[index];
	movement.amplitude_m *=
			context == Context::WITHOUT_TASK ? draws.between(0.9, 1.3) : draws.between(0.7, 1.5);
	movement.duration_s *= draws.between(0.75, 1.5);
	return movement;
}

/// The movement with its direction tilted by an angle, to a random side.
inline PlannedMovement tilted(PlannedMovement movement, double degrees, Draws &draws) {
	const Eigen::Vector3d axis = movement.axis(), aside = axis.unitOrthogonal(), upright = axis.cross(aside);
	const double side = draws.between(0.0, 2.0 * std::numbers::pi);
	const double angle = radians(degrees);
	movement.direction.head<3>() =
			std::cos(angle) * axis + std::sin(angle) * (std::cos(side) * aside + std::sin(side) * upright);
	return movement;
}

/// A random direction away from all directions of gestures: the axes of space and the two given ones.
inline Eigen::Vector3d draw_aside(const Eigen::Vector3d &axis, const Eigen::Vector3d &other, Draws &draws) {
	return draws.unit_vector_where([&, most = std::cos(radians(42.0))](const Eigen::Vector3d &drawn) {
		return drawn.cwiseAbs().maxCoeff() <= most && std::abs(drawn.dot(axis)) <= most &&
				std::abs(drawn.dot(other)) <= most;
	});
}

} // namespace steadyhand::bench
