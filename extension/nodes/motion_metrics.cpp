#include "motion_metrics.h"

#include "conversions.h"
#include "node_label.h"
#include "trial_dictionary.h"

#include "gesture/motion_element.h"
#include "gesture/recording_oddity.h"
#include "metrics/curve_comparison.h"
#include "metrics/recognition.h"
#include "metrics/summary.h"

#include <godot_cpp/core/class_db.hpp>

#include <cmath>

namespace godot {

namespace {

/// Limit of a curve: eight hours at 1 kHz, which take 240 MB. `./steadyhand evaluate` uses at most six hours.
constexpr int64_t MOST_SAMPLES = 30'000'000;
/// Limit of a confusion table, which has a cell for each pair: 8 MB.
constexpr int64_t MOST_GESTURES = 1000;

} // namespace

Dictionary MotionMetrics::compare(const PackedFloat64Array &p_reference, const PackedFloat64Array &p_curve,
		double p_rate_hz, double p_t0_s, double p_start_s, double p_end_s) {
	ERR_FAIL_COND_V_MSG(!(p_rate_hz > 0.0), Dictionary(),
			refusal("MotionMetrics.compare", "rate_hz must be above 0", p_rate_hz));
	ERR_FAIL_COND_V_MSG(p_reference.size() != p_curve.size(), Dictionary(),
			String("MotionMetrics.compare: both curves must have the same number of samples, not ") +
					itos(p_reference.size()) + String(" and ") + itos(p_curve.size()));
	const steadyhand::CurveComparison comparison = steadyhand::compare_curves(
			to_core(p_reference), to_core(p_curve), { p_t0_s, p_rate_hz }, { p_start_s, p_end_s });
	Dictionary dictionary;
	dictionary["r2"] = comparison.r2;
	dictionary["r2_zero"] = comparison.r2_zero;
	dictionary["lag"] = comparison.lag_s;
	dictionary["t_diff"] = comparison.t_diff_s;
	dictionary["sparc"] = comparison.sparc;
	dictionary["missed"] = comparison.missed;
	return dictionary;
}

Dictionary MotionMetrics::summarise(const PackedFloat64Array &p_values) {
	const std::span<const double> values = to_core(p_values);
	Dictionary dictionary;
	dictionary["mean"] = steadyhand::mean(values);
	dictionary["median"] = steadyhand::percentile(values, 50.0);
	dictionary["p2_5"] = steadyhand::percentile(values, 2.5);
	dictionary["p5"] = steadyhand::percentile(values, 5.0);
	dictionary["p95"] = steadyhand::percentile(values, 95.0);
	dictionary["p97_5"] = steadyhand::percentile(values, 97.5);
	return dictionary;
}

PackedFloat64Array MotionMetrics::feature_curve(const Ref<RecordedTrack> &p_track, const String &p_feature,
		const Dictionary &p_trial, double p_t0_s, double p_rate_hz, int p_count) {
	PackedFloat64Array curve;
	ERR_FAIL_COND_V_MSG(!(p_rate_hz > 0.0) || !std::isfinite(p_rate_hz) || !std::isfinite(p_t0_s), curve,
			"MotionMetrics.feature_curve: rate_hz must be above 0 and t0 finite");
	ERR_FAIL_COND_V_MSG(p_count < 0 || p_count > MOST_SAMPLES, curve,
			String("MotionMetrics.feature_curve: count must be in 0..") + itos(MOST_SAMPLES) +
					String(", is ") + itos(p_count));
	const steadyhand::Feature *feature = steadyhand::find_feature(to_core(p_feature));
	ERR_FAIL_NULL_V_MSG(feature, curve,
			String("MotionMetrics: no feature '") + p_feature + String("'; see GestureTrainer.feature"));
	const std::optional<steadyhand::Task> task = task_of_trial(p_trial);
	if (!task || p_track.is_null()) {
		return curve;
	}

	std::vector<double> times_s, values;
	steadyhand::MotionElement element(*feature);
	const double start_s = p_trial.get("start_s", 0.0);
	for (const steadyhand::HandFrame &frame : p_track->core().frames) {
		if (frame.t_s <= start_s) {
			element.restart();
		}
		if (const std::optional<double> value_m = element.measure(frame, *task)) {
			times_s.push_back(frame.t_s);
			values.push_back(*value_m / task->amplitude_m);
		}
	}
	curve.resize(p_count);
	steadyhand::resample_linear(times_s, values, { p_t0_s, p_rate_hz },
			std::span(curve.ptrw(), static_cast<std::size_t>(p_count)));
	return curve;
}

String MotionMetrics::recording_oddity(const Ref<RecordedTrack> &p_measured,
		const Ref<RecordedTrack> &p_reference, const String &p_feature, const Dictionary &p_trial) {
	const steadyhand::Feature *feature = steadyhand::find_feature(to_core(p_feature));
	ERR_FAIL_NULL_V_MSG(feature, String(),
			String("MotionMetrics: no feature '") + p_feature + String("'; see GestureTrainer.feature"));
	const std::optional<steadyhand::Task> task = task_of_trial(p_trial);
	if (!task || p_measured.is_null() || p_reference.is_null()) {
		return String();
	}
	steadyhand::TrainingRecording recording;
	recording.task = *task;
	recording.start_s = p_trial.get("start_s", 0.0);
	recording.end_s = p_trial.get("end_s", 0.0);
	recording.measured = p_measured->core();
	recording.reference = p_reference->core();
	return to_godot(steadyhand::oddity(*feature, recording));
}

Dictionary MotionMetrics::confusion(const PackedStringArray &p_done, const PackedStringArray &p_recognised) {
	ERR_FAIL_COND_V_MSG(p_done.size() != p_recognised.size(), Dictionary(),
			"MotionMetrics.confusion: done and recognised must have the same number of names");
	PackedStringArray names;
	for (const PackedStringArray &given : { p_done, p_recognised }) {
		for (const String &name : given) {
			if (name != String("none") && !names.has(name)) {
				ERR_FAIL_COND_V_MSG(names.size() == MOST_GESTURES, Dictionary(),
						String("MotionMetrics.confusion: more than ") + itos(MOST_GESTURES) +
								String(" different names; pass names of gestures"));
				names.push_back(name);
			}
		}
	}
	names.sort();
	// find() returns -1 for "none". As an unsigned index this is beyond the table's gestures, which means
	// none.
	steadyhand::ConfusionTable table(static_cast<std::size_t>(names.size()));
	for (int64_t i = 0; i < p_done.size(); ++i) {
		table.add(static_cast<std::size_t>(names.find(p_done[i])),
				static_cast<std::size_t>(names.find(p_recognised[i])));
	}
	names.push_back("none");
	Dictionary rows;
	for (int64_t done = 0; done < names.size(); ++done) {
		Dictionary row;
		for (int64_t recognised = 0; recognised < names.size(); ++recognised) {
			row[names[recognised]] = static_cast<int64_t>(
					table.count(static_cast<std::size_t>(done), static_cast<std::size_t>(recognised)));
		}
		if (table.trials(static_cast<std::size_t>(done)) > 0) {
			rows[names[done]] = row;
		}
	}
	return rows;
}

double MotionMetrics::false_alarms_per_minute(int p_alarms, double p_observed_s) {
	ERR_FAIL_COND_V_MSG(p_alarms < 0, 0.0,
			refusal("MotionMetrics.false_alarms_per_minute", "alarms must be 0 or more", p_alarms));
	return steadyhand::false_alarms_per_minute(static_cast<std::size_t>(p_alarms), p_observed_s);
}

void MotionMetrics::_bind_methods() {
	ClassDB::bind_static_method("MotionMetrics",
			D_METHOD("compare", "reference", "curve", "rate_hz", "t0_s", "start_s", "end_s"),
			&MotionMetrics::compare);
	ClassDB::bind_static_method("MotionMetrics", D_METHOD("summarise", "values"), &MotionMetrics::summarise);
	ClassDB::bind_static_method("MotionMetrics",
			D_METHOD("feature_curve", "track", "feature", "trial", "t0_s", "rate_hz", "count"),
			&MotionMetrics::feature_curve);
	ClassDB::bind_static_method("MotionMetrics",
			D_METHOD("recording_oddity", "measured", "reference", "feature", "trial"),
			&MotionMetrics::recording_oddity);
	ClassDB::bind_static_method(
			"MotionMetrics", D_METHOD("confusion", "done", "recognised"), &MotionMetrics::confusion);
	ClassDB::bind_static_method("MotionMetrics", D_METHOD("false_alarms_per_minute", "alarms", "observed_s"),
			&MotionMetrics::false_alarms_per_minute);
}

} // namespace godot
