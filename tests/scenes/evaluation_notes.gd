extends "support/scene_test.gd"
## Notes of an evaluation whose figures cannot show what a user wants to know.

const Rig := preload("support/rig.gd")
const ToolRun := preload("support/tool_run.gd")

const TRAINED := "note: the model of 'horizontal_drag' was trained on these trials."
const ONE_TRACK := "note: 2 trials with equal measured and reference tracks, which"

var _folder := DirAccess.create_temp("steadyhand_notes")


func test_an_evaluation_of_the_models_own_recordings_is_noted() -> void:
	var own := Rig.write_trials(_path("own"), 4)
	Rig.write_trials(_path("others"), 3)
	DirAccess.make_dir_absolute(_path("models"))
	var model := GestureTrainer.new().train(own, &"horizontal_drag")
	check_equal(ResourceSaver.save(model, _path("models/own.gesture")), OK, "a model is trained")
	var models := ["--models", _path("models")]
	check_equal(_evaluate("own", models).missing([TRAINED]), "", "the training set is noted")
	check(not _evaluate("others", models).output.contains("note:"), "another set has no note")
	check(not _evaluate("own", []).output.contains("note:"), "another model has no note")


func test_equal_tracks_are_noted_with_their_number() -> void:
	var trials := Rig.write_trials(_path("one_track"), 2)
	check(not _evaluate("one_track", []).output.contains("note:"), "two sensors have no note")
	for index in 2:
		var measured := trials.get_measured_path(index)
		DirAccess.copy_absolute(measured, trials.get_reference_path(index))
	check_equal(_evaluate("one_track", []).missing([ONE_TRACK]), "", "a copied track is noted")


func _evaluate(trials: String, options: PackedStringArray) -> ToolRun:
	var arguments := PackedStringArray(["--trials", _path(trials), "--out", _path(trials + "_out")])
	return ToolRun.new("evaluate", arguments + options)


func _path(name: String) -> String:
	return _folder.get_current_dir().path_join(name)
