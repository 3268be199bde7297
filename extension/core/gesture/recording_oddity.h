#pragma once

#include "gesture/feature.h"
#include "gesture/trainer.h"

#include <string>

namespace steadyhand {

/// What makes figures, and models, of something else than a recorded gesture: units that are not metres and
/// seconds, a track that does not hold the gesture. Begins with "its reference" where that is to be looked
/// at, else at the measured track; empty where nothing is odd. Only to be told: it may be meant so.
[[nodiscard]] std::string oddity(const Feature &feature, const TrainingRecording &recording);

/// Why nothing is to be learnt from a recording: an amplitude that is not above 0, a reference that does not
/// hold the gesture, or does not go from the task's start to its end from start_s to end_s, a gesture of more
/// than an hour, or what is odd about it otherwise, but for early_end(). Empty where there is no reason.
[[nodiscard]] std::string unusable(const Feature &feature, const TrainingRecording &recording);

/// All that may be odd about one that is not unusable(): its measured track ends before the gesture does.
[[nodiscard]] std::string early_end(const TrainingRecording &recording);

} // namespace steadyhand
