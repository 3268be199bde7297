// Accuracy of `phase` mode with a task, against the reference: a line of CSV for each trial.
//
//     bench_accuracy [MODELS [TRIALS]]
//
// MODELS: folder of the models (default: models). TRIALS: a trial set (default: synthetic people of the
// tuning population at 1, 0.6, 0.4 and 1.6 times their own duration).

#include "models.h"
#include "recognition/gesture_recogniser.h"
#include "trials.h"

#include <algorithm>
#include <cstdio>

namespace {

using namespace steadyhand;
using namespace steadyhand::bench;

constexpr double OUTPUTS_PER_S = 1000.0;

} // namespace

int main(int count, char **arguments) {
	const Models models = read_models(count > 1 ? arguments[1] : "models");
	const std::vector<SyntheticTrial> trials =
			count > 2 ? read_trials(arguments[2]) : tuning_trials(12, 4, { 1.0, 0.6, 0.4, 1.6 });
	if (models.empty() || trials.empty()) {
		return 1;
	}
	std::printf("trial,gesture,position,r2,r2_zero,t_diff_s,missed\n");
	for (const SyntheticTrial &trial : trials) {
		const auto known = std::find(GESTURES.begin(), GESTURES.end(), trial.trial.gesture);
		if (known == GESTURES.end()) {
			continue;
		}
		const auto &model = models[static_cast<std::size_t>(known - GESTURES.begin())];
		GestureRecogniser recogniser({ { model, task_of(trial) } }, { .latency_s = USUAL_SENSOR_LATENCY_S });
		const CurveComparison compared = compare_replay(trial, *model, recogniser, OUTPUTS_PER_S);
		std::printf("%s,%s,%s,%.5f,%.5f,%.4f,%d\n", trial.trial.trial.c_str(), trial.trial.gesture.c_str(),
				trial.trial.position == HandPosition::STABLE ? "stable" : "unstable", compared.r2,
				compared.r2_zero, compared.t_diff_s, compared.missed ? 1 : 0);
	}
	return 0;
}
