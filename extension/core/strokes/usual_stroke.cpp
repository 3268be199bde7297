#include "strokes/usual_stroke.h"

#include "base/parameters.h"

#include <algorithm>

namespace steadyhand {

double speed_share(const GestureModel &model, double phase) {
	constexpr int POINTS = 50;
	double peak = 0.0;
	for (int i = 0; i <= POINTS; ++i) {
		peak = std::max(peak, evaluate(model, static_cast<double>(i) / POINTS).slope);
	}
	return peak > 0.0 ? std::max(evaluate(model, phase).slope, 0.0) / peak : 0.0;
}

UsualStroke usual_stroke(const GestureModel &model) {
	return { .amplitude_m = model.typical_task.amplitude_m,
		.duration_s = model.duration_mean_s,
		.is_strike = speed_share(model, 1.0) > parameters::strokes::SPEED_SHARE };
}

} // namespace steadyhand
