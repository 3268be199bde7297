#pragma once

#include "gesture/gesture_model.h"
#include "signal/quintic_piece.h"

#include <array>
#include <cstddef>

namespace steadyhand {

/// Table of evaluate_onwards(). Each cell is the quintic with the model's value, slope and curvature at both
/// of its ends.
class ReferenceTable {
public:
	explicit ReferenceTable(const GestureModel &model) {
		const auto point = [&](double phase) {
			const CurvePoint at = evaluate_onwards(model, phase);
			return MotionPoint{ at.value, at.slope, at.curvature };
		};
		for (std::size_t i = 0; i < cells_.size(); ++i) {
			const double begin = static_cast<double>(i) * CELL;
			cells_[i] = QuinticPiece::between(point(begin + SMALLEST), point(begin + CELL), CELL);
		}
		end_ = { evaluate_onwards(model, END).value, 0.0, 0.0 };
	}

	/// 0 before phase 0. Beyond the table, its last value.
	[[nodiscard]] CurvePoint at(double phase) const {
		if (!(phase > 0.0)) {
			return {};
		}
		if (phase >= END) {
			return end_;
		}
		const auto i = static_cast<std::size_t>(phase / CELL);
		const MotionPoint point = cells_[i].at(phase - static_cast<double>(i) * CELL);
		return { point.position, point.velocity, point.acceleration };
	}

	/// Phase at which the curve reaches the value first; the table's end if it does not.
	[[nodiscard]] double phase_of(double value) const {
		double low = 0.0, high = END;
		for (int i = 0; i < 30; ++i) { // to 1e-9
			const double middle = 0.5 * (low + high);
			(at(middle).value < value ? low : high) = middle;
		}
		return low;
	}

private:
	static constexpr double END = 1.5;         ///< evaluate_onwards() is at rest from here on
	static constexpr double CELL = 1.0 / 64.0; ///< a power of two: no rounding, and phase 1 is an edge
	/// Cells are evaluated this far after their begin: an element or the curve may begin exactly there.
	static constexpr double SMALLEST = 1e-12;

	std::array<QuinticPiece, static_cast<std::size_t>(END / CELL)> cells_{};
	CurvePoint end_;
};

} // namespace steadyhand
