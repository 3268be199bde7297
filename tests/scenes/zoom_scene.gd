extends "support/scene_test.gd"
## The zoom scene, headless: the sphere grows to three times its size, in one or several strokes.

const Rig := preload("support/rig.gd")
const TaskPlayer := preload("support/task_player.gd")
const ZoomStage := preload("res://scripts/zoom_stage.gd")

var _folder := DirAccess.create_temp("steadyhand_zoom_scene")


func test_a_stroke_zooms_the_sphere_to_three_times_its_size() -> void:
	var trials := Rig.write_trials(_folder.get_current_dir().path_join("trials"), 3, "zoom")
	var player := TaskPlayer.new("zoom", _folder.get_current_dir().path_join("logs"), self)
	for index in trials.get_count():
		var trial := trials.get_trial(index)
		player.scene.play(trial, trials.get_measured_path(index))
		check_near(_size(player), 1.0, 1e-6, "%s: its own size" % trial["trial"])
		check_equal(player.colour("Target"), ZoomStage.IDLE, "the target is idle")
		check(player.play_to_end() > 2.0, "faster than real time")
		if trial["position"] == "stable":
			check(_size(player) > 2.8 and _size(player) <= 3.0, "to %.2f times" % _size(player))
			check_equal(player.colour("Target"), ZoomStage.ARRIVED, "the target turned red")
			check_near(player.scene.course.end_s, trial["end_s"], 0.3, "the trial's end")
	check_equal(player.log_fault(trials), "", "the logs")


func test_strokes_add_up() -> void:
	var stage := _make_stage()
	stage.begin_stroke()
	stage.show_motion(0.01)
	check_near(stage.show_motion(0.012), 0.4, 1e-6, "a stroke of 12 of 30 mm")
	check_near(stage.show_motion(0.002), 0.4, 1e-6, "it stays while the hand closes")
	stage.begin_stroke()
	check_near(stage.show_motion(0.0), 0.4, 1e-6, "it stays when the next stroke begins")
	check_near(stage.show_motion(0.009), 0.7, 1e-6, "the next stroke adds its 9 mm")
	stage.begin_stroke()
	check_near(stage.show_motion(0.03), 1.0, 1e-6, "the last one ends at the target")
	check_near(stage.get_node("Sphere").scale.x, 3.0, 1e-6, "three times the size")
	stage.get_parent().free()


func test_nothing_moves_before_a_stroke() -> void:
	var stage := _make_stage()
	check_near(stage.show_motion(0.005), 0.0, 1e-9, "a trembling hand zooms nothing")
	stage.get_parent().free()


func test_the_mouse_in_place_of_the_hand() -> void:
	var player := TaskPlayer.new("zoom", _folder.get_current_dir(), self)
	var scene := player.scene
	var centre := scene.task.get_start()
	var view := root.get_camera_3d().global_basis.x
	await player.follow_mouse(centre + view * 0.015)
	await player.stroke_mouse(centre + view * 0.015, centre + view * 0.045)
	var measured := scene.gesture_hmm.get_motion_value(GestureHMM.MOTION_MEASURED)
	check_near(measured, 0.03, 0.002, "the pointer's distance is the radius")
	check_equal(String(scene.gesture_hmm.recognised), "zoom", "its zoom is recognised")
	check_near(_size(player), 3.0, 0.15, "the sphere is three times its size")
	check_equal(player.colour("Target"), ZoomStage.ARRIVED, "the target turned red")
	scene.free()


func _make_stage() -> ZoomStage:
	var player := TaskPlayer.new("zoom", _folder.get_current_dir(), self)
	return player.scene.get_node("Stage")


func _size(player: TaskPlayer) -> float:
	return player.body("Sphere").scale.x
