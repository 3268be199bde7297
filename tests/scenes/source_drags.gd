extends "support/scene_test.gd"
## Each source that needs no device runs the horizontal drag, end to end.

const PushedHand := preload("support/pushed_hand.gd")
const SourceDrag := preload("support/source_drag.gd")
const XRHand := preload("support/xr_hand.gd")

const START := Vector3(-0.1, 1.2, -0.3)
const DRAG_S := 3.5

var _folder := DirAccess.create_temp("steadyhand_source_drags")


func test_script_source() -> void:
	var drag := _begin(ScriptSource.new())
	drag.step_for(
		DRAG_S,
		func(time_s: float) -> void:
			drag.tracker.push_frame(time_s, {HandTracker.JOINT_INDEX: _tip(time_s)})
	)
	_check_end(drag, "ScriptSource")


func test_xr_source() -> void:
	var hand := XRHand.new()
	hand.register()
	var drag := _begin(XRSource.new())
	drag.step_for(DRAG_S, func(time_s: float) -> void: hand.place(_tip(time_s)))
	_check_end(drag, "XRSource")
	hand.remove()


func test_recorded_source() -> void:
	var path := _folder.get_current_dir().path_join("drag.csv")
	var recorder := HandTracker.new()
	recorder.source = ScriptSource.new()
	recorder.start()
	recorder.start_recording(path)
	for frame in int(DRAG_S / SourceDrag.STEP_S):
		var time_s := frame * SourceDrag.STEP_S
		recorder.push_frame(time_s, {HandTracker.JOINT_INDEX: _tip(time_s)})
	recorder.free()
	var source := RecordedSource.new()
	source.track = path
	var drag := _begin(source)
	drag.step_for(DRAG_S)
	_check_end(drag, "RecordedSource")


func test_synthetic_source() -> void:
	var drag := SourceDrag.new(self, _folder.get_current_dir(), START)
	drag.begin(_synthetic(drag))
	drag.step_for(6.0)
	# People overshoot or undershoot a little.
	_check_end(drag, "SyntheticSource", 0.03)


func test_degraded_source() -> void:
	var drag := SourceDrag.new(self, _folder.get_current_dir(), START)
	var source := DegradedSource.new()
	source.source = _synthetic(drag)
	source.preset = DegradedSource.PRESET_STABLE
	source.dropouts_per_minute = 40.0
	source.dropout_duration = 0.08
	drag.begin(source)
	drag.step_for(6.0)
	check(drag.tracker.dropout_count > 0, "%d dropouts" % drag.tracker.dropout_count)
	_check_end(drag, "DegradedSource", 0.03)


func test_fixed_fps_makes_a_run_repeatable() -> void:
	var outputs: Array[String] = []
	for run in 2:
		var script := ProjectSettings.globalize_path("res://").path_join(
			"../tests/scenes/support/fixed_fps_run.gd"
		)
		var command := PackedStringArray(
			["--headless", "--path", ProjectSettings.globalize_path("res://"), "--fixed-fps", "90"]
		)
		command.append_array(["--script", script])
		var output := []
		var godot := OS.get_environment("GODOT")
		OS.execute(godot if godot != "" else OS.get_executable_path(), command, output, true)
		outputs.append("\n".join(output))
	check(outputs[0].contains("ended at "), "a drag has ended: %s" % outputs[0].right(200))
	check_equal(outputs[0], outputs[1], "both runs have the same output")


func _synthetic(drag: SourceDrag) -> SyntheticSource:
	var source := SyntheticSource.new()
	source.place_at(drag.player.scene.task)
	return source


## At rest, 20 cm to the right in 0.8 s, at rest.
func _tip(time_s: float) -> Vector3:
	var way := 0.2 * PushedHand.share((time_s - 1.0) / 0.8)
	return START + Vector3(way, 0.0, 0.0) + PushedHand.tremor(time_s)


func _begin(source: HandSource) -> SourceDrag:
	var drag := SourceDrag.new(self, _folder.get_current_dir(), START)
	drag.begin(source)
	return drag


func _check_end(drag: SourceDrag, what: String, tolerance_m: float = 0.01) -> void:
	drag.check(self, what, tolerance_m)
	check_equal(drag.failures, [] as Array[String], "%s: no failure" % what)
	drag.free_scene()
