extends "support/scene_test.gd"
## The reasons in the debug overlay why no gesture starts.

const DebugOverlay := preload("res://addons/steadyhand/debug_overlay.gd")
const Rig := preload("support/rig.gd")

const FRAME_S := 1.0 / 90.0

var _tracker := HandTracker.new()
var _task := GestureTask.new()
var _hmm := GestureHMM.new()
var _overlay: DebugOverlay = null
var _frame := 0
var _random := RandomNumberGenerator.new()


func test_each_reason_in_turn() -> void:
	_random.seed = 1
	var scene := load("res://addons/steadyhand/debug_overlay.tscn") as PackedScene
	_overlay = scene.instantiate() as DebugOverlay
	_tracker.name = "Hand"
	_task.name = "Key"
	_task.position = Vector3(0.5, 1.0, -0.3)
	for node: Node in [_tracker, _task, _hmm, _overlay]:
		root.add_child(node)
	_hmm.name = "Recogniser"
	_overlay.gesture_hmm = _hmm
	_check_reason('No tracker: set "tracker" of Recogniser.')
	_hmm.tracker = _tracker
	_check_reason('No source: set "source" of Hand.')
	_tracker.source = ScriptSource.new()
	_tracker.autostart = false
	_tracker.stop()
	_check_reason("Hand is stopped: call start().")
	_tracker.start()
	_check_reason('No models: set "models" of Recogniser.')
	_hmm.models = [load(Rig.MODEL % "horizontal_drag"), load(Rig.MODEL % "zoom")]
	await create_timer(0.7).timeout
	check(_overlay.describe_gesture().begins_with("No frame for "), _overlay.describe_gesture())
	_tracker.push_frame(0.0, {})
	_check_reason("No hand in view.")
	_task.gesture = &"zoom"
	_task.start_radius = 0.03
	_hmm.task = _task
	_push(Vector3.ZERO, 1)
	_check_reason("'zoom' needs joints that are not tracked: thumb, middle finger.")
	_task.gesture = &"horizontal_drag"
	_task.start_radius = 0.0
	_push(Vector3(0.2, 1.0, -0.3), 30)
	_check_reason("The hand is 30 cm from the start of Key: it has to come within 12 cm.")
	_push(_task.position, 90)
	_check_reason("Ready: waits for a movement.")
	_hmm.start_condition = GestureHMM.START_PINCH
	_check_reason("Start condition: a pinch, but the thumb is not tracked.")
	var thumb := _task.position + Vector3(0.0, 0.06, 0.0)
	var joints := {HandTracker.JOINT_INDEX: _task.position, HandTracker.JOINT_THUMB: thumb}
	_tracker.push_frame(_time(), joints)
	_check_reason("Start condition: pinch. Thumb and index finger are 6.0 cm apart, not 2.5 cm.")
	_hmm.start_condition = GestureHMM.START_DWELL
	_push(_task.position + Vector3(0.05, 0.0, 0.0), 10)
	_check_reason("Start condition: hold the fingertip still for 0.5 s.")
	_hmm.start_condition = GestureHMM.START_NONE


func test_a_movement_in_another_direction_than_the_task() -> void:
	_push(_task.position, 90)
	_check_reason("Ready: waits for a movement.")
	for share: float in [0.1, 0.2, 0.3, 0.4]:
		_push(_task.position + share * _task.amplitude * Vector3.UP, 10)
		_overlay.describe_gesture()
	_push(_task.position + 0.4 * _task.amplitude * Vector3.UP, 90)
	var moved := "The hand moved away from the start of Key at 90° to its direction"
	_check_reason(moved + ": go back to the start.")
	var upward := GestureTask.new()
	upward.gesture = &"horizontal_drag"
	upward.position = _task.position
	upward.direction = Vector3.UP
	root.add_child(upward)
	_hmm.tasks += [upward]
	_check_reason("Ready: waits for a movement.")
	_hmm.tasks = [_task]
	upward.free()
	_push(_task.position, 90)
	_check_reason("Ready: waits for a movement.")


func test_a_hand_on_its_way_to_the_start() -> void:
	_push(_task.position + 2.0 * Vector3.UP, 90)
	check(_overlay.describe_gesture().begins_with("The hand is 200 cm"), "it is far away")
	_push(_task.position + 0.4 * _task.amplitude * Vector3.UP, 90)
	_check_reason("Ready: waits for a movement.")


func test_a_frozen_tracker() -> void:
	_hmm.tasks = []
	for i in 200:
		_push(Vector3(0.1 * sin(0.1 * i), 1.0, -0.3), 1)
	for i in 60:
		_tracker.push_frame(_time(), {HandTracker.JOINT_INDEX: Vector3(0.1, 1.0, -0.3)})
	var shown := _overlay.describe_gesture()
	check(shown.contains("it is frozen") or not _hmm.gesture.is_empty(), shown)


func test_a_recording_in_milliseconds() -> void:
	var folder := DirAccess.create_temp("steadyhand_idle")
	var recorded := RecordedSource.new()
	recorded.track = folder.get_current_dir().path_join("track.csv")
	var file := FileAccess.open(recorded.track, FileAccess.WRITE)
	file.store_string("t,index_x,index_y,index_z\n0,0,0,-0.3\n11000,0,0,-0.3\n")
	file.close()
	# expects one warning: times must be in seconds
	_tracker.source = recorded
	_tracker.start()
	await create_timer(0.7).timeout
	var shown := _overlay.describe_gesture()
	check(shown.contains("are the times of the recording in seconds?"), shown)
	_tracker.source = ScriptSource.new()
	_tracker.start()


func test_an_active_gesture_is_shown() -> void:
	_hmm.task = _task
	_push(_task.position, 90)
	for i in 40:
		_push(_task.position + Vector3(0.1 * i / 40.0, 0.0, 0.0), 1)
	var shown := _overlay.describe_gesture()
	check(shown.begins_with("horizontal_drag: "), shown)
	check(shown.contains(" cm\nconfidence "), shown)
	for node: Node in [_overlay, _hmm, _task, _tracker]:
		node.free()


func _check_reason(text: String) -> void:
	check_equal(_overlay.describe_gesture(), text, text)


func _push(place: Vector3, frames: int) -> void:
	for i in frames:
		var noise := 3e-4 * Vector3(_random.randfn(), _random.randfn(), _random.randfn())
		_tracker.push_frame(_time(), {HandTracker.JOINT_INDEX: place + noise})


func _time() -> float:
	_frame += 1
	return _frame * FRAME_S
