// Accuracy of `phase` mode for other values of its parameters. tools/tuning/fit_parameters.py reads it.
//
//     bench_parameters MODELS SUBJECTS [TRIALS...]
//
// MODELS: folder of the models. SUBJECTS: number of simulated people of the tuning population. TRIALS: trial
// sets. First prints the parameters as JSON. Then reads one setting a line, "NAME VALUE NAME VALUE ...", and
// prints its measures as JSON: mean zero-lag R2 by set, position and gesture, and checks of bench_matrix
// outside of their bounds. Compiled with STEADYHAND_VARIABLE_PARAMETERS.

#include "ablation/measures.h"
#include "matrix/scenarios.h"
#include "metrics/summary.h"
#include "models.h"
#include "trials.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

using namespace steadyhand;
using namespace steadyhand::bench;
using namespace steadyhand::parameters;

struct Fitted {
	std::string_view name;
	double *value;
};

#define FITTED_PARAMETER(NAME)                                                                               \
	Fitted {                                                                                                 \
#NAME, &(NAME)                                                                                       \
	}

/// The parameters of the hand and the tracker.
const std::array FITTED{ FITTED_PARAMETER(LOG_DURATION_SPREAD), FITTED_PARAMETER(PACE_WALK),
	FITTED_PARAMETER(ONSETS_PER_S), FITTED_PARAMETER(START_SPREAD), FITTED_PARAMETER(SHAPE_MEAN),
	FITTED_PARAMETER(SHAPE_SPREAD), FITTED_PARAMETER(GAIN_SPREAD), FITTED_PARAMETER(DEVIATION),
	FITTED_PARAMETER(DEVIATION_RATE_PER_S), FITTED_PARAMETER(HOLD_SPEED), FITTED_PARAMETER(HOLD_RATE_PER_S),
	FITTED_PARAMETER(FREE_SPEED_M_S), FITTED_PARAMETER(FREE_RATE_PER_S),
	FITTED_PARAMETER(GESTURE_TO_FREE_PER_S), FITTED_PARAMETER(GESTURE_TO_HOLD_PER_S),
	FITTED_PARAMETER(FREE_TO_HOLD_PER_S), FITTED_PARAMETER(HOLD_TO_FREE_PER_S),
	FITTED_PARAMETER(LAGGING_SHARE), FITTED_PARAMETER(LAG_S), FITTED_PARAMETER(LAG_SPREAD_S),
	FITTED_PARAMETER(LAG_SETTLING_S), FITTED_PARAMETER(FAULTY_LATENCY_S), FITTED_PARAMETER(LAGGING_ERROR),
	FITTED_PARAMETER(LAGGING_ERROR_RATE_PER_S), FITTED_PARAMETER(LOG_FAULTS), FITTED_PARAMETER(LOG_JUMPS),
	FITTED_PARAMETER(LOG_FAULTS_PER_S), FITTED_PARAMETER(MOST_LOG_FAULTS), FITTED_PARAMETER(FAULTS_PER_S),
	FITTED_PARAMETER(TRACKER_CHANGES_PER_S), FITTED_PARAMETER(MEASUREMENT_NOISE), FITTED_PARAMETER(ALIKE_S),
	FITTED_PARAMETER(OUTLIERS), FITTED_PARAMETER(OUTLIER_DENSITY) };

#undef FITTED_PARAMETER

/// Sets the parameters that a line names; false if it names another one.
bool set_parameters(const std::string &line) {
	std::istringstream words(line);
	std::string name;
	double value = 0.0;
	while (words >> name >> value) {
		const auto found = std::ranges::find(FITTED, name, &Fitted::name);
		if (found == FITTED.end()) {
			std::fprintf(stderr, "bench_parameters: no parameter %s\n", name.c_str());
			return false;
		}
		*found->value = value;
	}
	return true;
}

struct TrialSet {
	std::string name;
	std::vector<SyntheticTrial> trials;
};

void print_measures(const Models &models, const std::vector<TrialSet> &sets,
		const std::vector<matrix::Scenario> &scenarios) {
	std::printf("{");
	for (const TrialSet &set : sets) {
		for (const HandPosition position : { HandPosition::STABLE, HandPosition::UNSTABLE }) {
			for (const auto &model : models) {
				std::vector<const SyntheticTrial *> chosen = gestures_at(set.trials, position);
				std::erase_if(chosen,
						[&](const SyntheticTrial *one) { return one->trial.gesture != model->gesture; });
				if (!chosen.empty()) {
					std::printf("\"%s/%s/%s\": %.6f, ", set.name.c_str(),
							position == HandPosition::STABLE ? "stable" : "unstable", model->gesture.c_str(),
							mean(accuracy_of(models, chosen)));
				}
			}
		}
	}
	Checks sum;
	for (const Checks &checks : checks_of(models, scenarios)) {
		sum += checks;
	}
	std::printf("\"outside\": %d, \"outside, asserted\": %d, \"outside, short task\": %d}\n", sum.outside,
			sum.asserted, sum.short_task);
	std::fflush(stdout);
}

} // namespace

int main(int count, char **arguments) {
	std::uint32_t subjects = 0;
	if (count < 3 ||
			std::from_chars(arguments[2], arguments[2] + std::string_view(arguments[2]).size(), subjects)
							.ec != std::errc()) {
		std::fprintf(stderr, "usage: bench_parameters MODELS SUBJECTS [TRIALS...]\n");
		return 1;
	}
	const Models models = read_models(arguments[1]);
	const std::vector<double> paces{ 1.0, 0.6, 0.4, 1.6 };
	std::vector<TrialSet> sets{ { "simulated",
			tuning_trials(subjects, static_cast<std::uint32_t>(paces.size()), paces) } };
	for (int i = 3; i < count; ++i) {
		const std::string folder = arguments[i];
		sets.push_back({ folder.substr(folder.rfind('/') + 1), read_trials(folder) });
	}
	if (models.empty() || std::ranges::any_of(sets, [](const TrialSet &set) { return set.trials.empty(); })) {
		return 1;
	}
	const std::vector<matrix::Scenario> scenarios = matrix::Scenarios().all();
	const char *separator = "{";
	for (const Fitted &parameter : FITTED) {
		std::printf(
				"%s\"%s\": %.10g", std::exchange(separator, ", "), parameter.name.data(), *parameter.value);
	}
	std::printf("}\n");
	std::fflush(stdout);
	for (std::string line; std::getline(std::cin, line);) {
		if (!set_parameters(line)) {
			return 1;
		}
		print_measures(models, sets, scenarios);
	}
	return 0;
}
