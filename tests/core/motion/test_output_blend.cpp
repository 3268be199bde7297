#include "motion/output_blend.h"
#include "near.h"

#include <doctest/doctest.h>

#include <cmath>
#include <utility>

using namespace steadyhand;

TEST_CASE("a blend solves x'' = -2 a x' - a^2 x from its begin") {
	constexpr double BEGAN_S = 3.0, STEP_S = 1e-6;
	for (const double rate_per_s : { 4.0, parameters::FRAME_BLEND_PER_S }) {
		for (const auto &[value, velocity] :
				{ std::pair{ 0.3, 0.0 }, std::pair{ 0.0, -2.0 }, std::pair{ 0.1, 5.0 } }) {
			OutputBlend blend;
			blend.start(BEGAN_S, value, velocity, rate_per_s);
			const CriticallyDamped begun = blend.at(BEGAN_S), earlier = blend.at(BEGAN_S - 1.0);
			CHECK(begun.value == value);
			CHECK(begun.velocity == test::near(velocity).epsilon(1e-12));
			CHECK(earlier.value == value);
			CHECK(earlier.velocity == test::near(velocity).epsilon(1e-12));
			for (const double share : { 0.1, 0.7, 2.0, 5.0 }) {
				CAPTURE(share);
				const double t_s = BEGAN_S + share / rate_per_s;
				const CriticallyDamped before = blend.at(t_s - STEP_S), now = blend.at(t_s),
									   after = blend.at(t_s + STEP_S);
				const double size = (std::abs(value) * rate_per_s + std::abs(velocity)) * rate_per_s;
				CHECK(std::abs((after.value - before.value) / (2.0 * STEP_S) - now.velocity) < 1e-6 * size);
				CHECK(std::abs((after.velocity - before.velocity) / (2.0 * STEP_S) - now.acceleration) <
						1e-6 * size);
				CHECK(std::abs(now.acceleration + 2.0 * rate_per_s * now.velocity +
							  rate_per_s * rate_per_s * now.value) < 1e-12 * size);
			}
			CHECK(std::abs(blend.at(BEGAN_S + 50.0 / rate_per_s).value) < 1e-18);

			const Motion motion{ 1.0, 2.0, 3.0, 0.4 };
			const Motion completed = blend.completed(motion, BEGAN_S + 0.01);
			const CriticallyDamped missing = blend.at(BEGAN_S + 0.01);
			CHECK(completed.value_m == 1.0 + missing.value);
			CHECK(completed.velocity_m_s == 2.0 + missing.velocity);
			CHECK(completed.acceleration_m_s2 == 3.0 + missing.acceleration);
			CHECK(completed.progress == 0.4);
		}
	}
}

TEST_CASE("share_left() does not depend on the number of blends") {
	constexpr double RATE_PER_S = 100.0;
	OutputBlend blend;
	double left = 1.0;
	for (double t_s = 1.0; t_s < 1.02; t_s += 0.001) {
		blend.start(t_s, 0.3, -2.0, RATE_PER_S);
		CHECK(blend.share_left(t_s - 0.5) == 1.0);
		left *= blend.share_left(t_s + 0.001);
		CHECK(left == test::near(std::exp(-RATE_PER_S * (t_s + 0.001 - 1.0))));
	}
}
