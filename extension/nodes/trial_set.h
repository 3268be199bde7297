#pragma once

#include "gesture/trainer.h"
#include "tracking/trial_set.h"

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/variant/dictionary.hpp>

#include <vector>

namespace godot {

/// A folder of trials: `trials.csv`, and two track CSVs for each of its rows. Tracks are read on demand.
class TrialSet : public RefCounted {
	GDCLASS(TrialSet, RefCounted)

	String path_;
	std::vector<steadyhand::Trial> trials_;
	int left_out_ = 0;

	static String track_path(const String &p_folder, const steadyhand::Trial &p_trial, const char *p_kind);

protected:
	static void _bind_methods();

public:
	const std::vector<steadyhand::Trial> &core() const { return trials_; }
	String get_path() const { return path_; }
	/// Reads both tracks of a trial. Errors name the file.
	steadyhand::Result<steadyhand::TrainingRecording> read_recording(const steadyhand::Trial &p_trial) const;

	int get_count() const { return static_cast<int>(trials_.size()); }
	/// Invalid rows of trials.csv.
	int get_left_out_count() const { return left_out_; }
	Dictionary get_trial(int p_index) const;
	String get_measured_path(int p_index) const;
	String get_reference_path(int p_index) const;

	/// Null, and one error in the log, if trials.csv is missing or no table of trials. One error for each
	/// invalid row, which is left out.
	static Ref<TrialSet> load_folder(const String &p_path);
	/// Options, all optional: population, subjects, trials_per_subject, gestures, paces, duration,
	/// earlier_rounds.
	static Error write_synthetic(const String &p_path, const Dictionary &p_options);
};

} // namespace godot
