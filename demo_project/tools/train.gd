extends "tool.gd"
## godot --headless --path demo_project --script res://tools/train.gd -- --trials DIR --gesture
## NAME --out FILE
##
## trains one model. Or, to make the add-on's own models again from synthetic people (equal
## input, equal bits):
##
## godot --headless --path demo_project --script res://tools/train.gd -- --models DIR --work DIR

## What the add-on brings a model of, and how much it is trained on.
const GESTURES: PackedStringArray = ["horizontal_drag", "vertical_drag"]
const SUBJECTS := 12
const TRIALS_PER_SUBJECT := 6

var _tenths_shown := 0


func work(arguments: PackedStringArray) -> void:
	var options := CommandLine.new(
		arguments, {trials = "", gesture = "", out = "", models = "", work = ""}
	)
	var is_own_set := options.optional_path("models") != "" or options.optional_path("work") != ""
	var done := (
		_train_own_models(options.path("models"), options.path("work"), options)
		if is_own_set
		else _train_one(options.path("trials"), options.path("out"), options)
	)
	if not options.error.is_empty():
		fail(options.error, EXIT_BAD_INPUT)
	else:
		exit_code = 0 if done else EXIT_BAD_INPUT


func _train_one(trials_folder: String, out_file: String, options: CommandLine) -> bool:
	var gesture := options.text("gesture")
	if gesture.is_empty() and options.error.is_empty():
		options.error = "--gesture NAME is missing"
	if not options.error.is_empty():
		return false
	return _train(trials_folder, gesture, out_file)


func _train_own_models(models_folder: String, work_folder: String, options: CommandLine) -> bool:
	if not options.error.is_empty():
		return false
	var trials_folder := work_folder.path_join("train")
	print("making synthetic trials in %s" % trials_folder)
	var made := (
		TrialSet
		. write_synthetic(
			work_folder,
			{
				population = "train",
				gestures = GESTURES,
				subjects = SUBJECTS,
				trials_per_subject = TRIALS_PER_SUBJECT,
			}
		)
	)
	if made != OK:
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
	var saved := ResourceSaver.save(model, out_file)
	if saved != OK:
		fail("cannot write %s: %s" % [out_file, error_string(saved)], EXIT_BAD_INPUT)
		return false
	print("wrote %s" % out_file)
	return true


## A line at every tenth.
func _show_progress(done: float) -> void:
	var tenths := floori(10.0 * done)
	if tenths > _tenths_shown:
		print("  %d %%" % (10 * tenths))
	_tenths_shown = tenths
