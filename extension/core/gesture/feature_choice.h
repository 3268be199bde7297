#pragma once

#include "gesture/feature.h"
#include "gesture/trainer.h"

#include <span>
#include <string>

namespace steadyhand {

/// Chooses the feature of a set of recordings. It has the least mean of |travel - amplitude| / amplitude.
/// travel: change of the feature from start to end of the reference track. Null if every mean is 0.5 or more.
const Feature *choose_feature(std::span<const TrainingRecording> recordings);

/// Why choose_feature() returned null: the fault of the first recording, by a feature that has values in it.
/// Begins with the recording's name. Needs at least one recording.
[[nodiscard]] std::string no_feature_reason(std::span<const TrainingRecording> recordings);

} // namespace steadyhand
