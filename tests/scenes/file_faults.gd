extends "support/scene_test.gd"
## An evaluation and the demo report a bad file in one line, with file name and line number.

const Rig := preload("support/rig.gd")
const ToolRun := preload("support/tool_run.gd")
const Evaluation := preload("res://tools/evaluation.gd")
const ModelFolder := preload("res://tools/model_folder.gd")
const ScenePlayer := preload("res://tools/scene_player.gd")
const Tasks := preload("res://scripts/tasks.gd")

const TRACK := "t,index_x,index_y,index_z\n0,0,0,0\n1,0,0,0\n2,0,zero,0\n"

var _folder := DirAccess.create_temp("steadyhand_file_faults")


func test_a_broken_track_in_an_evaluation() -> void:
	var trials := Rig.write_trials(_path("trials"), 2)
	var name := _break_one(trials)
	var run := ToolRun.new("evaluate", ["--trials", _path("trials"), "--out", _path("out")])
	check_equal(run.exit_code, 1, "exit code")
	check_equal(_count(run, name), 1, "one line names it")
	check_equal(run.missing(["%s.measured.csv:4: index_y: 'zero'" % name]), "", "and its place")
	check_equal(run.missing(["evaluate: 1 trial left out, see above"]), "", "the number of trials")


func test_a_broken_track_in_the_demo() -> void:
	# expects one error: measured.csv:4
	var trials := Rig.write_trials(_path("demo"), 2)
	_break_one(trials)
	var evaluation := Evaluation.new()
	var settings := {mode = "phase", context = "scene", models = ModelFolder.INSTALLED}
	var models := ModelFolder.load_all(ModelFolder.INSTALLED)
	evaluation.run(trials, models, settings, _path("demo_out"), root)
	var player := ScenePlayer.new(Tasks.SCENES["horizontal_drag"], _path("logs"), root)
	var played_s := player.play_all(trials, "horizontal_drag", evaluation.left_out)
	player.free_scene()
	check(played_s > 0.0, "the other trials are played")


func test_a_broken_model_in_an_evaluation() -> void:
	Rig.write_trials(_path("sound"))
	DirAccess.make_dir_recursive_absolute(_path("models"))
	var text := FileAccess.get_file_as_string(Rig.MODEL % "tap")
	var half := text.left(text.length() / 2)
	FileAccess.open(_path("models/half.gesture"), FileAccess.WRITE).store_string(half)
	var options := ["--trials", _path("sound"), "--out", _path("sound_out")]
	var run := ToolRun.new("evaluate", options + ["--models", _path("models")])
	check_equal(run.exit_code, 2, "exit code")
	check_equal(_count(run, "half.gesture"), 1, "one line names it")
	var line := half.count("\n") + 1
	check_equal(
		run.missing(["half.gesture:%d: not valid JSON" % line]), "", "the line of the error"
	)


func test_a_gesture_without_a_model_is_an_error() -> void:
	var trials := Rig.write_trials(_path("unknown"), 2)
	var table := FileAccess.get_file_as_string(_path("unknown/trials.csv"))
	var renamed := table.replace(",horizontal_drag,", ",swipe,")
	FileAccess.open(_path("unknown/trials.csv"), FileAccess.WRITE).store_string(renamed)
	for context: String in Evaluation.CONTEXTS:
		var options := ["--trials", _path("unknown"), "--out", _path("unknown_out")]
		var run := ToolRun.new("evaluate", options + ["--context", context])
		check_equal(run.exit_code, 1, "exit code")
		check_equal(_count(run, "no model of it"), 1, "one line for all its trials: %s" % context)
		check_equal(_count(run, "WARNING"), 0, "and no other")
		var number := "evaluate: %d trials without figures, see above" % trials.get_count()
		check_equal(run.missing([number]), "", "the number of trials")


func test_a_track_without_the_joint_gives_one_line() -> void:
	var trials := Rig.write_trials(_path("thumbs"), 2)
	var table := FileAccess.get_file_as_string(_path("thumbs/trials.csv"))
	var row := table.get_slice("\n", 1)
	var none := row.replace(",horizontal_drag,", ",none,").split(",").slice(0, 6)
	table = table.replace(row, ",".join(none) + ",,,,,,,")
	FileAccess.open(_path("thumbs/trials.csv"), FileAccess.WRITE).store_string(table)
	for index: int in [0, 1]:
		var text := FileAccess.get_file_as_string(trials.get_measured_path(index))
		text = text.replace("index_", "other_")
		FileAccess.open(trials.get_measured_path(index), FileAccess.WRITE).store_string(text)
	var run := ToolRun.new("evaluate", ["--trials", _path("thumbs"), "--out", _path("thumbs_out")])
	check_equal(run.exit_code, 0, "exit code")
	for index: int in [0, 1]:
		var name: String = trials.get_trial(index)["trial"]
		var path := trials.get_measured_path(index)
		var line := (
			"trial %s: its measured track has no motion of index_along_axis: %s" % [name, path]
		)
		check_equal(run.missing([line]), "", "the line names trial and file")
	check_equal(run.output.count("WARNING"), 0, "no other warning")


## Damages the measured track of a trial, and returns the trial's name.
static func _break_one(trials: TrialSet) -> String:
	FileAccess.open(trials.get_measured_path(1), FileAccess.WRITE).store_string(TRACK)
	return trials.get_trial(1)["trial"]


## Number of lines with the text.
static func _count(run: ToolRun, text: String) -> int:
	var lines := Array(run.output.split("\n"))
	return lines.filter(func(line: String) -> bool: return line.contains(text)).size()


func _path(name: String) -> String:
	return _folder.get_current_dir().path_join(name)
