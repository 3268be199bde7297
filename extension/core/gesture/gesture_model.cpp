#include "gesture/gesture_model.h"

#include "tracking/trial_set.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {

std::string_view gesture_name_fault(std::string_view gesture) {
	return gesture == NO_GESTURE ? "stands for no gesture in results; choose another name"
								 : file_name_fault(gesture);
}

CurvePoint evaluate(const GestureModel &model, double phase) {
	if (model.elements.empty()) {
		return {};
	}
	phase = std::clamp(phase, 0.0, 1.0);
	const PrimitiveMotionElement *element = &model.elements.back();
	for (const PrimitiveMotionElement &candidate : model.elements) {
		if (phase < candidate.phase_end) {
			element = &candidate;
			break;
		}
	}
	const double length = element->phase_end - element->phase_begin;
	const Polynomial::Point point = element->curve.evaluate((phase - element->phase_begin) / length);
	return { point.value, point.first / length, point.second / (length * length) };
}

CurvePoint evaluate_onwards(const GestureModel &model, double phase) {
	if (phase <= 0.0) {
		return {};
	}
	const CurvePoint point = evaluate(model, phase);
	if (phase <= 1.0) {
		return point;
	}
	const double fading = std::exp((1.0 - phase) / RUN_OUT), slope = point.slope * fading;
	return { point.value + point.slope * RUN_OUT * (1.0 - fading), slope, -slope / RUN_OUT };
}

double phase_of_value(const GestureModel &model, double value) {
	const Eigen::VectorXd &mean = model.reference_mean;
	for (Eigen::Index i = 0; i < mean.size(); ++i) {
		if (mean(i) >= value) {
			const double step = 1.0 / static_cast<double>(mean.size() - 1);
			if (i == 0) {
				return 0.0;
			}
			return step * (static_cast<double>(i) - (mean(i) - value) / (mean(i) - mean(i - 1)));
		}
	}
	return 1.0;
}

} // namespace steadyhand
