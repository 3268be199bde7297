extends "support/scene_test.gd"
## The horizontal drag-box, headless: faster than real time, to the stop marker, in its colours.

const Rig := preload("support/rig.gd")
const DragStage := preload("res://scripts/drag_stage.gd")
const TaskScene := preload("res://scripts/task_scene.gd")

const REST_S := 0.8
const DRAG_S := 1.0
const SCENE := "res://scenes/horizontal_drag.tscn"

var _folder := DirAccess.create_temp("steadyhand_scene")


func test_a_drag_from_marker_to_marker() -> void:
	var trials := Rig.write_trials(_folder.get_current_dir(), 2)
	var scene := _make_scene()
	for index in trials.get_count():
		_play(scene, trials, index)
	var logs := scene.session_folder
	scene.free()
	_check_logs(trials, logs)


func test_the_mouse_in_place_of_the_hand() -> void:
	var scene := _make_scene()
	scene.follow_mouse(true)
	await _drag_mouse(scene)
	var measured := scene.gesture_hmm.get_motion_value(GestureHMM.MOTION_MEASURED)
	check_near(measured, scene.task.amplitude, 0.01, "the pointer is seen in the task's plane")
	check_equal(String(scene.gesture_hmm.recognised), "horizontal_drag", "its drag is recognised")
	check_equal(_colour(scene, "StopMarker"), DragStage.ARRIVED, "the stop turned red")
	var press := InputEventKey.new()
	press.pressed = true
	press.keycode = KEY_1
	root.push_input(press)
	check_equal(scene.gesture_hmm.motion, GestureHMM.MOTION_MEASURED, "key 1: measured motion")
	press.keycode = KEY_5
	root.push_input(press)
	check_equal(scene.gesture_hmm.motion, GestureHMM.MOTION_SYNTHESISED, "key 5: synthesised")
	scene.free()


func _make_scene() -> TaskScene:
	var scene: TaskScene = (load(SCENE) as PackedScene).instantiate()
	scene.autoplay = false
	scene.log_folder = _folder.get_current_dir().path_join("logs")
	(scene.get_node("HandTracker") as HandTracker).update_mode = HandTracker.UPDATE_MANUAL
	root.add_child(scene)
	return scene


func _play(scene: TaskScene, trials: TrialSet, index: int) -> void:
	var trial := trials.get_trial(index)
	var name: String = trial["trial"]
	var began_us := Time.get_ticks_usec()
	scene.play(trial, trials.get_measured_path(index))
	check_equal(_colour(scene, "StartMarker"), DragStage.IDLE, "%s: the start is idle" % name)
	while not scene.tracker.is_finished():
		scene.tracker.advance(Rig.STEP_S)
	var taken_s := 1e-6 * (Time.get_ticks_usec() - began_us)
	check(taken_s < 0.5 * scene.tracker.get_duration(), "faster than real time")
	check_equal(_colour(scene, "StartMarker"), DragStage.STARTED, "the start turned blue")
	check_equal(_colour(scene, "StopMarker"), DragStage.ARRIVED, "the stop turned red")
	var end: Vector3 = trial["start"] + trial["axis"] * trial["amplitude_m"]
	var box := (
		_body(scene, "Box").global_position - (scene.get_node("Stage") as DragStage).box_offset
	)
	check(box.distance_to(end) < 0.02, "the box is at the stop marker: %s" % [box - end])
	check(scene.end_s > trial["start_s"], "the trial has an end")
	# Where tracking is bad the end is an estimate, and judged by evaluate.
	if trial["position"] == "stable":
		check_near(scene.end_s, trial["end_s"], 0.4, "the trial's end")


func _check_logs(trials: TrialSet, logs: String) -> void:
	var rows := FileAccess.get_file_as_string(logs.path_join("trials.csv")).split("\n", false)
	check_equal(rows.size(), trials.get_count() + 1, "a row a trial")
	for row in rows.slice(1):
		check_equal(row.split(",").size(), rows[0].split(",").size(), "of all columns")
		var log_path := logs.path_join("%s.log.csv" % row.get_slice(",", 0))
		var samples := FileAccess.get_file_as_string(log_path).split("\n", false)
		check(samples.size() > 1000, "and a log of every instant: %d" % samples.size())


## Rests the pointer at the task's start, drags it to the end by a minimum-jerk motion, rests there.
func _drag_mouse(scene: TaskScene) -> void:
	var camera := root.get_camera_3d()
	var began_us := Time.get_ticks_usec()
	var phase := -REST_S / DRAG_S
	while phase < 1.0 + REST_S / DRAG_S:
		var p := clampf(phase, 0.0, 1.0)
		var way := scene.task.amplitude * p * p * p * (10.0 - 15.0 * p + 6.0 * p * p)
		var motion := InputEventMouseMotion.new()
		motion.position = camera.unproject_position(
			scene.task.get_start() + scene.task.get_axis() * way
		)
		root.push_input(motion, true)
		await process_frame
		phase = (1e-6 * (Time.get_ticks_usec() - began_us) - REST_S) / DRAG_S


func _body(scene: TaskScene, name: String) -> MeshInstance3D:
	return scene.get_node("Stage").get_node(name)


func _colour(scene: TaskScene, name: String) -> Color:
	return (_body(scene, name).material_override as StandardMaterial3D).albedo_color
