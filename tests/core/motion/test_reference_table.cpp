#include "motion/reference_table.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace steadyhand;

// Phases: shares of a gesture's duration. Values: amplitudes.

namespace {

constexpr double END = 1.5; ///< of the table

} // namespace

TEST_CASE("the reference table is within 1e-4 of the model's curve") {
	const GestureModel &model = test::drag_model();
	const ReferenceTable table(model);
	for (int i = 1; i < 15000; ++i) {
		const double phase = 1e-4 * i;
		CAPTURE(phase);
		const CurvePoint exact = evaluate_onwards(model, phase);
		const CurvePoint point = table.at(phase);
		CHECK(std::abs(point.value - exact.value) < 1e-4);
		CHECK(std::abs(point.slope - exact.slope) < 0.02);
	}
}

TEST_CASE("the reference table is 0 before the start and at its end beyond it") {
	const GestureModel &model = test::drag_model();
	const ReferenceTable table(model);
	for (const double phase : { -1e9, -1.0, -1e-12, 0.0, std::nan("") }) {
		CHECK(table.at(phase).value == 0.0);
		CHECK(table.at(phase).slope == 0.0);
	}
	for (const double phase : { END, 2.0, 1e9 }) {
		CHECK(table.at(phase).value == doctest::Approx(evaluate_onwards(model, END).value).epsilon(1e-12));
		CHECK(table.at(phase).slope == 0.0);
	}
}

TEST_CASE("value and slope of the reference table are continuous") {
	const ReferenceTable table(test::drag_model());
	constexpr double STEP = 1e-9;
	for (int i = 0; i <= 6000; ++i) { // every cell has 40 or more of these, and its edges are among them
		const double phase = END * i / 6000.0;
		CAPTURE(phase);
		const CurvePoint before = table.at(phase - STEP), after = table.at(phase + STEP);
		CHECK(std::abs(after.value - before.value) < 1e-7);
		CHECK(std::abs(after.slope - before.slope) < 1e-3);
	}
}

TEST_CASE("the slope of the reference table is the derivative of its value") {
	const ReferenceTable table(test::drag_model());
	constexpr double STEP = 1e-5;
	for (int i = 1; i < 1490; ++i) {
		const double phase = 1e-3 * i + 0.3e-3; // on no edge of a cell
		const double difference =
				(table.at(phase + STEP).value - table.at(phase - STEP).value) / (2.0 * STEP);
		CHECK(std::abs(table.at(phase).slope - difference) < 1e-6);
	}
}

TEST_CASE("phase_of is the inverse of the reference table") {
	const ReferenceTable table(test::drag_model());
	for (int i = 1; i < 100; ++i) {
		const double value = 0.01 * i;
		CHECK(table.at(table.phase_of(value)).value == doctest::Approx(value).epsilon(1e-8));
	}
	for (int i = 10; i < 90; ++i) {
		const double phase = 0.01 * i;
		CHECK(table.phase_of(table.at(phase).value) == doctest::Approx(phase).epsilon(1e-8));
	}
	CHECK(table.phase_of(2.0) == doctest::Approx(END));
	CHECK(table.phase_of(-1.0) == doctest::Approx(0.0));
}
