#include "motion/element_curve.h"

#include <algorithm>

namespace steadyhand {

ElementCurve::ElementCurve(const GestureModel &model) :
		elements_(model.elements.data()), last_(&model.elements.back()), end_(evaluate(model, 1.0)) {
	for (const PrimitiveMotionElement &element : model.elements) {
		for (std::size_t k = terms_; k <= Polynomial::MAX_DEGREE; ++k) {
			terms_ = element.curve.coefficients[k] != 0.0 ? k + 1 : terms_;
		}
	}
	// Of more elements than a byte can count, the later ones are stepped to.
	const std::size_t last = std::min<std::size_t>(model.elements.size() - 1, UINT8_MAX);
	std::size_t element = 0;
	for (std::size_t cell = 0; cell < element_.size(); ++cell) {
		const double phase = static_cast<double>(cell) / static_cast<double>(CELLS);
		while (element < last && phase >= model.elements[element].phase_end) {
			++element;
		}
		element_[cell] = static_cast<std::uint8_t>(element);
	}
}

} // namespace steadyhand
