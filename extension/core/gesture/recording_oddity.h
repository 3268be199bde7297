#pragma once

#include "gesture/feature.h"
#include "gesture/trainer.h"

#include <string>

namespace steadyhand {

/// Warning about a recording that is probably not a gesture in metres and seconds, or whose tracks do not
/// contain it. It begins with "its reference" if the reference is odd; otherwise the measured track is. Empty
/// if nothing is odd. The recording may still be as intended.
[[nodiscard]] std::string oddity(const Feature &feature, const TrainingRecording &recording);

/// Why training leaves a recording out; empty if it is usable. Reasons: numbers that are not finite; an
/// amplitude that is not above 0; a gesture of more than an hour; a reference that does not contain the
/// gesture, or does not move from the task's start to its end; and oddity() except early_end().
[[nodiscard]] std::string unusable(const Feature &feature, const TrainingRecording &recording);

/// Warning if the measured track ends before the gesture. It is the only possible oddity() of a usable
/// recording.
[[nodiscard]] std::string early_end(const TrainingRecording &recording);

} // namespace steadyhand
