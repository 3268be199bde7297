#pragma once

#include "gesture/gesture_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace steadyhand {

/// evaluate_onwards() of a model from a table: cubic Hermite pieces, exact at CELLS + 1 phases.
class ReferenceTable {
public:
	struct Point {
		double value, slope;
	};

	explicit ReferenceTable(const GestureModel &model) {
		for (std::size_t i = 0; i < knots_.size(); ++i) {
			const CurvePoint point =
					evaluate_onwards(model, std::max(static_cast<double>(i) * CELL, SMALLEST));
			knots_[i] = { point.value, point.slope };
		}
	}

	/// 0 before the start; beyond the table, at its end.
	[[nodiscard]] Point at(double phase) const {
		if (!(phase > 0.0)) {
			return { 0.0, 0.0 };
		}
		const double cell = std::min(phase / CELL, static_cast<double>(CELLS));
		const std::size_t i = std::min(static_cast<std::size_t>(cell), CELLS - 1);
		const Point &from = knots_[i], &to = knots_[i + 1];
		const double u = cell - static_cast<double>(i);
		const double way = to.value - from.value, a = from.slope * CELL - way, b = way - to.slope * CELL;
		const double w = 1.0 - u, slope = way + (1.0 - 2.0 * u) * (a * w + b * u) + u * w * (b - a);
		return { from.value + u * way + u * w * (a * w + b * u), cell < CELLS ? slope / CELL : 0.0 };
	}

	/// The phase at which the value is reached first; the table's end where it is not.
	[[nodiscard]] double phase_of(double value) const {
		double low = 0.0, high = END;
		for (int i = 0; i < 30; ++i) { // to 1e-9
			const double middle = 0.5 * (low + high);
			(at(middle).value < value ? low : high) = middle;
		}
		return low;
	}

private:
	static constexpr std::size_t CELLS = 96;
	static constexpr double END = 1.5; ///< a hand has come to rest by then: evaluate_onwards()
	static constexpr double CELL = END / static_cast<double>(CELLS);
	static constexpr double SMALLEST = 1e-12; ///< phase 0 belongs to the time before

	std::array<Point, CELLS + 1> knots_{};
};

} // namespace steadyhand
