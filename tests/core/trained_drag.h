#pragma once

#include "minimum_jerk_drag.h"

#include <memory>
#include <utility>

namespace steadyhand::test {

/// trained_drag_model(), trained once for all tests.
inline const std::shared_ptr<const GestureModel> &shared_drag_model() {
	static const auto model = std::make_shared<const GestureModel>(trained_drag_model());
	return model;
}
inline const GestureModel &drag_model() {
	return *shared_drag_model();
}
/// Trained on drags, of the radius of three tips' circle: from closed_m on, by growth_m.
inline std::shared_ptr<const GestureModel> zoom_model(double closed_m, double growth_m) {
	GestureModel zoom = drag_model();
	zoom.gesture = "zoom";
	zoom.feature = "tips_circumradius";
	zoom.recorded_hmms.clear();
	zoom.typical_task = { { closed_m, 0.0, 0.0 }, Eigen::Vector3d::UnitX(), growth_m };
	return std::make_shared<const GestureModel>(std::move(zoom));
}

} // namespace steadyhand::test
