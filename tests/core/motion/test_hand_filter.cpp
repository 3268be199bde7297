#include "motion/hand_filter.h"

#include <Eigen/Core>
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace steadyhand;

namespace {

constexpr HandProcess PROCESS{ .speed = 0.4, .rate_per_s = 6.0 };
constexpr HandState HAND{ .x = 0.3, .v = -0.7, .xx = 2e-4, .xv = -3e-4, .vv = 0.05 };

Eigen::Vector2d mean_of(const HandState &hand) {
	return { hand.x, hand.v };
}

Eigen::Matrix2d covariance_of(const HandState &hand) {
	return (Eigen::Matrix2d() << hand.xx, hand.xv, hand.xv, hand.vv).finished();
}

} // namespace

TEST_CASE("the prediction of a hand equals the integral of its process") {
	// x' = v, v' = -a v + white noise of density 2 a speed^2: its response to an impulse a time s ago is
	// ((1 - exp(-a s)) / a, exp(-a s)).
	constexpr double A = PROCESS.rate_per_s;
	const auto response = [](double s) { return Eigen::Vector2d(-std::expm1(-A * s) / A, std::exp(-A * s)); };
	for (const double dt_s : { 1e-4, 0.01, 0.1, 1.0 }) {
		CAPTURE(dt_s);
		constexpr int PIECES = 2000; // of Simpson's rule
		Eigen::Matrix2d noise = Eigen::Matrix2d::Zero();
		for (int i = 0; i <= PIECES; ++i) {
			const double share = i == 0 || i == PIECES ? 1.0 : i % 2 == 0 ? 2.0 : 4.0;
			const Eigen::Vector2d g = response(dt_s * i / PIECES);
			noise += share * dt_s / (3.0 * PIECES) * g * g.transpose();
		}
		noise *= 2.0 * A * PROCESS.speed * PROCESS.speed;
		Eigen::Matrix2d transition = Eigen::Matrix2d::Identity();
		transition.col(1) = response(dt_s);
		HandState hand = HAND;
		PROCESS.predict(hand, dt_s);
		CHECK((mean_of(hand) - transition * mean_of(HAND)).norm() < 1e-12);
		const Eigen::Matrix2d expected = transition * covariance_of(HAND) * transition.transpose() + noise;
		CHECK((covariance_of(hand) - expected).norm() < 1e-9 * expected.norm());
	}
}

TEST_CASE("a hand's covariance stays positive over steps of any length") {
	for (const double dt_s : { 0.0, 1e-12, 1e-9, 1e-6, 1e-4, 1e3, 1e9 }) {
		CAPTURE(dt_s);
		HandState hand{ .x = 0.0, .v = 0.0, .xx = 1e-8, .xv = 0.0, .vv = 0.0 };
		for (int i = 0; i < 1000; ++i) {
			PROCESS.predict(hand, dt_s);
		}
		CHECK(std::isfinite(hand.xx));
		CHECK(hand.xx > 0.0);
		CHECK(hand.xx * hand.vv - hand.xv * hand.xv >= -1e-12 * hand.xx * hand.vv);
	}
}

TEST_CASE("a mixture of hands has the moments of its parts") {
	struct Part {
		double weight;
		HandState hand;
	};
	const std::vector<Part> parts{ { 0.2, HAND },
		{ 1.7, { .x = -1.0, .v = 0.5, .xx = 0.3, .xv = 0.1, .vv = 0.2 } },
		{ 0.1, { .x = 12.0, .v = 3.0, .xx = 0.0, .xv = 0.0, .vv = 0.0 } } };
	HandMixture mixture;
	Eigen::Vector2d mean = Eigen::Vector2d::Zero();
	for (const Part &part : parts) {
		mixture.add(part.weight, part.hand);
		mean += part.weight / 2.0 * mean_of(part.hand);
	}
	Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
	for (const Part &part : parts) { // law of total covariance
		const Eigen::Vector2d off = mean_of(part.hand) - mean;
		covariance += part.weight / 2.0 * (covariance_of(part.hand) + off * off.transpose());
	}
	CHECK(mixture.weight() == doctest::Approx(2.0));
	CHECK((mean_of(mixture.state()) - mean).norm() < 1e-12);
	CHECK((covariance_of(mixture.state()) - covariance).norm() < 1e-12 * covariance.norm());
}
