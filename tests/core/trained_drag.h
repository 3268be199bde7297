#pragma once

#include "minimum_jerk_drag.h"
#include "phase/element_curve.h"

#include <memory>

namespace steadyhand::test {

/// trained_drag_model(), trained once for all tests.
inline const std::shared_ptr<const GestureModel> &shared_drag_model() {
	static const auto model = std::make_shared<const GestureModel>(trained_drag_model());
	return model;
}
inline const GestureModel &drag_model() {
	return *shared_drag_model();
}
inline const ElementCurve &drag_curve() {
	static const ElementCurve curve(drag_model());
	return curve;
}

} // namespace steadyhand::test
