#include "base/random.h"
#include "near.h"
#include "tracking/reading_noise.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>

using namespace steadyhand;
using Eigen::Vector3d;
using test::near;

TEST_CASE("noise per axis on a cubic motion at uneven stamps is the true one") {
	const Vector3d noise_m(0.02e-3, 0.1e-3, 1e-3);
	Vector3d squares = Vector3d::Zero();
	constexpr int RUNS = 400;
	for (int run = 0; run < RUNS; ++run) {
		Random random(static_cast<std::uint64_t>(run));
		ReadingNoise noise;
		double t_s = 0.0;
		for (int i = 0; i < 16; ++i) {
			t_s += 0.009 * static_cast<double>(1 + random.index(3));
			// The fourth difference of a cubic is zero.
			Vector3d place_m = Vector3d(0.5, -0.8, 0.3) * (t_s + 3.0 * t_s * t_s - 9.0 * t_s * t_s * t_s);
			for (Eigen::Index axis = 0; axis < 3; ++axis) {
				place_m[axis] += noise_m[axis] * random.normal();
			}
			noise.push(t_s, place_m);
		}
		squares += noise.deviation_m().cwiseAbs2();
	}
	for (Eigen::Index axis = 0; axis < 3; ++axis) {
		CHECK(std::sqrt(squares[axis] / RUNS) == near(noise_m[axis]).epsilon(0.2));
	}
}

TEST_CASE("a rare jump does not change the measured noise") {
	Random random(4);
	ReadingNoise noise;
	for (int i = 0; i < 200; ++i) {
		Vector3d place_m = Vector3d::Zero();
		for (double &along : place_m) {
			along = 0.1e-3 * random.normal() + (i >= 190 ? 0.05 : 0.0);
		}
		noise.push(0.01 * i, place_m);
	}
	CHECK(noise.deviation_m().maxCoeff() < 0.3e-3);
}

TEST_CASE("a resting hand's repeated readings have the probability of equal rounding" *
		doctest::test_suite("figures")) {
	// Noise of two rounding steps: brute force over random readings.
	constexpr double STEP_M = 0.1e-3;
	Random random(6);
	ReadingNoise noise;
	Vector3d last_m = Vector3d::Zero();
	int same = 0;
	constexpr int READINGS = 200000;
	double log_sum = 0.0;
	for (int i = 0; i < READINGS; ++i) {
		Vector3d place_m;
		for (double &along : place_m) {
			along = STEP_M * std::round(2.0 * random.normal());
		}
		same += place_m == last_m ? 1 : 0;
		last_m = place_m;
		noise.push(0.01 * i, place_m);
		log_sum += i > 20 ? std::log(noise.repeat_probability()) : 0.0;
	}
	// The noise has an error of a seventh, and its third power is used: so the geometric mean is compared.
	CHECK(std::exp(log_sum / READINGS) == near(static_cast<double>(same) / READINGS).epsilon(0.5));
}

TEST_CASE("repeat_probability() is 1 without noise") {
	ReadingNoise noise;
	for (int i = 0; i < 100; ++i) {
		const double x_m = 0.1 * std::sin(0.05 * i);
		noise.push(0.01 * i, { x_m, 0.5 * x_m, 0.2 });
	}
	CHECK(noise.repeat_probability() == 1.0);
}

TEST_CASE("the rounding step is found on a quick hand") {
	for (const double step_m : { 1e-3, 0.5e-3, 0.1e-3 }) {
		ReadingNoise rounded, exact;
		for (int i = 0; i < 16; ++i) {
			const Vector3d place_m = Vector3d(0.3, -0.07, 0.02) * std::sin(0.2 * i);
			rounded.push(0.01 * i, step_m * (place_m / step_m).array().round());
			exact.push(0.01 * i, place_m);
		}
		CHECK(rounded.resolution_m() == near(step_m).epsilon(1e-6));
		CHECK(exact.resolution_m() == 0.0);
	}
}
