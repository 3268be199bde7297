#include "simulation/hand_pose.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace steadyhand {

namespace {

struct JointPlace {
	Joint joint;
	double x_m, y_m, z_m;
};

// Hand of 19 cm, the 50th percentile of adults. All fingers but the index are curled.
constexpr std::array<JointPlace, JOINT_COUNT> POINTING = { {
		{ Joint::THUMB, -0.032, -0.038, 0.062 },
		{ Joint::INDEX, 0.0, 0.0, 0.0 },
		{ Joint::MIDDLE, 0.012, -0.052, 0.060 },
		{ Joint::RING, 0.030, -0.056, 0.066 },
		{ Joint::PINKY, 0.048, -0.054, 0.074 },
		{ Joint::PALM, 0.018, -0.026, 0.105 },
		{ Joint::WRIST, 0.020, -0.022, 0.175 },
} };

constexpr std::array<JointPlace, 4> BEHIND_THE_PINCH = { {
		{ Joint::RING, 0.034, -0.030, 0.030 },
		{ Joint::PINKY, 0.050, -0.042, 0.042 },
		{ Joint::PALM, 0.024, -0.046, 0.078 },
		{ Joint::WRIST, 0.022, -0.072, 0.142 },
} };

/// Position of a fingertip on the zoom circle. The three tips are far from a line, which determines the
/// circle well.
struct TipPlace {
	Joint joint;
	double angle_deg, z_m;
};

constexpr std::array<TipPlace, 3> PINCH = { {
		{ Joint::THUMB, 205.0, 0.012 },
		{ Joint::INDEX, 85.0, -0.006 },
		{ Joint::MIDDLE, 25.0, -0.010 },
} };

} // namespace

HandFrame pointing_hand(double scale) {
	HandFrame frame;
	for (const JointPlace &place : POINTING) {
		frame.set(place.joint, scale * Eigen::Vector3d(place.x_m, place.y_m, place.z_m));
	}
	return frame;
}

HandFrame pinching_hand(double scale, double radius_m) {
	HandFrame frame;
	for (const JointPlace &place : BEHIND_THE_PINCH) {
		frame.set(place.joint, scale * Eigen::Vector3d(place.x_m, place.y_m, place.z_m));
	}
	for (const TipPlace &place : PINCH) {
		const double angle_rad = place.angle_deg * std::numbers::pi / 180.0;
		frame.set(place.joint,
				{ radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad), scale * place.z_m });
	}
	return frame;
}

void shift_hand(HandFrame &r_frame, const Eigen::Vector3d &shift_m) {
	for (std::size_t joint = 0; joint < JOINT_COUNT; ++joint) {
		if (r_frame.has(static_cast<Joint>(joint))) {
			r_frame.positions_m[joint] += shift_m;
		}
	}
}

} // namespace steadyhand
