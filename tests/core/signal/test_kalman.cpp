#include "near.h"
#include "signal/constant_velocity_kalman.h"

#include <doctest/doctest.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <cmath>
#include <initializer_list>
#include <limits>

using steadyhand::ConstantVelocityKalman;

namespace {

constexpr double INF = std::numeric_limits<double>::infinity();
constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();

} // namespace

TEST_CASE("the Kalman filter settles at the gains of the tracking index") {
	// White-noise acceleration in continuous time (Bar-Shalom, Li, Kirubarajan 2001, section 6.5.3):
	// lambda^2 = q T^3 / r = beta^2 / (1 - alpha), beta = 3 (2 - alpha) - sqrt(3 (alpha^2 - 12 alpha + 12)).
	for (const double q : { 1e-4, 1e-2, 1.0, 100.0 }) {
		CAPTURE(q);
		const double period_s = 1.0 / 60.0;
		ConstantVelocityKalman filter({ q, 0.002, 0.5 });
		for (int frame = 0; frame < 20000; ++frame) {
			filter.push(frame * period_s, 0.0);
		}
		// At rest on zeros, one sample of 1 shows both gains.
		const double alpha = filter.push(20000 * period_s, 1.0);
		const double beta = filter.velocity_m_s() * period_s;
		CHECK(beta ==
				steadyhand::test::near(
						3.0 * (2.0 - alpha) - std::sqrt(3.0 * (alpha * alpha - 12.0 * alpha + 12.0)))
						.epsilon(1e-9));
		CHECK(beta * beta / (1.0 - alpha) ==
				steadyhand::test::near(q * period_s * period_s * period_s / (0.002 * 0.002)).epsilon(1e-9));
	}
}

TEST_CASE("the Kalman filter agrees with the textbook's matrices on irregular instants") {
	const ConstantVelocityKalman::Noise noise;
	const double r = noise.measurement_std_m * noise.measurement_std_m;
	ConstantVelocityKalman filter;
	Eigen::Vector2d state(0.1, 0.0);
	Eigen::Matrix2d covariance;
	covariance << r, 0.0, 0.0, noise.initial_speed_std_m_s * noise.initial_speed_std_m_s;
	double t_s = 0.0;
	CHECK(filter.push(t_s, 0.1) == 0.1);
	for (int frame = 1; frame < 500; ++frame) {
		const double step_s = 0.002 * (1 + frame * 11 % 17);
		const double x_m = 0.1 + 0.05 * std::sin(3.0 * t_s) + 0.001 * ((frame * 5) % 3);
		t_s += step_s;
		Eigen::Matrix2d transition;
		transition << 1.0, step_s, 0.0, 1.0;
		Eigen::Matrix2d process;
		process << step_s * step_s * step_s / 3.0, step_s * step_s / 2.0, step_s * step_s / 2.0, step_s;
		state = transition * state;
		covariance =
				transition * covariance * transition.transpose() + noise.acceleration_psd_m2_s3 * process;
		const Eigen::RowVector2d observe(1.0, 0.0);
		const Eigen::Vector2d gain = covariance * observe.transpose() / (covariance(0, 0) + r);
		state += gain * (x_m - state[0]);
		covariance = ((Eigen::Matrix2d::Identity() - gain * observe) * covariance).eval();

		CHECK(filter.push(t_s, x_m) == steadyhand::test::near(state[0]).epsilon(1e-9));
		CHECK(filter.velocity_m_s() == steadyhand::test::near(state[1]).epsilon(1e-8));
		CHECK(filter.position_variance_m2() / covariance(0, 0) == steadyhand::test::near(1.0).epsilon(1e-9));
	}
}

TEST_CASE("the Kalman filter follows a ramp without lag") {
	ConstantVelocityKalman filter;
	for (int frame = 0; frame < 1000; ++frame) {
		filter.push(frame / 100.0, 0.4 * frame / 100.0);
	}
	CHECK(filter.output() == steadyhand::test::near(0.4 * 9.99).epsilon(1e-9));
}

TEST_CASE("the Kalman filter's covariance stays positive over 10^7 frames of wild steps") {
	ConstantVelocityKalman filter({ 1.0, 1e-6, 0.5 });
	double t_s = 0.0;
	for (int frame = 0; frame < 10'000'000; ++frame) {
		t_s += frame % 1000 == 0 ? 9.0 : (frame % 2 == 0 ? 1e-6 : 0.1);
		filter.push(t_s, 0.001 * (frame % 13));
		if (!(filter.position_variance_m2() > 0.0) || !std::isfinite(filter.output())) {
			FAIL("at frame ", frame);
		}
	}
	CHECK(filter.position_variance_m2() < 1.001e-12); // never more than the last measurement alone leaves
}

TEST_CASE("the Kalman filter is not poisoned by what is no number") {
	ConstantVelocityKalman clean;
	ConstantVelocityKalman poisoned;
	CHECK(poisoned.push(0.0, NOT_A_NUMBER) == 0.0);
	for (int frame = 0; frame < 500; ++frame) {
		const double x_m = 0.1 * std::sin(0.1 * frame);
		const double expected = clean.push(frame * 0.011, x_m);
		CHECK(poisoned.push(frame * 0.011, x_m) == expected);
		for (const double bad : { NOT_A_NUMBER, INF, -INF, 1e300 }) {
			CHECK(poisoned.push(frame * 0.011 + 0.001, bad) == expected);
			CHECK(poisoned.push(bad, 1.0) == expected);
		}
	}
}

TEST_CASE("the Kalman filter takes late and repeated frames as none, and starts anew when the clock does") {
	ConstantVelocityKalman filter;
	filter.push(100.0, 0.0);
	const double output = filter.push(100.01, 0.1);
	CHECK(filter.push(100.01, 5.0) == output);
	CHECK(filter.push(99.5, 5.0) == output);
	CHECK(filter.push(0.0, 5.0) == 5.0);
	CHECK(filter.velocity_m_s() == 0.0);
	CHECK(filter.push(3600.0, 7.0) == 7.0);
}

TEST_CASE("the Kalman filter stays finite at any rate and scale") {
	for (const double rate_hz : { 1.0, 90.0, 1e4 }) {
		for (const double scale_m : { 1e-9, 1.0, 1e9, 1e99 }) {
			ConstantVelocityKalman filter;
			for (int frame = 0; frame < 20000; ++frame) {
				REQUIRE(std::isfinite(filter.push(frame / rate_hz, scale_m * std::sin(frame * frame))));
				REQUIRE(std::isfinite(filter.velocity_m_s()));
			}
		}
	}
}
