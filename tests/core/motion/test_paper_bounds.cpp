// Bounds of `paper` mode's output for random valid models.

#include "gesture/model_file.h"
#include "motion/paper_synthesiser.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <random>

using namespace steadyhand;

TEST_CASE("no valid model makes paper mode put out more than two amplitudes") {
	std::mt19937_64 random(9);
	std::uniform_real_distribution<double> uniform(0.0, 1.0);
	int valid = 0, held = 0;
	for (int round = 0; round < 3000; ++round) {
		GestureModel model = test::drag_model();
		const double steepness = std::pow(10.0, 2.0 * uniform(random) - 1.0);
		double phase = 0.0;
		for (std::size_t i = 0; i < model.elements.size(); ++i) {
			PrimitiveMotionElement &element = model.elements[i];
			element.phase_begin = phase;
			phase = i + 1 < model.elements.size() ? phase + 0.0101 + 0.3 * std::pow(uniform(random), 4.0)
												  : 1.0;
			element.phase_end = phase;
			element.duration_mean_s = std::pow(10.0, 4.0 * uniform(random) - 5.0);
			element.duration_deviation_s = 0.0;
			for (double &coefficient : element.curve.coefficients) {
				coefficient = steepness * (2.0 * uniform(random) - 1.0);
			}
		}
		if (!parse_model(format_model(model), "wild").ok()) {
			continue;
		}
		++valid;
		PaperSynthesiser synthesiser(model);
		double t_s = 1e6;
		synthesiser.begin(t_s, uniform(random));
		for (int state = 1; state < static_cast<int>(model.elements.size()); ++state) {
			for (int i = 0; i < 40; ++i) {
				t_s += 0.001 * uniform(random);
				const Motion motion = synthesiser.motion(t_s, 0.15);
				REQUIRE(std::abs(motion.value_m) <= 2.0 * 0.15);
				REQUIRE(std::isfinite(motion.velocity_m_s));
				REQUIRE(std::isfinite(motion.acceleration_m_s2));
				held += std::abs(motion.value_m) == 2.0 * 0.15 ? 1 : 0;
			}
			synthesiser.enter_state(state, t_s - 0.02 * uniform(random), t_s);
		}
	}
	CHECK(valid > 300);
	CHECK(held > 0);
}
