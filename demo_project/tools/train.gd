extends "tool.gd"
## Trains one model:
##
## godot --headless --path demo_project --script res://tools/train.gd --
##     --trials DIR --gesture NAME --out FILE [--report DIR]
##     [--feature NAME] (default: the one that fits the trials)
##     [--r2-threshold T_H] (default: GestureTrainer's)
##
## or, without these, the add-on's own models from synthetic people (equal bits on every run):
##     [--models DIR] (default: the repository's models/)
##     [--work DIR] for their trials (default: the repository's build/)
##     [--report DIR]
##
## Writes GESTURE.recordings.csv into --report, for the model's picture: a row per recording,
## `trial,kept,r2,` and its normalised curve.

const NextStep := preload("res://addons/steadyhand/editor/gestures/next_step.gd")
const OwnModels := preload("own_models.gd")
const Progress := preload("progress.gd")
const Repository := preload("repository.gd")
const Stored := preload("res://scripts/stored.gd")

const MODEL_ENDING := ".gesture"

## Number of recordings unlike the others whose names are listed.
const MOST_NAMES := 20

var _report_folder := ""
var _r2_threshold := GestureTrainer.new().r2_threshold


func work(arguments: PackedStringArray) -> void:
	var defaults: Dictionary[String, String] = {
		trials = "",
		gesture = "",
		out = "",
		feature = "",
		models = Repository.absolute(Repository.MODELS),
		work = Repository.absolute(Repository.BUILD),
		report = "",
	}
	defaults["r2-threshold"] = ""
	var options := CommandLine.new(arguments, defaults)
	_report_folder = options.optional_path("report")
	var is_own_set := true
	for option: String in ["trials", "gesture", "out", "feature", "r2-threshold"]:
		is_own_set = is_own_set and options.text(option).is_empty()
	if not options.text("r2-threshold").is_empty():
		_r2_threshold = options.number("r2-threshold", 0.0, 1.0, "share of the variance")
	var done := false
	if is_own_set:
		var models_folder := options.path("models")
		var work_folder := options.path("work")
		done = options.error.is_empty() and _train_own_models(models_folder, work_folder)
	else:
		var trials_folder := options.path("trials")
		var gesture := options.given("gesture")
		var out_file := options.path("out")
		done = (
			options.error.is_empty()
			and _is_model_file(out_file)
			and _train(
				TrialSet.load_folder(trials_folder), gesture, out_file, options.text("feature")
			)
		)
	exit_code = 0 if done else EXIT_BAD_INPUT
	if not options.error.is_empty():
		fail(options.error, EXIT_BAD_INPUT)


## The engine saves only files whose ending it knows.
func _is_model_file(path: String) -> bool:
	var is_one := path.ends_with(MODEL_ENDING)
	if not is_one:
		printerr("train: --out is '%s': a model's name ends in %s" % [path, MODEL_ENDING])
	return is_one


func _train_own_models(models_folder: String, work_folder: String) -> bool:
	var trials_folder := work_folder.path_join("train")
	print("making synthetic trials in %s" % trials_folder)
	var trial_set := OwnModels.write_trials(trials_folder)
	for gesture in OwnModels.GESTURES:
		var out_file := models_folder.path_join(gesture + ".gesture")
		if not _train(trial_set, gesture, out_file, "", true):
			return false
	var classifier_file := models_folder.path_join(OwnModels.CLASSIFIER)
	print("training %s, which the next build puts into the add-on" % OwnModels.CLASSIFIER)
	if not _can_write(classifier_file):
		return false
	return GestureTrainer.write_own_classifier(classifier_file) == OK


func _train(
	trial_set: TrialSet, gesture: String, out_file: String, feature: String = "", is_own := false
) -> bool:
	if trial_set == null or not _can_write(out_file):
		return false
	if trial_set.get_left_out_count() > 0:
		printerr("train: correct or remove the rows above first")
		return false
	var progress := Progress.new("training %s" % gesture)
	var trainer := GestureTrainer.new()
	trainer.feature = feature
	trainer.r2_threshold = _r2_threshold
	trainer.without_task = not is_own
	trainer.progressed.connect(progress.show)
	var model := trainer.train(trial_set, gesture)
	if model == null:
		return false
	_report_oddities(trainer, trial_set)
	if not _report_folder.is_empty() and not _report_recordings(trainer, gesture):
		return false
	var saved := ResourceSaver.save(model, out_file)
	if saved != OK:
		printerr("train: cannot write %s: %s" % [out_file, error_string(saved)])
		return false
	var recordings := trainer.get_recordings()
	var kept: int = model.get_provenance()["recordings"]
	print(
		(
			"wrote %s, by %s, from %d of %d recordings"
			% [out_file, model.get_feature(), kept, recordings.size()]
		)
	)
	_report_unlike(recordings, kept)
	if kept < NextStep.ENOUGH_TAKES:
		printerr(
			(
				"train: %d recordings are too few to learn how much hands differ: record %d or more"
				% [kept, NextStep.ENOUGH_TAKES]
			)
		)
	return true


## Reports recordings that are left out, and odd ones that are used.
func _report_oddities(trainer: GestureTrainer, trial_set: TrialSet) -> void:
	var indices: Dictionary[String, int] = {}
	for i in trial_set.get_count():
		indices[trial_set.get_trial(i)["trial"]] = i
	for recording in trainer.get_recordings():
		var oddity: String = recording["oddity"]
		if oddity.is_empty():
			continue
		var trial: String = recording["trial"]
		var index := indices[trial]
		var is_of_reference := oddity.begins_with("its reference")
		var paths := [trial_set.get_measured_path(index), trial_set.get_reference_path(index)]
		var path: String = paths[int(is_of_reference)]
		var is_named := oddity.contains(trial_set.get_path())
		var what := "trial %s is left out" if _is_left_out(recording) else "trial %s"
		printerr("%s: %s%s" % [what % trial, oddity, "" if is_named else ": " + path])


func _report_unlike(recordings: Array[Dictionary], kept: int) -> void:
	var unlike: Array[String] = []
	for recording in recordings:
		if not recording["kept"] and not _is_left_out(recording):
			unlike.append("%s (%.2f)" % [recording["trial"], recording["r2"]])
	if unlike.is_empty():
		return
	var names := ", ".join(unlike.slice(0, MOST_NAMES))
	var more := unlike.size() - MOST_NAMES
	printerr(
		(
			"train: %d of %d are less like the mean of all than R2 %s: %s%s"
			% [
				unlike.size(),
				recordings.size(),
				_r2_threshold,
				names,
				" and %d more" % more if more > 0 else ""
			]
		)
	)
	if 2 * kept < recordings.size():
		printerr(
			(
				"train: these are most of them. If hands really differ so much, lower --r2-threshold. "
				+ "Otherwise check the times of the trials, and the feature"
			)
		)


func _is_left_out(recording: Dictionary) -> bool:
	return (recording["curve"] as PackedFloat64Array).is_empty()


## Checked before the training, because that takes long.
func _can_write(out_file: String) -> bool:
	var folder := out_file.get_base_dir()
	DirAccess.make_dir_recursive_absolute(folder)
	# If a file has this name, the engine reports success.
	if not DirAccess.dir_exists_absolute(folder):
		printerr("train: cannot make the folder %s" % folder)
		return false
	var probe := out_file + ".part"
	if FileAccess.open(probe, FileAccess.WRITE) == null:
		printerr("train: cannot write %s" % out_file)
		return false
	DirAccess.remove_absolute(probe)
	return true


func _report_recordings(trainer: GestureTrainer, gesture: String) -> bool:
	DirAccess.make_dir_recursive_absolute(_report_folder)
	var path := _report_folder.path_join("%s.recordings.csv" % gesture)
	var file := FileAccess.open(path, FileAccess.WRITE)
	if file == null:
		printerr("cannot write %s: %s" % [path, error_string(FileAccess.get_open_error())])
		return false
	for recording in trainer.get_recordings():
		if _is_left_out(recording):
			continue
		var row := PackedStringArray([recording["trial"]])
		row.append("1" if recording["kept"] else "0")
		row.append("%.6f" % recording["r2"])
		for value: float in recording["curve"]:
			row.append("%.6f" % value)
		file.store_csv_line(row)
	if not Stored.is_written(file):
		printerr("cannot write %s: is the disk full?" % path)
		return false
	return true
