#include "base/random.h"
#include "near.h"
#include "recognition/direction_prior.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace steadyhand::test {
namespace {

Eigen::Vector3d off_axis(double angle_deg, double length_m) {
	const double angle = angle_deg * std::numbers::pi / 180.0;
	return length_m * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0);
}

TEST_CASE("the direction density has mean 1 over the sphere") {
	const DirectionPrior prior(22.0, 2.0);
	for (const double jitter_m : { 0.0, 0.005, 0.05 }) {
		Random random(3);
		double sum = 0.0;
		constexpr int DRAWS = 200000;
		for (int i = 0; i < DRAWS; ++i) {
			// Even over the sphere: the height is (Archimedes).
			const double z = random.uniform(-1.0, 1.0), side = random.uniform(0.0, 2.0 * std::numbers::pi);
			const double r = std::sqrt(1.0 - z * z);
			const Eigen::Vector3d way_m(0.1 * r * std::cos(side), 0.1 * r * std::sin(side), 0.1 * z);
			sum += prior.ratio(way_m, Eigen::Vector3d::UnitX(), jitter_m);
		}
		CHECK(std::abs(sum / DRAWS - 1.0) < 0.06); // five standard errors of the draws
	}
}

TEST_CASE("a direction within the cone counts alike, one far beyond it nothing") {
	const DirectionPrior prior(22.0, 2.0);
	const double along = prior.ratio(off_axis(0.0, 0.2), Eigen::Vector3d::UnitX(), 0.0);
	CHECK(along > 1.0);
	CHECK(prior.ratio(off_axis(20.0, 0.2), Eigen::Vector3d::UnitX(), 0.0) == along);
	CHECK(prior.ratio(off_axis(45.0, 0.2), Eigen::Vector3d::UnitX(), 0.0) < 1e-9);
	CHECK(prior.ratio(off_axis(180.0, 0.2), Eigen::Vector3d::UnitX(), 0.0) < 1e-9);
}

TEST_CASE("a way as short as the jitter has no direction") {
	const DirectionPrior prior(22.0, 2.0);
	CHECK(prior.ratio(Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX(), 0.005) == 1.0);
	CHECK(prior.ratio(off_axis(45.0, 0.002), Eigen::Vector3d::UnitX(), 0.005) > 0.5);
}

} // namespace
} // namespace steadyhand::test
