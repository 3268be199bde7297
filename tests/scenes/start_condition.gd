extends "support/scene_test.gd"
## With a start condition a gesture begins only if the hand meets it.

const PushedHand := preload("support/pushed_hand.gd")

const MODEL := "res://addons/steadyhand/models/%s.gesture"
const FRAME_S := 0.01
const REST_S := 1.0
const WAY := 0.2
const OPEN := 0.08
const CLOSED := 0.01
const WHOLE: Array[String] = ["started", "ended"]
const ABORTED: Array[String] = ["started", "aborted"]
const NOTHING: Array[String] = []

var _tracker: HandTracker
var _hmm: GestureHMM
var _events: Array[String] = []


func test_a_pinch_starts_a_drag_and_its_release_aborts_it() -> void:
	for at_task: bool in [true, false]:
		_make_nodes(at_task)
		_hmm.start_condition = GestureHMM.START_PINCH
		_drag(func(_time_s: float) -> Dictionary: return _fingers(CLOSED))
		check_equal(_events, WHOLE, "pinched, task: %s" % at_task)
		_free_nodes()
		_make_nodes(at_task)
		_hmm.start_condition = GestureHMM.START_PINCH
		_drag(func(_time_s: float) -> Dictionary: return _fingers(OPEN))
		check_equal(_events, NOTHING, "open, task: %s" % at_task)
		_free_nodes()
		_make_nodes(at_task)
		_hmm.start_condition = GestureHMM.START_PINCH
		_drag(
			func(time_s: float) -> Dictionary:
				return _fingers(CLOSED if time_s < REST_S + 0.5 else OPEN)
		)
		check_equal(_events, ABORTED, "released half-way, task: %s" % at_task)
		_free_nodes()


func test_the_pinch_distance_can_be_set() -> void:
	_make_nodes(true)
	_hmm.start_condition = GestureHMM.START_PINCH
	_hmm.pinch_distance = 0.09
	_drag(func(_time_s: float) -> Dictionary: return _fingers(OPEN))
	check_equal(_events, WHOLE, "within the distance")
	_free_nodes()


func test_a_dwell_starts_a_drag() -> void:
	_make_nodes(true)
	_hmm.start_condition = GestureHMM.START_DWELL
	_drag(func(_time_s: float) -> Dictionary: return _fingers(OPEN))
	check_equal(_events, WHOLE, "after a long dwell")
	_free_nodes()
	_make_nodes(true)
	_hmm.start_condition = GestureHMM.START_DWELL
	_hmm.dwell_time = 2.0
	_drag(func(_time_s: float) -> Dictionary: return _fingers(OPEN))
	check_equal(_events, NOTHING, "after a short dwell")
	_free_nodes()


func test_the_pointing_pose_starts_a_drag() -> void:
	for curled: bool in [true, false]:
		_make_nodes(true)
		_hmm.start_condition = GestureHMM.START_POINTING_POSE
		_drag(
			func(_time_s: float) -> Dictionary:
				var joints := _fingers(OPEN)
				joints[HandTracker.JOINT_PALM] = Vector3(0, 0, 0.11)
				for joint: HandTracker.Joint in [
					HandTracker.JOINT_MIDDLE, HandTracker.JOINT_RING, HandTracker.JOINT_PINKY
				]:
					joints[joint] = Vector3(0, 0, 0.06 if curled else 0.0)
				return joints
		)
		check_equal(_events, WHOLE if curled else NOTHING, "fingers curled: %s" % curled)
		_free_nodes()


func test_missing_joints_of_a_condition_are_warned_of() -> void:
	# expects one warning: "start_condition" needs thumb, index; no frame had thumb
	_make_nodes(true)
	_hmm.start_condition = GestureHMM.START_PINCH
	_drag(func(_time_s: float) -> Dictionary: return {HandTracker.JOINT_INDEX: Vector3.ZERO})
	check_equal(_events, NOTHING, "nothing starts")
	_free_nodes()


func test_a_zoom_cannot_be_pinched() -> void:
	# expects one warning: Set "start_condition" to another one than START_PINCH: 'zoom'
	_make_nodes(false)
	_hmm.models = [load(MODEL % "zoom") as GestureModel]
	_hmm.start_condition = GestureHMM.START_PINCH
	_drag(func(_time_s: float) -> Dictionary: return _fingers(CLOSED))
	_free_nodes()


func test_invalid_values_are_refused() -> void:
	# expects error: start_condition must be one of START_*
	# expects error: dwell_time must be 0.1..3 s
	# expects error: pinch_distance must be 0.005..0.1 m
	_make_nodes(true)
	_hmm.set("start_condition", 4)
	_hmm.dwell_time = NAN
	_hmm.pinch_distance = -1.0
	check_equal(_hmm.start_condition, GestureHMM.START_NONE, "the condition stays")
	check_equal(_hmm.dwell_time, 0.5, "the time stays")
	check_equal(_hmm.pinch_distance, 0.025, "the distance stays")
	_free_nodes()


## From rest to rest in 1 s. `fingers`: of the time; gives joints relative to the index tip.
func _drag(fingers: Callable) -> void:
	for frame in roundi((REST_S + 2.2) / FRAME_S):
		var time_s := frame * FRAME_S
		var tip := (
			Vector3(WAY * PushedHand.share(time_s - REST_S), 0, 0) + PushedHand.tremor(time_s)
		)
		var joints: Dictionary = fingers.call(time_s)
		for joint: HandTracker.Joint in joints:
			joints[joint] += tip
		_tracker.push_frame(time_s, joints)


static func _fingers(gap: float) -> Dictionary:
	return {
		HandTracker.JOINT_INDEX: Vector3.ZERO,
		HandTracker.JOINT_THUMB: Vector3(0, -gap, 0),
	}


func _make_nodes(at_task: bool) -> void:
	_tracker = HandTracker.new()
	_tracker.update_mode = HandTracker.UPDATE_MANUAL
	_tracker.autostart = false
	_tracker.source = ScriptSource.new()
	_hmm = GestureHMM.new()
	_hmm.models = [load(MODEL % "horizontal_drag") as GestureModel]
	_hmm.tracker = _tracker
	root.add_child(_tracker)
	root.add_child(_hmm)
	if at_task:
		var task := GestureTask.new()
		task.amplitude = WAY
		_hmm.add_child(task)
		_hmm.task = task
	PushedHand.listen(_hmm, _events)
	_tracker.start()


func _free_nodes() -> void:
	_hmm.free()
	_tracker.free()
