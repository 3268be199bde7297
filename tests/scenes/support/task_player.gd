extends RefCounted
## A task scene of the demo, controlled by a test: plays trials, or moves the mouse.

const PushedHand := preload("pushed_hand.gd")
const Rig := preload("rig.gd")
const TaskScene := preload("res://scripts/task_scene.gd")
const Tasks := preload("res://scripts/tasks.gd")

const REST_S := 0.8
const STROKE_S := 1.0
## As on a screen: without a limit a headless engine has uneven frames.
const FRAMES_PER_S := 90
## The first frames after a scene was loaded come in one burst.
const SETTLING_FRAMES := 8

var scene: TaskScene = null

var _tree: SceneTree = null


func _init(gesture: String, log_folder: String, tree: SceneTree) -> void:
	_tree = tree
	scene = (load(Tasks.SCENES[gesture]) as PackedScene).instantiate()
	scene.autoplay = false
	scene.log_folder = log_folder
	(scene.get_node("HandTracker") as HandTracker).update_mode = HandTracker.UPDATE_MANUAL
	tree.root.add_child(scene)


## Plays the current trial to its end. Returns its speed relative to real time.
func play_to_end() -> float:
	var began_us := Time.get_ticks_usec()
	while not scene.tracker.is_finished():
		scene.tracker.advance(Rig.STEP_S)
	return scene.tracker.get_duration() / (1e-6 * (Time.get_ticks_usec() - began_us))


## Follows the mouse in place of the hand, with the pointer at `place`.
func follow_mouse(place: Vector3) -> void:
	Engine.max_fps = FRAMES_PER_S
	for i in SETTLING_FRAMES:
		await _tree.process_frame
	_point_mouse(place)
	scene.follow_mouse(true)


## Rests the pointer at `from`, moves it to `to` on a minimum-jerk curve, rests there.
func stroke_mouse(from: Vector3, to: Vector3) -> void:
	var began_us := Time.get_ticks_usec()
	var phase := -REST_S / STROKE_S
	while phase < 1.0 + REST_S / STROKE_S:
		_point_mouse(from.lerp(to, PushedHand.share(phase)))
		await _tree.process_frame
		phase = (1e-6 * (Time.get_ticks_usec() - began_us) - REST_S) / STROKE_S


func press(key: Key) -> void:
	var event := InputEventKey.new()
	event.pressed = true
	event.keycode = key
	_tree.root.push_input(event)


func body(name: String) -> MeshInstance3D:
	return scene.get_node("Stage").get_node(name)


func colour(name: String) -> Color:
	return (body(name).material_override as StandardMaterial3D).albedo_color


## The error of the session's logs of these trials. Empty: none.
func log_fault(trials: TrialSet) -> String:
	var folder := scene.session_folder
	scene.free()
	var rows := FileAccess.get_file_as_string(folder.path_join("trials.csv")).split("\n", false)
	if rows.size() != trials.get_count() + 1:
		return "%d rows for %d trials" % [rows.size(), trials.get_count()]
	for row in rows.slice(1):
		if row.split(",").size() != rows[0].split(",").size():
			return "'%s' does not have the columns of '%s'" % [row, rows[0]]
		var log_path := folder.path_join("%s.log.csv" % row.get_slice(",", 0))
		var samples := FileAccess.get_file_as_string(log_path).split("\n", false)
		if samples.size() <= 1000:
			return "%s has no row for each instant: %d" % [log_path, samples.size()]
	return ""


func _point_mouse(place: Vector3) -> void:
	var motion := InputEventMouseMotion.new()
	motion.position = _tree.root.get_camera_3d().unproject_position(place)
	_tree.root.push_input(motion, true)
