#pragma once

#include "gesture/feature.h"
#include "gesture/trainer.h"

#include <string>

namespace steadyhand {

/// What makes figures, and models, of something else than a recorded gesture: units that are not metres and
/// seconds, a track that does not hold the gesture. Begins with "its reference" where that is to be looked
/// at, else at the measured track; empty where nothing is odd. Only to be told: it may be meant so.
[[nodiscard]] std::string oddity(const Feature &feature, const TrainingRecording &recording);

} // namespace steadyhand
