#pragma once

#include "gesture/feature.h"
#include "gesture/trainer.h"

#include <span>
#include <string>

namespace steadyhand {

/// The feature that a set of recordings is about: the one whose way from start to end of the reference tracks
/// comes nearest to the amplitudes of their tasks, in the mean over the recordings of |way - amplitude| /
/// amplitude. Null where none comes within half of it.
const Feature *choose_feature(std::span<const TrainingRecording> recordings);

/// Why choose_feature() found none: what is wrong with the first recording by a feature that it holds
/// something of. Begins with its name; at least one recording.
[[nodiscard]] std::string no_feature_reason(std::span<const TrainingRecording> recordings);

} // namespace steadyhand
