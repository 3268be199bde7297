#include "trial_dictionary.h"

#include "conversions.h"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cmath>

namespace godot {

Dictionary trial_dictionary(const steadyhand::Trial &p_trial) {
	Dictionary dictionary;
	dictionary["trial"] = to_godot(p_trial.trial);
	dictionary["gesture"] = StringName(to_godot(p_trial.gesture));
	dictionary["position"] = to_godot(steadyhand::position_name(p_trial.position));
	dictionary["subject"] = to_godot(p_trial.subject);
	dictionary["start_s"] = p_trial.start_s;
	dictionary["end_s"] = p_trial.end_s;
	dictionary["start"] = to_godot(p_trial.start_m);
	dictionary["axis"] = to_godot(p_trial.axis);
	dictionary["amplitude_m"] = p_trial.amplitude_m;
	return dictionary;
}

steadyhand::Task task_of_trial(const steadyhand::Trial &p_trial) {
	return { p_trial.start_m, p_trial.axis, p_trial.amplitude_m };
}

std::optional<steadyhand::Task> task_of_trial(const Dictionary &p_trial) {
	const double amplitude_m = p_trial.get("amplitude_m", 0.0);
	ERR_FAIL_COND_V_MSG(!(amplitude_m > 0.0) || !std::isfinite(amplitude_m), std::nullopt,
			"the trial's amplitude_m must be above 0; take the dictionary from TrialSet.get_trial()");
	return steadyhand::Task{ to_core(Vector3(p_trial.get("start", Vector3()))),
		to_core(Vector3(p_trial.get("axis", Vector3()))), amplitude_m };
}

} // namespace godot
