extends RefCounted
## Runs a trial set through the real nodes and reports it.

const EvaluationReport := preload("evaluation_report.gd")
const EvaluationTable := preload("evaluation_table.gd")
const Progress := preload("progress.gd")
const TrialRun := preload("trial_run.gd")

## By name on the command line; the first is the default.
const MODES: Dictionary[String, GestureHMM.Mode] = {
	"phase": GestureHMM.MODE_PHASE, "paper": GestureHMM.MODE_PAPER
}
const CONTEXTS: Array[String] = ["scene", "open"]

const TRAINED_ON := (
	"the model of '%s' was trained on these trials. On other recordings the figures are worse."
	+ " Evaluate it on recordings of other people"
)
const ONE_TRACK := "%s with equal measured and reference tracks, which hide the tracker's errors"

## Trials that could not be evaluated; they are in no file of the report.
var broken := 0
## Names of these trials, if they have a row in the set.
var left_out: Array[String] = []
## Trials of a gesture without a model. They have a row and curves, but no figures.
var without_model := 0
## Why nothing could be written. Empty: no error.
var error := ""
## As in EvaluationReport.
var groups: Array[Dictionary] = []

var _report: EvaluationReport = null
var _is_empty := false
## What limits the meaning of all figures, for the terminal.
var _notes := PackedStringArray()
## Gestures without a model that were reported.
var _without_model: Array[String] = []


## `settings`: {mode, context, models}, and sensor_latency_s and min_confidence if they differ from
## the node's defaults; all are written into the report. `parent`: a node in the tree.
func run(
	trial_set: TrialSet,
	models: Array[GestureModel],
	settings: Dictionary,
	out_folder: String,
	parent: Node
) -> void:
	var defaults := {
		sensor_latency_s = default_of(&"sensor_latency"),
		min_confidence = default_of(&"min_confidence"),
	}
	settings = settings.merged(defaults)
	broken = trial_set.get_left_out_count()
	_is_empty = trial_set.get_count() == 0
	if _is_empty:
		if broken == 0:
			printerr("no row in %s" % trial_set.get_path().path_join("trials.csv"))
		return
	_notes = _limits(trial_set, models)
	var report := EvaluationReport.new(out_folder)
	var progress := Progress.new(_trials(trial_set.get_count()))
	for index in trial_set.get_count():
		if not report.error.is_empty():
			break
		var trial := trial_set.get_trial(index)
		var trial_run := TrialRun.new(trial, parent)
		trial_run.sensor_latency_s = settings["sensor_latency_s"]
		trial_run.min_confidence = settings["min_confidence"]
		if trial["gesture"] == TrialRun.NO_GESTURE:
			trial_run.task_trial = _task_to_wait_for(trial_set, models, trial["position"], index)
		trial_run.run(
			trial_set.get_measured_path(index),
			trial_set.get_reference_path(index),
			models,
			MODES[settings["mode"]],
			settings["context"] == "scene"
		)
		if not trial_run.error.is_empty():
			if not trial_run.is_reported:
				printerr("trial %s left out: %s" % [trial["trial"], trial_run.error])
			left_out.append(trial["trial"])
			broken += 1
		else:
			report.add(trial, trial_run)
			if not trial_run.note.is_empty():
				printerr("trial %s: %s" % [trial["trial"], trial_run.note])
			if trial["gesture"] != TrialRun.NO_GESTURE and trial_run.figures.is_empty():
				_report_missing_model(trial["gesture"], settings["models"])
				without_model += 1
		progress.show(float(index + 1) / trial_set.get_count())
	if report.error.is_empty():
		var versions := {
			version = GestureTrainer.get_version(),
			godot = Engine.get_version_info()["string"],
		}
		report.finish(settings.merged(versions))
	groups = report.groups
	error = report.error
	_report = report


## Summary of the trials without a full report; details were printed before. Empty: all are
## complete.
func shortcoming() -> String:
	if _is_empty:
		return "there was no trial to run" + (", see above" if broken > 0 else "")
	var parts := PackedStringArray()
	if broken > 0:
		parts.append("%s left out" % _trials(broken))
	if without_model > 0:
		parts.append("%s without figures" % _trials(without_model))
	return "" if parts.is_empty() else "%s, see above" % ", ".join(parts)


## The results as text for the terminal. Empty: nothing is written.
func get_text() -> String:
	if _is_empty or not error.is_empty():
		return ""
	var text := "\n%s\n" % EvaluationTable.text(groups)
	if _report.none_s > 0.0:
		var alarms := _report.false_alarms.size()
		text += (
			"trials without a gesture: %s in %.2f minutes, %.2f a minute\n"
			% [
				"1 false alarm" if alarms == 1 else "%d false alarms" % alarms,
				_report.none_s / 60.0,
				MotionMetrics.false_alarms_per_minute(alarms, _report.none_s)
			]
		)
	for note in _notes:
		text += "note: %s\n" % note
	return text + _report.get_result()


## Name of the trial whose measured curve has the median zero-lag R2. Empty: no such trials.
func typical_trial(gesture: String, position: String) -> String:
	return "" if _report == null else _report.typical_trial(gesture, position)


## Recordings that a model has learned from, and trials without a reference of their own.
static func _limits(trial_set: TrialSet, models: Array[GestureModel]) -> PackedStringArray:
	var notes := PackedStringArray()
	var number_of: Dictionary[String, int] = {}
	var with_one_track := 0
	for index in trial_set.get_count():
		var gesture: String = trial_set.get_trial(index)["gesture"]
		number_of[gesture] = number_of.get(gesture, 0) + 1
		var measured := trial_set.get_measured_path(index)
		var reference := trial_set.get_reference_path(index)
		var exist := FileAccess.file_exists(measured) and FileAccess.file_exists(reference)
		if gesture != TrialRun.NO_GESTURE and exist:
			with_one_track += int(_are_equal(measured, reference))
	for model in models:
		var learned := model.get_provenance()
		var total: int = learned["recordings"] + learned["dropped"].size()
		var is_same: bool = learned["trial_set"] == trial_set.get_path().get_file()
		if is_same and total == number_of.get(String(model.gesture), 0):
			notes.append(TRAINED_ON % model.gesture)
	if with_one_track > 0:
		notes.append(ONE_TRACK % _trials(with_one_track))
	return notes


## Files of different lengths are not read.
static func _are_equal(one: String, other: String) -> bool:
	return _length(one) == _length(other) and FileAccess.get_md5(one) == FileAccess.get_md5(other)


static func _length(path: String) -> int:
	var file := FileAccess.open(path, FileAccess.READ)
	return -1 if file == null else file.get_length()


## Reported once for all trials of the gesture.
func _report_missing_model(gesture: String, models_folder: String) -> void:
	if not gesture in _without_model:
		_without_model.append(gesture)
		var where := ProjectSettings.globalize_path(models_folder)
		printerr("trials of '%s' have no figures: no model of it in %s" % [gesture, where])


## The default of GestureHMM.
static func default_of(property: StringName) -> float:
	return ClassDB.class_get_property_default_value(&"GestureHMM", property)


## The task of a trial without a gesture: trial number `turn` of those with a gesture at this
## position, in a cycle. Empty if there is none.
static func _task_to_wait_for(
	trial_set: TrialSet, models: Array[GestureModel], position: String, turn: int
) -> Dictionary:
	var tasks: Array[Dictionary] = []
	for index in trial_set.get_count():
		var trial := trial_set.get_trial(index)
		if (
			trial["position"] == position
			and models.any(
				func(model: GestureModel) -> bool: return model.gesture == trial["gesture"]
			)
		):
			tasks.append(trial)
	return {} if tasks.is_empty() else tasks[turn % tasks.size()]


static func _trials(number: int) -> String:
	return "1 trial" if number == 1 else "%d trials" % number
