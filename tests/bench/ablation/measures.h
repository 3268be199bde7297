#pragma once

#include "../models.h"
#include "../trials.h"
#include "matrix/bounds.h"
#include "matrix/measures.h"
#include "matrix/recogniser_estimator.h"
#include "matrix/scenarios.h"
#include "recognition/gesture_recogniser.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <optional>
#include <string_view>
#include <thread>
#include <vector>

namespace steadyhand::bench {

/// One number for each trial or run. The order is equal with and without a mechanism.
using Sample = std::vector<double>;

/// f(0) to f(count - 1), computed on all processors.
template <class Function> Sample each(std::size_t count, const Function &f) {
	Sample values(count);
	std::atomic<std::size_t> next = 0;
	std::vector<std::jthread> workers;
	for (unsigned i = 0; i < std::max(std::thread::hardware_concurrency(), 1U); ++i) {
		workers.emplace_back([&] {
			for (std::size_t k = next++; k < count; k = next++) {
				values[k] = f(k);
			}
		});
	}
	workers.clear();
	return values;
}

inline const std::shared_ptr<const GestureModel> &model_of(const Models &models, std::string_view gesture) {
	return *std::ranges::find(models, gesture, [](const auto &model) { return model->gesture; });
}

/// The trials with a gesture, at a position if one is given.
inline std::vector<const SyntheticTrial *> gestures_at(
		const std::vector<SyntheticTrial> &trials, std::optional<HandPosition> position = std::nullopt) {
	std::vector<const SyntheticTrial *> found;
	for (const SyntheticTrial &one : trials) {
		if (one.trial.gesture != NO_GESTURE && one.trial.position == position.value_or(one.trial.position)) {
			found.push_back(&one);
		}
	}
	return found;
}

/// Zero-lag R2 of each trial, with its task.
inline Sample accuracy_of(const Models &models, const std::vector<const SyntheticTrial *> &trials) {
	return each(trials.size(), [&](std::size_t i) {
		const auto &model = model_of(models, trials[i]->trial.gesture);
		GestureRecogniser recogniser(
				{ { model, task_of(*trials[i]) } }, { .latency_s = USUAL_SENSOR_LATENCY_S });
		constexpr double OUTPUTS_PER_S = 250.0;
		return compare_replay(*trials[i], *model, recogniser, OUTPUTS_PER_S).r2_zero;
	});
}

inline const char *name_of(matrix::Gesture gesture) {
	return gesture == matrix::Gesture::TAP ? "tap" : "horizontal_drag";
}

/// A scenario's measures, with its task. latency_s: for the estimator.
inline matrix::Measures measures_of(
		const Models &models, const matrix::Scenario &scenario, double latency_s = 0.0) {
	matrix::RecogniserEstimator estimator(
			model_of(models, name_of(scenario.gesture)), scenario.task, latency_s);
	return matrix::measure(scenario, estimator);
}

/// Checks of bench_matrix.
struct Checks {
	int all = 0;
	int outside = 0; ///< of their bounds
	// Of those outside:
	int asserted = 0;
	int short_task = 0; ///< ends of short tasks that are too early or too late

	Checks &operator+=(const Checks &other) {
		all += other.all;
		outside += other.outside;
		asserted += other.asserted;
		short_task += other.short_task;
		return *this;
	}
};

/// The checks of each scenario.
inline std::vector<Checks> checks_of(const Models &models, const std::vector<matrix::Scenario> &scenarios) {
	std::vector<Checks> found(scenarios.size());
	each(scenarios.size(), [&](std::size_t i) {
		const matrix::Measures measures = measures_of(models, scenarios[i]);
		for (const matrix::Bound &bound : matrix::BOUNDS) {
			if (!applies(bound, scenarios[i])) {
				continue;
			}
			++found[i].all;
			if (value_of(bound.metric, scenarios[i], measures) > bound.limit) {
				const bool is_short_task =
						bound.group == "short task" && bound.metric == matrix::Metric::END_ERROR_MS;
				++found[i].outside;
				found[i].asserted += bound.standing == matrix::Standing::ASSERTED ? 1 : 0;
				found[i].short_task += is_short_task ? 1 : 0;
			}
		}
		return 0.0;
	});
	return found;
}

} // namespace steadyhand::bench
