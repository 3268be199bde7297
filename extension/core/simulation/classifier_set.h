#pragma once

#include "gesture/classifier_trainer.h"
#include "simulation/synthetic_trial.h"

#include <vector>

namespace steadyhand {

/// The trials of a set without a task: the axis of each is turned by up to 20 degrees. Error: as
/// make_synthetic_trial().
[[nodiscard]] Result<std::vector<SyntheticTrial>> make_turned_trials(const SyntheticSetOptions &options);

/// Recordings for train_classifier(), of trials of the simulated gestures and of none.
[[nodiscard]] std::vector<ClassifierRecording> classifier_recordings(
		const std::vector<SyntheticTrial> &trials);

/// The classifier that the add-on brings, of synthetic people of all paces: equal bits on every run. Some 10
/// s.
[[nodiscard]] Result<ClassifierModel> train_own_classifier();

} // namespace steadyhand
