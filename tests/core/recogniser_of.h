#pragma once

#include "recognition/gesture_recogniser.h"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace steadyhand::test {

/// Expects all models with the same task, or all without one.
inline GestureRecogniser recogniser_of(const std::vector<std::shared_ptr<const GestureModel>> &models,
		const std::optional<Task> &task, const Synthesis &synthesis = {}) {
	std::vector<ExpectedGesture> gestures;
	for (const std::shared_ptr<const GestureModel> &model : models) {
		gestures.push_back({ model, task });
	}
	return GestureRecogniser(std::move(gestures), synthesis);
}

} // namespace steadyhand::test
