#include "phase/element_curve.h"

#include <algorithm>

namespace steadyhand {

ElementCurve::ElementCurve(const GestureModel &model) : end_(evaluate(model, 1.0)) {
	for (const PrimitiveMotionElement &element : model.elements) {
		pieces_.push_back({ element.phase_begin, element.phase_end,
				1.0 / (element.phase_end - element.phase_begin), element.curve.coefficients });
		for (std::size_t k = terms_; k <= Polynomial::MAX_DEGREE; ++k) {
			terms_ = element.curve.coefficients[k] != 0.0 ? k + 1 : terms_;
		}
	}
	// Of more elements than a byte can count, the later ones are stepped to.
	const std::size_t last = std::min<std::size_t>(pieces_.size() - 1, UINT8_MAX);
	std::size_t element = 0;
	for (std::size_t cell = 0; cell < piece_.size(); ++cell) {
		const double phase = static_cast<double>(cell) / static_cast<double>(CELLS);
		while (element < last && phase >= pieces_[element].end) {
			++element;
		}
		piece_[cell] = static_cast<std::uint8_t>(element);
	}
}

} // namespace steadyhand
