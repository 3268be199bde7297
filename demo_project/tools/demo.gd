extends "tool.gd"
## godot --headless --path demo_project --script res://tools/demo.gd -- --out DIR
##     [--models DIR] [--real DIR]
##
## Runs trials of synthetic people, and those of real hands if they exist, through the real nodes
## and the scenes of their tasks; prints one table. Writes into DIR: evaluation/SET and
## evaluation_paper/SET (as evaluate.gd), logs/SET/GESTURE and table.md. For one unstable trial:
## vibration.wav, vibration.curves.csv, and vibration.json with the texts of their picture. A second
## run of the scene makes these, and logs to replays/, which the study leaves out.

const Evaluation := preload("evaluation.gd")
const ModelFolder := preload("model_folder.gd")
const Repository := preload("repository.gd")
const ResultTable := preload("result_table.gd")
const ScenePlayer := preload("scene_player.gd")
const Stored := preload("res://scripts/stored.gd")
const Tasks := preload("res://scripts/tasks.gd")

## The gesture and the position of the trial whose vibration is kept, as in the paper's Fig. 6.
const SHOWN_GESTURE := "horizontal_drag"
const SHOWN_POSITION := "unstable"
const SUBJECTS := 6
const TRIALS_PER_SUBJECT := 3

var _models: Array[GestureModel] = []
var _models_folder := ""
var _out := ""
var _table := ResultTable.new()


func work(arguments: PackedStringArray) -> void:
	var options := CommandLine.new(
		arguments, {out = "", models = ModelFolder.default_path(), real = ""}
	)
	_out = options.path("out")
	_models_folder = options.path("models")
	var real := options.optional_path("real")
	if real.is_empty() and DirAccess.dir_exists_absolute(Repository.REAL_DRAGS):
		real = Repository.absolute(Repository.REAL_DRAGS)
	if not options.error.is_empty():
		fail(options.error, EXIT_BAD_INPUT)
		return
	_models = ModelFolder.load_all(_models_folder)
	var synthetic := _out.path_join("synthetic")
	var sets: Dictionary[String, String] = {"synthetic": synthetic}
	if not real.is_empty():
		sets["real"] = real
	if _models.is_empty() or not _make_synthetic_trials(synthetic):
		exit_code = EXIT_BAD_INPUT
		return
	exit_code = 0
	# The last set is of real hands, if there are any.
	var shown_set: String = sets.keys()[-1]
	for set_name in sets:
		_run_set(set_name, sets[set_name], set_name == shown_set)
	_table.show()
	_table.save_markdown(_out.path_join("table.md"))


func _make_synthetic_trials(folder: String) -> bool:
	var options := {
		population = "evaluate",
		gestures = Tasks.SCENES.keys(),
		subjects = SUBJECTS,
		trials_per_subject = TRIALS_PER_SUBJECT,
	}
	return TrialSet.write_synthetic(folder, options) == OK


func _run_set(set_name: String, folder: String, is_shown: bool) -> void:
	var trial_set := TrialSet.load_folder(folder)
	if trial_set == null:
		exit_code = EXIT_BAD_INPUT
		return
	var phase_folder := _out.path_join("evaluation").path_join(set_name)
	var paper_folder := _out.path_join("evaluation_paper").path_join(set_name)
	print("%s: %d trials through the nodes" % [set_name, trial_set.get_count()])
	var phase := _evaluate(trial_set, "phase", phase_folder)
	print("%s: the same in `paper` mode" % set_name)
	var paper := _evaluate(trial_set, "paper", paper_folder)
	if not phase.error.is_empty() or not paper.error.is_empty():
		fail(phase.error + paper.error, EXIT_BAD_INPUT)
		return
	if not phase.shortcoming().is_empty():
		fail(phase.shortcoming(), EXIT_INCOMPLETE)
	_table.add(set_name, phase.groups, paper.groups)
	for gesture in Tasks.SCENES:
		_play_scene(set_name, trial_set, gesture, phase.left_out)
	var shown := phase.typical_trial(SHOWN_GESTURE, SHOWN_POSITION)
	if is_shown and not shown.is_empty():
		_keep_vibration(trial_set, shown, phase_folder)


func _evaluate(trial_set: TrialSet, mode: String, folder: String) -> Evaluation:
	var settings := {
		mode = mode,
		context = Evaluation.CONTEXTS[0],
		models = _models_folder,
		trials = trial_set.get_path(),
	}
	var evaluation := Evaluation.new()
	evaluation.run(trial_set, _models, settings, folder, root)
	return evaluation


func _play_scene(
	set_name: String, trial_set: TrialSet, gesture: String, left_out: Array[String]
) -> void:
	var log_folder := _out.path_join("logs").path_join(set_name).path_join(gesture)
	var player := ScenePlayer.new(Tasks.SCENES[gesture], log_folder, root)
	var played_s := player.play_all(trial_set, gesture, left_out)
	if played_s > 0.0:
		print(
			(
				"%s: %s played in its scene, %.0f times as fast as real time"
				% [set_name, gesture, played_s / player.taken_s]
			)
		)
	player.free_scene()


func _keep_vibration(trial_set: TrialSet, trial_name: String, evaluation_folder: String) -> void:
	var player := ScenePlayer.new(Tasks.SCENES[SHOWN_GESTURE], _out.path_join("replays"), root)
	var played := player.play_to_wav(trial_set, trial_name, _out.path_join("vibration.wav"))
	player.free_scene()
	var file := FileAccess.open(_out.path_join("vibration.json"), FileAccess.WRITE)
	if file != null:
		file.store_line(JSON.stringify(played, "\t"))
	if file == null or not Stored.is_written(file):
		fail("cannot write %s" % _out.path_join("vibration.json"), EXIT_BAD_INPUT)
	DirAccess.copy_absolute(
		evaluation_folder.path_join("%s.curves.csv" % trial_name),
		_out.path_join("vibration.curves.csv")
	)
