extends "tool.gd"
## Trains one model:
##
## godot --headless --path demo_project --script res://tools/train.gd --
##     --trials DIR --gesture NAME --out FILE
##
## or, without these, the add-on's own models from synthetic people (equal bits on every run):
##     [--models DIR] (default: the repository's models/)
##     [--work DIR] for their trials (default: the repository's build/)

const Repository := preload("repository.gd")

## What the add-on brings a model of, and how much it is trained on.
const GESTURES: PackedStringArray = ["horizontal_drag", "vertical_drag", "tap"]
const SUBJECTS := 12
const TRIALS_PER_SUBJECT := 6
## As the paper's subjects, who were asked for different speeds: as they like, fast, very fast.
const PACES: PackedFloat64Array = [1.0, 0.6, 0.4]

var _tenths_shown := 0


func work(arguments: PackedStringArray) -> void:
	var defaults: Dictionary[String, String] = {
		trials = "",
		gesture = "",
		out = "",
		models = Repository.absolute(Repository.MODELS),
		work = Repository.absolute(Repository.BUILD),
	}
	var options := CommandLine.new(arguments, defaults)
	var is_own_set := options.text("trials") + options.text("gesture") + options.text("out") == ""
	var done := false
	if is_own_set:
		var models_folder := options.path("models")
		var work_folder := options.path("work")
		done = options.error.is_empty() and _train_own_models(models_folder, work_folder)
	else:
		var trials_folder := options.path("trials")
		var gesture := options.given("gesture")
		var out_file := options.path("out")
		done = options.error.is_empty() and _train(trials_folder, gesture, out_file)
	exit_code = 0 if done else EXIT_BAD_INPUT
	if not options.error.is_empty():
		fail(options.error, EXIT_BAD_INPUT)


func _train_own_models(models_folder: String, work_folder: String) -> bool:
	var trials_folder := work_folder.path_join("train")
	print("making synthetic trials in %s" % trials_folder)
	var options := {
		population = "train",
		gestures = GESTURES,
		subjects = SUBJECTS,
		trials_per_subject = TRIALS_PER_SUBJECT,
		paces = PACES,
	}
	if TrialSet.write_synthetic(trials_folder, options) != OK:
		return false
	for gesture in GESTURES:
		if not _train(trials_folder, gesture, models_folder.path_join(gesture + ".gesture")):
			return false
	return true


func _train(trials_folder: String, gesture: String, out_file: String) -> bool:
	var trial_set := TrialSet.load_folder(trials_folder)
	if trial_set == null:
		return false
	print("training '%s' on %s" % [gesture, trials_folder])
	var trainer := GestureTrainer.new()
	trainer.progressed.connect(_show_progress)
	var model := trainer.train(trial_set, gesture)
	if model == null:
		return false
	DirAccess.make_dir_recursive_absolute(out_file.get_base_dir())
	if ResourceSaver.save(model, out_file) != OK:
		return false
	print("wrote %s" % out_file)
	return true


## A line at every tenth.
func _show_progress(done: float) -> void:
	var tenths := floori(10.0 * done)
	if tenths > _tenths_shown:
		print("  %d %%" % (10 * tenths))
	_tenths_shown = tenths
