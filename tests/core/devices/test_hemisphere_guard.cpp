#include "devices/hemisphere_guard.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace steadyhand;

TEST_CASE("hemisphere guard: a hand across the border keeps its path") {
	HemisphereGuard guard;
	int flips = 0;
	// 20 cm to the right of the source, 40 cm/s from x = +0.2 m to -0.2 m and back.
	for (int i = 0; i <= 480; ++i) {
		const double t_s = i / 240.0;
		const Eigen::Vector3d truth(0.2 * std::cos(std::numbers::pi * t_s), 0.2, -0.1);
		const Eigen::Vector3d reported = truth.x() < 0.0 ? Eigen::Vector3d(-truth) : truth;
		const HemisphereGuard::Answer answer = guard.update(reported, t_s);
		CHECK((answer.position_m - truth).norm() < 1e-12);
		CHECK(answer.is_mirrored == (truth.x() < 0.0));
		flips += answer.has_flipped ? 1 : 0;
	}
	CHECK(flips == 2);
}

TEST_CASE("hemisphere guard: quick movements and jumps elsewhere are believed") {
	HemisphereGuard guard;
	const Eigen::Vector3d here(0.3, 0.1, 0.2);
	static_cast<void>(guard.update(here, 0.0));
	for (const Eigen::Vector3d &there : { Eigen::Vector3d(0.32, 0.1, 0.2), Eigen::Vector3d(0.3, -0.1, 0.2),
				 Eigen::Vector3d(-0.3, 0.1, 0.2), Eigen::Vector3d(-0.3, -0.1, -0.1) }) {
		HemisphereGuard copy = guard;
		const HemisphereGuard::Answer answer = copy.update(there, 1.0 / 240.0);
		CHECK_FALSE(answer.has_flipped);
		CHECK(answer.position_m == there);
	}
}

TEST_CASE("hemisphere guard: near the source nothing is mirrored") {
	HemisphereGuard guard;
	const Eigen::Vector3d near(0.05, 0.05, 0.0);
	static_cast<void>(guard.update(near, 0.0));
	const HemisphereGuard::Answer answer = guard.update(-near, 1.0 / 240.0);
	CHECK_FALSE(answer.has_flipped);
	CHECK(answer.position_m == -near);
}

TEST_CASE("hemisphere guard: after a dropout the position is believed") {
	HemisphereGuard guard;
	const Eigen::Vector3d here(0.3, 0.1, 0.2);
	static_cast<void>(guard.update(here, 0.0));
	CHECK(guard.update(-here, 0.05).is_mirrored);
	CHECK_FALSE(guard.update(-here, 0.5).is_mirrored);
	CHECK_FALSE(guard.update(here, 1.0).is_mirrored);
	guard.reset();
	CHECK_FALSE(guard.update(-here, 1.001).is_mirrored);
}
