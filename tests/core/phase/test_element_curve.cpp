#include "near.h"
#include "phase/element_curve.h"

#include <doctest/doctest.h>

#include <cmath>
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
				// Of different elements, and beyond both ends, side by side.
				const Lanes phases{ i / 256.0, 1.0 - i / 256.0, std::fmod(0.37 * i, 1.0), 1.0 + 0.01 * i };
				const LaneCurvePoint point = curve.at(load(phases));
				for (std::size_t l = 0; l < LANES; ++l) {
					const CurvePoint exact = evaluate_onwards(model, phases[l]);
					REQUIRE(point.value[l] == test::near(exact.value).epsilon(1e-12));
					REQUIRE(point.slope[l] == test::near(exact.slope).epsilon(1e-12));
					REQUIRE(point.curvature[l] == test::near(exact.curvature).epsilon(1e-12));
				}
			}
		}
	}
}
