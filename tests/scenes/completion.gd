extends "support/scene_test.gd"
## A gesture at a task ends once it reaches the fraction `completion` of its amplitude.

const PushedHand := preload("support/pushed_hand.gd")

const MODEL := "res://addons/steadyhand/models/horizontal_drag.gesture"
const FRAME_S := 0.01
const MOVE_S := 0.8
const REST_S := 1.2
const WAY := 0.2

var _hmm: GestureHMM
var _events: Array[String] = []
var _fractions: Array[float] = []


func test_a_hand_that_stops_at_70_percent_does_not_end_the_gesture() -> void:
	_play(0.95, [0.7])
	check_equal(_events, ["started"] as Array[String], "it is still active")
	check_equal(_hmm.gesture, &"horizontal_drag", "by its name")
	check_equal(_hmm.recognised, &"", "and not recognised")
	_free_nodes()


func test_a_gesture_is_aborted_when_the_hand_comes_back() -> void:
	_play(0.95, [0.7, 0.0])
	check_equal(_events, ["started", "aborted"] as Array[String], "once")
	_free_nodes()


func test_a_gesture_ends_when_the_hand_goes_on() -> void:
	_play(0.95, [0.7, 1.0])
	check_equal(_events, ["started", "ended"] as Array[String], "once")
	check(_fractions[0] >= 0.95, "with its fraction: %s" % [_fractions])
	_free_nodes()


func test_a_smaller_completion_ends_it_where_the_hand_stops() -> void:
	_play(0.6, [0.7])
	check_equal(_events, ["started", "ended"] as Array[String], "once")
	check_near(_fractions[0], 0.7, 0.05, "with its fraction")
	_free_nodes()


func test_completion_is_a_fraction() -> void:
	# expects error: completion must be 0.5..1, is
	_hmm = GestureHMM.new()
	for wrong: float in [0.4, 1.1, NAN]:
		_hmm.completion = wrong
	check_equal(_hmm.completion, 0.95, "it stays")
	_hmm.free()


## From rest to rest, to each of these shares of the amplitude.
func _play(completion: float, shares: Array[float]) -> void:
	var tracker := HandTracker.new()
	tracker.update_mode = HandTracker.UPDATE_MANUAL
	tracker.autostart = false
	tracker.source = ScriptSource.new()
	_hmm = GestureHMM.new()
	_hmm.completion = completion
	_hmm.models = [load(MODEL) as GestureModel]
	_hmm.tracker = tracker
	var task := GestureTask.new()
	task.amplitude = WAY
	_hmm.add_child(task)
	_hmm.task = task
	root.add_child(tracker)
	root.add_child(_hmm)
	PushedHand.listen(_hmm, _events)
	_fractions.clear()
	_hmm.gesture_ended.connect(
		func(_gesture: StringName, _time_s: float, _task: GestureTask, fraction: float) -> void:
			_fractions.append(fraction)
	)
	tracker.start()
	for frame in roundi((REST_S + (MOVE_S + REST_S) * shares.size()) / FRAME_S):
		var time_s := frame * FRAME_S
		var share := 0.0
		for i in shares.size():
			var passed := (time_s - REST_S - i * (MOVE_S + REST_S)) / MOVE_S
			share = lerpf(share, shares[i], PushedHand.share(passed))
		var tip := Vector3(WAY * share, 0, 0) + PushedHand.tremor(time_s)
		tracker.push_frame(time_s, {HandTracker.JOINT_INDEX: tip})


func _free_nodes() -> void:
	var tracker := _hmm.tracker
	_hmm.free()
	tracker.free()
