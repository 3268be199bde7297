extends "../scenes/support/scene_test.gd"
## The study's scene in a headset: Monado, whose simulated right hand makes a trial.

const MonadoHands := preload("monado_hands.gd")
const StudySupport := preload("../scenes/support/study_support.gd")

const RIGHT := MonadoHands.Hand.RIGHT
const SESSION_S := 15.0
const COMPILING_FRAMES := 30
const TRIAL_S := 10.0
const SCENE := "res://study/study_scene.tscn"

var _hands := MonadoHands.new()
var _folder := DirAccess.create_temp("steadyhand_openxr_study")


## Godot 4.6.3 crashes where it ends an OpenXR session.
func _end(_status: int) -> void:
	_hands.stop()
	OS.kill(OS.get_process_id())


func test_a_trial_is_made_in_the_headset() -> void:
	check_equal(_hands.start(), "", "hands of an OpenXR runtime")
	(XRServer.primary_interface as OpenXRInterface).render_target_size_multiplier = 0.1
	var protocol := StudyProtocol.paper()
	protocol.gestures = ["horizontal_drag"]
	protocol.practice_trials = 0
	protocol.trial_limit_s = 600.0
	var scene: Node = (load(SCENE) as PackedScene).instantiate()
	scene.set("protocol", protocol)
	scene.set("study_folder", _folder.get_current_dir())
	root.add_child(scene)
	var rig: Node3D = scene.get("rig")
	_draw_less(rig, scene.get("display"))
	check(rig != null and rig.call("is_active"), "the rig is active")
	check(not root.use_xr, "the window is the operator's")
	check(scene.get("display") != null, "the display is in the scene")
	check_equal(scene.call("run_session", "p01"), OK, "a session starts")
	var runner: StudyRunner = scene.get("runner")
	var tracker := runner.hand.tracker
	await _wait(SESSION_S, tracker.is_hand_tracked)
	check(tracker.is_hand_tracked(), "the hand is tracked")
	# The first frames take seconds: shaders are compiled.
	var compiled := Engine.get_process_frames() + COMPILING_FRAMES
	await _wait(SESSION_S, func() -> bool: return Engine.get_process_frames() > compiled)
	await _wait(1.5)
	var task := runner.task_scene.task
	var to_room := rig.global_basis.inverse()
	var off := task.get_start() - tracker.get_joint_position(HandTracker.JOINT_INDEX)
	var start := _hands.position(RIGHT) + to_room * off
	_hands.move(RIGHT, start, 0.5)
	await _wait(1.5)
	var from := tracker.get_joint_position(HandTracker.JOINT_INDEX)
	check(from.distance_to(task.get_start()) < 0.01, "the fingertip is at the start: %s" % from)
	_hands.move(RIGHT, start + to_room * task.get_axis() * task.amplitude, 0.8)
	await _wait(TRIAL_S, func() -> bool: return scene.get("session").count_finished() > 0)
	check_equal(scene.get("session").count_finished(), 1, "a trial is made")
	var rows := StudySupport.read(scene.get("session"), "trials.csv")
	check_equal(rows[0]["recognised"], "horizontal_drag", "and recognised")


## A processor draws in place of a graphics card.
func _draw_less(rig: Node3D, display: Node3D) -> void:
	rig.get_viewport().msaa_3d = Viewport.MSAA_DISABLED
	rig.get_viewport().scaling_3d_scale = 0.25
	RenderingServer.directional_shadow_atlas_set_size(256, true)
	RenderingServer.directional_soft_shadow_filter_set_quality(RenderingServer.SHADOW_QUALITY_HARD)
	(display.get("viewport") as SubViewport).size = Vector2i(96, 60)


## Waits until it is so, for as long as that at most.
func _wait(seconds: float, is_so := Callable()) -> void:
	var end_us := Time.get_ticks_usec() + int(1e6 * seconds)
	while Time.get_ticks_usec() < end_us and not (is_so.is_valid() and is_so.call()):
		await process_frame
