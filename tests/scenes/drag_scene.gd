extends "support/scene_test.gd"
## The drag scenes, headless: boxes reach the stop marker faster than real time, and change colour.

const Rig := preload("support/rig.gd")
const DragStage := preload("res://scripts/drag_stage.gd")
const TaskPlayer := preload("support/task_player.gd")

var _folder := DirAccess.create_temp("steadyhand_drag_scene")


func test_horizontal_drag_from_marker_to_marker() -> void:
	_check_drags("horizontal_drag")


func test_vertical_drag_from_marker_to_marker() -> void:
	_check_drags("vertical_drag")


func test_size_of_boxes_and_way() -> void:
	for gesture: String in ["horizontal_drag", "vertical_drag"]:
		var player := TaskPlayer.new(gesture, _folder.get_current_dir(), self)
		check_equal((player.body("Box").mesh as BoxMesh).size, Vector3.ONE * 0.05, "5 cm box")
		var apart := Vector3.ZERO
		for name: String in ["StartMarker", "StopMarker"]:
			var marker := player.body(name)
			check_equal((marker.mesh as BoxMesh).size, Vector3.ONE * 0.04, "4 cm marker")
			apart = marker.global_position - apart
		check_near(apart.length(), 0.2, 1e-6, "20 cm apart")
		var axis := Vector3.RIGHT if gesture == "horizontal_drag" else Vector3.UP
		check_near(apart.dot(axis), 0.2, 1e-6, "%s: the right distance" % gesture)
		player.scene.free()


func test_the_mouse_in_place_of_the_hand() -> void:
	for gesture: String in ["horizontal_drag", "vertical_drag"]:
		var player := TaskPlayer.new(gesture, _folder.get_current_dir(), self)
		var scene := player.scene
		await player.follow_mouse(scene.task.get_start())
		var start := scene.task.get_start()
		await player.stroke_mouse(start, start + scene.task.get_axis() * scene.task.amplitude)
		var measured := scene.gesture_hmm.get_motion_value(GestureHMM.MOTION_MEASURED)
		check_near(measured, scene.task.amplitude, 0.01, "the pointer is seen in the task's plane")
		check_equal(String(scene.gesture_hmm.recognised), gesture, "its drag is recognised")
		check_equal(player.colour("StopMarker"), DragStage.ARRIVED, "the stop turned red")
		player.press(KEY_1)
		check_equal(scene.gesture_hmm.motion, GestureHMM.MOTION_MEASURED, "key 1: measured motion")
		player.press(KEY_5)
		check_equal(scene.gesture_hmm.motion, GestureHMM.MOTION_SYNTHESISED, "key 5: synthesised")
		scene.free()


func _check_drags(gesture: String) -> void:
	var trials := Rig.write_trials(_folder.get_current_dir().path_join(gesture), 2, gesture)
	var player := TaskPlayer.new(
		gesture, _folder.get_current_dir().path_join("logs").path_join(gesture), self
	)
	for index in trials.get_count():
		_check_drag(player, trials, index)
	check_equal(player.log_fault(trials), "", "the logs")


func _check_drag(player: TaskPlayer, trials: TrialSet, index: int) -> void:
	var trial := trials.get_trial(index)
	var name: String = trial["trial"]
	player.scene.play(trial, trials.get_measured_path(index))
	check_equal(player.colour("StartMarker"), DragStage.IDLE, "%s: the start is idle" % name)
	check(player.play_to_end() > 2.0, "faster than real time")
	check_equal(player.colour("StartMarker"), DragStage.STARTED, "the start turned blue")
	check_equal(player.colour("StopMarker"), DragStage.ARRIVED, "the stop turned red")
	check(player.scene.course.end_s > trial["start_s"], "the trial has an end")
	# With bad tracking, place and time of the end are estimates, and the hand may overshoot:
	# `evaluate` tests them.
	if trial["position"] == "stable":
		var end: Vector3 = trial["start"] + trial["axis"] * trial["amplitude_m"]
		var stage: DragStage = player.scene.get_node("Stage")
		var box := player.body("Box").global_position - stage.box_offset
		check(box.distance_to(end) < 0.02, "the box is at the stop marker: %s" % [box - end])
		check_near(player.scene.course.end_s, trial["end_s"], 0.4, "the trial's end")
