extends "tool.gd"
## Trains one model:
##
## godot --headless --path demo_project --script res://tools/train.gd --
##     --trials DIR --gesture NAME --out FILE [--report DIR]
##     [--feature NAME] (default: the one that goes the trials' way)
##
## or, without these, the add-on's own models from synthetic people (equal bits on every run):
##     [--models DIR] (default: the repository's models/)
##     [--work DIR] for their trials (default: the repository's build/)
##     [--report DIR]
##
## Leaves in --report for each gesture GESTURE.recordings.csv, what the model's picture is drawn
## from: a row a recording, `trial,kept,r2,` and its normalised curve.

const OwnModels := preload("own_models.gd")
const Progress := preload("progress.gd")
const Repository := preload("repository.gd")
const Stored := preload("res://scripts/stored.gd")

const MODEL_ENDING := ".gesture"

var _report_folder := ""


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
	var options := CommandLine.new(arguments, defaults)
	_report_folder = options.optional_path("report")
	var is_own_set := true
	for option: String in ["trials", "gesture", "out", "feature"]:
		is_own_set = is_own_set and options.text(option).is_empty()
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


## The engine tells by a file's ending what is in it, and saves nothing where it does not know it.
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
		if not _train(trial_set, gesture, models_folder.path_join(gesture + ".gesture")):
			return false
	return true


func _train(trial_set: TrialSet, gesture: String, out_file: String, feature: String = "") -> bool:
	if trial_set == null or not _can_write(out_file):
		return false
	if trial_set.get_left_out_count() > 0:
		printerr("train: mend or remove the rows above first")
		return false
	var progress := Progress.new("training %s" % gesture)
	var trainer := GestureTrainer.new()
	trainer.feature = feature
	trainer.progressed.connect(progress.show)
	var model := trainer.train(trial_set, gesture)
	if model == null:
		return false
	_tell_of_oddities(trainer, trial_set, model)
	if not _report_folder.is_empty() and not _report_recordings(trainer, gesture):
		return false
	var saved := ResourceSaver.save(model, out_file)
	if saved != OK:
		printerr("train: cannot write %s: %s" % [out_file, error_string(saved)])
		return false
	var kept := trainer.get_recordings().filter(
		func(recording: Dictionary) -> bool: return recording["kept"]
	)
	var of := 0
	for i in trial_set.get_count():
		of += 1 if trial_set.get_trial(i)["gesture"] == gesture else 0
	print(
		(
			"wrote %s, by %s, from %d of %d recordings"
			% [out_file, model.get_feature(), kept.size(), of]
		)
	)
	if 2 * kept.size() < of:
		printerr(
			(
				(
					"train: most recordings of '%s' are not like their mean, or do not move; "
					+ "check their times, and the feature"
				)
				% gesture
			)
		)
	return true


## What is learnt from all the same, and what nothing is learnt from.
func _tell_of_oddities(trainer: GestureTrainer, trial_set: TrialSet, model: GestureModel) -> void:
	var oddities: Dictionary[String, String] = {}
	for recording in trainer.get_recordings():
		oddities[recording["trial"]] = recording["oddity"]
	var still := "its reference does not move by %s, nothing is learnt from it" % model.feature
	for i in trial_set.get_count():
		var trial := trial_set.get_trial(i)
		if trial["gesture"] != model.gesture:
			continue
		var oddity: String = oddities.get(trial["trial"], still)
		if not oddity.is_empty():
			var is_of_reference := oddity.begins_with("its reference")
			var paths := [trial_set.get_measured_path(i), trial_set.get_reference_path(i)]
			printerr("trial %s: %s: %s" % [trial["trial"], oddity, paths[int(is_of_reference)]])


## Before the training, which takes longer than to tell.
func _can_write(out_file: String) -> bool:
	var folder := out_file.get_base_dir()
	DirAccess.make_dir_recursive_absolute(folder)
	# Where a file has its name the engine says that it was made.
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
