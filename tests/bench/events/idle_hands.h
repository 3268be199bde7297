#pragma once

#include "draws.h"
#include "hand_plan.h"
#include "movements.h"
#include "performance.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace steadyhand::bench {

// Hands that make no gesture.

inline constexpr double TURN = 2.0 * std::numbers::pi;
inline constexpr double IDLE_S = 18.0;

/// Linear from 0 at from_s to 1 at from_s + duration_s.
inline double fade_in(double t_s, double from_s, double duration_s) {
	return std::clamp((t_s - from_s) / duration_s, 0.0, 1.0);
}

inline void sway_a_little(Performance &hand, Draws &draws) {
	hand.rest(IDLE_S).plan().sway([pace = draws.between(0.3, 0.8)](double t_s) {
		return HandPose(0.003 * std::sin(6.0 * pace * t_s), 0.004 * std::sin(4.1 * pace * t_s + 1.0),
				0.003 * std::sin(5.0 * pace * t_s + 2.0), 0.0008 * std::sin(3.0 * t_s));
	});
}

inline void wave_hand(Performance &hand, Draws &draws) {
	const double rate_hz = draws.between(0.8, 2.5), amplitude_m = draws.between(0.05, 0.12);
	hand.rest(IDLE_S).plan().sway([=](double t_s) {
		constexpr double FROM_S = 2.0;
		const HandPose full(amplitude_m * std::sin(TURN * rate_hz * (t_s - FROM_S)),
				0.02 * std::cos(2.0 * TURN * rate_hz * t_s), 0.01 * std::sin(2.0 * t_s), 0.0);
		return HandPose(fade_in(t_s, FROM_S, 1.0) * full);
	});
}

inline void draw_circles(Performance &hand, Draws &draws) {
	const double rate_hz = draws.between(0.4, 1.5), radius_m = draws.between(0.05, 0.12);
	hand.rest(IDLE_S).plan().sway([=](double t_s) {
		const double angle = TURN * rate_hz * t_s;
		const HandPose full(radius_m * std::sin(angle), radius_m * (std::cos(angle) - 1.0), 0.0, 0.0);
		return HandPose(fade_in(t_s, 2.0, 2.0) * full);
	});
}

inline void reach_elsewhere(Performance &hand, Draws &draws) {
	const auto is_elsewhere = [axis = hand.movement().axis(), most = std::cos(radians(38.0))](
									  const Eigen::Vector3d &drawn) {
		return std::max({ std::abs(drawn.x()), std::abs(drawn.y()), -drawn.z(), drawn.dot(axis) }) <= most;
	};
	for (int i = 0; i < 5; ++i) {
		const Eigen::Vector3d direction = draws.unit_vector_where(is_elsewhere);
		HandPose there = hand.start();
		there.head<3>() += draws.between(0.15, 0.4) * direction;
		hand.go(there, draws.between(0.5, 1.0)).rest(draws.between(0.2, 0.9));
		hand.go_to(0.0, draws.between(0.5, 1.0)).rest(draws.between(0.3, 1.5));
	}
}

inline void scratch_face(Performance &hand, Draws &draws) {
	for (int i = 0; i < 3; ++i) {
		HandPose face = hand.start();
		face.head<3>() += Eigen::Vector3d(draws.between(-0.1, 0.1), 0.25, 0.28);
		hand.go(face, draws.between(0.6, 0.9));
		for (int scratch = 0; scratch < 6; ++scratch) {
			const double z_m = 0.005 * draws.normal(), x_m = 0.005 * draws.normal();
			const double y_m = scratch % 2 == 0 ? -0.02 : 0.02;
			hand.go(face + HandPose(x_m, y_m, z_m, 0.0), 0.12);
		}
		hand.go_to(0.0, draws.between(0.6, 0.9)).rest(draws.between(0.5, 2.0));
	}
}

inline void type_keys(Performance &hand, Draws &draws) {
	for (int i = 0; i < 60; ++i) {
		const double z_m = draws.between(-0.02, 0.02), x_m = draws.between(-0.06, 0.06);
		const HandPose above = hand.start() + HandPose(x_m, 0.0, z_m, 0.0);
		const HandPose key = above - HandPose(0.0, draws.between(0.01, 0.025), 0.0, 0.0);
		hand.go(above, 0.12).go(key, 0.06).go(above, 0.06);
		if (draws.below(6) == 0) {
			hand.rest(0.5);
		}
	}
}

/// The tracker's frame moves, as with worn cameras: three seconds in one direction, and with each step.
inline void walk(Performance &hand, Draws &draws) {
	const double steps_per_s = draws.between(0.8, 1.1), speed_m_s = draws.between(0.3, 1.2);
	const double z = draws.normal(), x = draws.normal();
	const Eigen::Vector3d direction = Eigen::Vector3d(x, 0.0, z).normalized();
	hand.rest(IDLE_S).plan().move_frame([=](double t_s) {
		constexpr double FROM_S = 3.0, WALK_S = 3.0, RUN_UP_S = 0.8;
		const double walked_s = std::clamp(t_s - FROM_S, 0.0, WALK_S);
		const double at_speed_s =
				walked_s < RUN_UP_S ? walked_s * walked_s / (2.0 * RUN_UP_S) : walked_s - 0.5 * RUN_UP_S;
		const double angle = TURN * steps_per_s * t_s;
		const Eigen::Vector3d step_m(
				0.015 * std::sin(angle), 0.02 * std::sin(2.0 * angle), 0.01 * std::sin(2.0 * angle));
		return Eigen::Vector3d(speed_m_s * at_speed_s * direction + fade_in(t_s, FROM_S, RUN_UP_S) * step_m);
	});
}

inline constexpr std::array IDLE_HANDS{
	HandKind{ "rests and sways by some mm", ALL, sway_a_little },
	HandKind{ "waves", ALL, wave_hand },
	HandKind{ "draws circles", ALL, draw_circles },
	HandKind{ "reaches in other directions and returns", ALL, reach_elsewhere },
	HandKind{ "scratches the face", ALL, scratch_face },
	HandKind{ "types", ALL, type_keys },
	HandKind{ "walks with a worn tracker", ALL, walk },
};

} // namespace steadyhand::bench
