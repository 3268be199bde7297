extends "support/scene_test.gd"
## The tap scene, headless: the surface is 15 cm away, and red from the contact on.

const PushedHand := preload("support/pushed_hand.gd")
const Rig := preload("support/rig.gd")
const TapStage := preload("res://scripts/tap_stage.gd")
const TaskPlayer := preload("support/task_player.gd")

var _folder := DirAccess.create_temp("steadyhand_tap_scene")


func test_taps_turn_the_surface_red() -> void:
	var trials := Rig.write_trials(_folder.get_current_dir().path_join("trials"), 3, "tap")
	var player := TaskPlayer.new("tap", _folder.get_current_dir().path_join("logs"), self)
	for index in trials.get_count():
		var trial := trials.get_trial(index)
		player.scene.play(trial, trials.get_measured_path(index))
		check_equal(player.colour("Surface"), TapStage.IDLE, "%s: idle" % trial["trial"])
		_check_place(player, trial)
		check(player.play_to_end() > 2.0, "faster than real time")
		if trial["position"] == "stable":
			check_equal(player.colour("Surface"), TapStage.ARRIVED, "red after the contact")
			check_near(player.scene.course.end_s, trial["end_s"], 0.1, "the end is the contact")
	check_equal(player.log_fault(trials), "", "the logs")


func test_a_hand_that_stops_early_presses_nothing() -> void:
	var player := TaskPlayer.new("tap", _folder.get_current_dir(), self)
	var trial := {
		trial = "short",
		gesture = "tap",
		position = "stable",
		start = Vector3.ZERO,
		axis = Vector3.FORWARD,
		amplitude_m = 0.15,
	}
	player.scene.play(trial, _write_short_tap())
	player.play_to_end()
	check(not is_nan(player.scene.course.start_s), "a tap has begun")
	check_near(player.scene.gesture_hmm.value, 0.075, 0.02, "and stopped half-way")
	check_equal(player.colour("Surface"), TapStage.IDLE, "no contact")
	player.scene.free()


func test_the_mouse_in_place_of_the_hand() -> void:
	var player := TaskPlayer.new("tap", _folder.get_current_dir(), self)
	var scene := player.scene
	await player.follow_mouse(scene.task.get_start())
	var start := scene.task.get_start()
	await player.stroke_mouse(start, start + scene.task.get_axis() * scene.task.amplitude)
	var measured := scene.gesture_hmm.get_motion_value(GestureHMM.MOTION_MEASURED)
	check_near(measured, scene.task.amplitude, 0.01, "the pointer is seen in the task's plane")
	check_equal(player.colour("Surface"), TapStage.ARRIVED, "the surface turned red")
	scene.free()


## Writes a track: half-way in 0.3 s on a minimum-jerk motion, with a tremor of 0.1 mm.
func _write_short_tap() -> String:
	var path := _folder.get_current_dir().path_join("short.measured.csv")
	var track := FileAccess.open(path, FileAccess.WRITE)
	track.store_line("t,index_x,index_y,index_z")
	for i in 250:
		var t := 0.01 * i
		var way := 0.075 * PushedHand.share((t - 0.8) / 0.3) + 1e-4 * sin(TAU * 11.3 * t)
		track.store_line("%.3f,0,0,%.6f" % [t, -way])
	return path


## The surface's near face is 15 cm from the start, across the path.
func _check_place(player: TaskPlayer, trial: Dictionary) -> void:
	var surface := player.body("Surface")
	var axis: Vector3 = trial["axis"]
	var normal := surface.global_basis.y.normalized()
	check_near(absf(normal.dot(axis)), 1.0, 1e-5, "the surface is across the path")
	var thickness := (surface.mesh as BoxMesh).size.y
	var way := axis.dot(surface.global_position - (trial["start"] as Vector3)) - 0.5 * thickness
	check_near(way, 0.15, 1e-5, "15 cm away")
