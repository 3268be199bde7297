#pragma once

#include "gesture/classifier_trainer.h"
#include "simulation/synthetic_trial.h"

#include <vector>

namespace steadyhand {

/// The trials of a set, each with its axis turned at random by up to 20 degrees. Errors: as
/// make_synthetic_trial().
[[nodiscard]] Result<std::vector<SyntheticTrial>> make_turned_trials(const SyntheticSetOptions &options);

/// Recordings for train_classifier(), from trials of simulated gestures and of other motion.
[[nodiscard]] std::vector<ClassifierRecording> classifier_recordings(
		const std::vector<SyntheticTrial> &trials);

/// Trains the classifier of the add-on, on synthetic people of all paces: people drag in 0.3 to 1.3 s,
/// and tap in 0.15 to 0.6 s. The result is the same to the last bit on every run. Takes some 10 s.
[[nodiscard]] Result<ClassifierModel> train_own_classifier();

} // namespace steadyhand
