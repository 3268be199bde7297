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

/// A scenario's measures, with its task.
inline matrix::Measures measures_of(const Models &models, const matrix::Scenario &scenario) {
	const bool is_tap = scenario.gesture == matrix::Gesture::TAP;
	matrix::RecogniserEstimator estimator(
			model_of(models, is_tap ? "tap" : "horizontal_drag"), scenario.task, 0.0);
	return matrix::measure(scenario, estimator);
}

/// f(bound, whether the scenario is outside of it), of each bound that applies.
template <class Function>
void for_each_check(const matrix::Scenario &scenario, const matrix::Measures &measures, const Function &f) {
	for (const matrix::Bound &bound : matrix::BOUNDS) {
		if (applies(bound, scenario)) {
			f(bound, value_of(bound.metric, scenario, measures) > bound.limit);
		}
	}
}

/// Checks of each scenario that are outside of their bounds, %.
inline Sample percent_outside(const Models &models, const std::vector<matrix::Scenario> &scenarios) {
	return each(scenarios.size(), [&](std::size_t i) {
		double checks = 0.0, outside = 0.0;
		for_each_check(scenarios[i], measures_of(models, scenarios[i]), [&](const auto &, bool is_outside) {
			checks += 1.0;
			outside += is_outside ? 1.0 : 0.0;
		});
		return checks > 0.0 ? 100.0 * outside / checks : 0.0;
	});
}

/// Numbers of checks outside of their bounds. short_task: of ends too early or too late, of short tasks.
struct Outside {
	int all = 0, asserted = 0, short_task = 0;
};

inline Outside outside_bounds(const Models &models, const std::vector<matrix::Scenario> &scenarios) {
	std::vector<Outside> found(scenarios.size());
	each(scenarios.size(), [&](std::size_t i) {
		for_each_check(scenarios[i], measures_of(models, scenarios[i]),
				[&](const matrix::Bound &bound, bool is_outside) {
					const bool is_short_task =
							bound.group == "short task" && bound.metric == matrix::Metric::END_ERROR_MS;
					found[i].all += is_outside ? 1 : 0;
					found[i].asserted += is_outside && bound.standing == matrix::Standing::ASSERTED ? 1 : 0;
					found[i].short_task += is_outside && is_short_task ? 1 : 0;
				});
		return 0.0;
	});
	Outside sum;
	for (const Outside &one : found) {
		sum.all += one.all;
		sum.asserted += one.asserted;
		sum.short_task += one.short_task;
	}
	return sum;
}

} // namespace steadyhand::bench
