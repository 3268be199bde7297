extends RefCounted
## Runs a trial set through the real nodes and reports it.

const EvaluationReport := preload("evaluation_report.gd")
const Progress := preload("progress.gd")
const TrialRun := preload("trial_run.gd")

## By their names on the command line; the first is the default.
const MODES: Dictionary[String, GestureHMM.Mode] = {
	"phase": GestureHMM.MODE_PHASE, "paper": GestureHMM.MODE_PAPER
}
const CONTEXTS: Array[String] = ["scene", "open"]

## Trials whose tracks could not be read; they are in no file of the report.
var broken := 0
## Nothing could be written; empty when all is well.
var error := ""
## As in EvaluationReport.
var groups: Array[Dictionary] = []

var _report: EvaluationReport = null


## `settings`: {mode, context, models}, which are also written down; `parent`: a node in the tree.
func run(
	trial_set: TrialSet,
	models: Array[GestureModel],
	settings: Dictionary,
	out_folder: String,
	parent: Node
) -> void:
	_note_gestures_without_model(trial_set, models)
	var report := EvaluationReport.new(out_folder)
	var progress := Progress.new("%d trials" % trial_set.get_count())
	for index in trial_set.get_count():
		if not report.error.is_empty():
			break
		var trial := trial_set.get_trial(index)
		var trial_run := TrialRun.new(trial, parent)
		if trial["gesture"] == TrialRun.NO_GESTURE:
			trial_run.task_trial = _task_to_wait_for(trial_set, models, trial["position"], index)
		trial_run.run(
			trial_set.get_measured_path(index),
			trial_set.get_reference_path(index),
			models,
			MODES[settings["mode"]],
			settings["context"] == "scene"
		)
		if trial_run.error.is_empty():
			report.add(trial, trial_run)
		else:
			printerr("trial %s left out: %s" % [trial["trial"], trial_run.error])
			broken += 1
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


## Name of the trial whose measured curve has the median R2 at zero lag; empty without such trials.
func typical_trial(gesture: String, position: String) -> String:
	return _report.typical_trial(gesture, position)


## While a hand does nothing a scene waits all the same: for the task of one of the set's other
## trials at that position, each in turn. Empty where there is none.
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


static func _note_gestures_without_model(trial_set: TrialSet, models: Array[GestureModel]) -> void:
	var without: Dictionary[String, int] = {}
	for index in trial_set.get_count():
		var gesture: String = trial_set.get_trial(index)["gesture"]
		if (
			gesture != TrialRun.NO_GESTURE
			and not models.any(func(model: GestureModel) -> bool: return model.gesture == gesture)
		):
			without[gesture] = without.get(gesture, 0) + 1
	for gesture: String in without:
		print("no model of '%s': its %d trials get no figures" % [gesture, without[gesture]])
