#pragma once

#include "gesture/task.h"
#include "tracking/trial_set.h"

#include <godot_cpp/variant/dictionary.hpp>

#include <optional>

namespace godot {

/// One row of trials.csv for scripts: trial, gesture, position ("stable", "unstable"), subject, start_s,
/// end_s, start (Vector3, m), axis (Vector3), amplitude_m.
Dictionary trial_dictionary(const steadyhand::Trial &p_trial);

steadyhand::Task task_of_trial(const steadyhand::Trial &p_trial);

/// Task of such a dictionary. nullopt, and one error in the log, if its amplitude_m is not above 0.
std::optional<steadyhand::Task> task_of_trial(const Dictionary &p_trial);

} // namespace godot
