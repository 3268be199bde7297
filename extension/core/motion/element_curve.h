#pragma once

#include "gesture/gesture_model.h"

#include <array>
#include <cstdint>

namespace steadyhand {

/// evaluate_onwards() of one model, made fast for the many hypotheses that ask for it: the element of a phase
/// is looked up, and powers that no element has are left out. Small, and allocates nothing.
class ElementCurve {
public:
	/// model must outlive this, and have elements.
	explicit ElementCurve(const GestureModel &model);

	/// evaluate_onwards(model, phase), up to rounding.
	[[nodiscard]] CurvePoint at(double phase) const {
		if (phase <= 0.0) {
			return {};
		}
		return phase > 1.0 ? run_out(end_, phase) : within(phase);
	}

private:
	static constexpr std::size_t CELLS = 64;

	const PrimitiveMotionElement *elements_, *last_;
	std::size_t terms_ = 1;                         ///< coefficients that are not 0 in every element
	std::array<std::uint8_t, CELLS + 1> element_{}; ///< that a cell of phase begins in
	CurvePoint end_;

	/// 0 <= phase <= 1
	[[nodiscard]] CurvePoint within(double phase) const {
		const PrimitiveMotionElement *element =
				elements_ + element_[static_cast<std::size_t>(phase * static_cast<double>(CELLS))];
		while (element < last_ && phase >= element->phase_end) {
			++element;
		}
		const double rate = 1.0 / (element->phase_end - element->phase_begin);
		const double s = (phase - element->phase_begin) * rate;
		double value = 0.0, first = 0.0, half_second = 0.0;
		for (std::size_t k = terms_; k-- > 0;) {
			half_second = half_second * s + first;
			first = first * s + value;
			value = value * s + element->curve.coefficients[k];
		}
		return { value, first * rate, 2.0 * half_second * rate * rate };
	}
};

} // namespace steadyhand
