#include "near.h"
#include "strokes/direction_density.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace steadyhand;

TEST_CASE("the direction density has mean 1 over the sphere") {
	for (const double width : { 0.35, 0.42, 0.8, 1.2, 1.6 }) {
		CAPTURE(width);
		// Even over the sphere: the cosine is (Archimedes).
		constexpr int STEPS = 100000;
		double sum = 0.0;
		for (int i = 0; i < STEPS; ++i) {
			const double cosine = -1.0 + 2.0 * (i + 0.5) / STEPS;
			sum += std::exp(log_direction_ratio(std::sqrt(2.0 - 2.0 * cosine), width));
		}
		CHECK(sum / STEPS == test::near(1.0).epsilon(0.01));
	}
}

TEST_CASE("a density as wide as the sphere favours no direction") {
	CHECK(log_direction_ratio(0.0, 1e3) == 0.0);
	CHECK(log_direction_ratio(2.0, 1e3) == test::near(0.0).epsilon(1e-9));
}
