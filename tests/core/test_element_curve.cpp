#include "motion/element_curve.h"

#include <doctest/doctest.h>

#include <random>

using namespace steadyhand;

TEST_CASE("an element curve is evaluate_onwards, for any number of elements of any degree") {
	std::mt19937_64 random(5);
	std::normal_distribution<double> draw;
	for (const std::size_t elements : { 1, 2, 4, 9, 400 }) {
		for (std::size_t degree = 0; degree <= Polynomial::MAX_DEGREE; ++degree) {
			GestureModel model;
			for (std::size_t i = 0; i < elements; ++i) {
				PrimitiveMotionElement &element = model.elements.emplace_back();
				element.phase_begin = static_cast<double>(i) / static_cast<double>(elements);
				element.phase_end = static_cast<double>(i + 1) / static_cast<double>(elements);
				for (std::size_t k = 0; k <= degree; ++k) {
					element.curve.coefficients[k] = draw(random);
				}
			}
			const ElementCurve curve(model);
			for (int i = -5; i <= 320; ++i) {
				const double phase = i / 256.0;
				const CurvePoint point = curve.at(phase), exact = evaluate_onwards(model, phase);
				REQUIRE(point.value == doctest::Approx(exact.value).epsilon(1e-12));
				REQUIRE(point.slope == doctest::Approx(exact.slope).epsilon(1e-12));
				REQUIRE(point.curvature == doctest::Approx(exact.curvature).epsilon(1e-12));
			}
		}
	}
}
