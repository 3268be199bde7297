extends "support/scene_test.gd"
## A zoom in several strokes, with the add-on's model: fingers open, close, and open again.

const PushedHand := preload("support/pushed_hand.gd")
const Rig := preload("support/rig.gd")

const FRAME_S := 1.0 / 110.0
const START_M := 0.015
const GROWTH_M := 0.03
const GESTURES: Array[String] = ["horizontal_drag", "vertical_drag", "tap", "zoom"]


func test_three_strokes_are_three_zooms() -> void:
	# Changes of the radius: begin (s), duration (s), amount (m).
	var strokes: Array[Vector3] = [
		Vector3(0.6, 0.7, GROWTH_M),
		Vector3(1.8, 0.5, -GROWTH_M),
		Vector3(2.6, 0.6, GROWTH_M),
		Vector3(3.6, 0.5, -GROWTH_M),
		Vector3(4.4, 0.8, GROWTH_M),
	]
	for in_task: bool in [true, false]:
		var seen := _play(strokes, 6.0, in_task)
		check_equal(seen["events"], _zooms(3), "%s: each stroke is a zoom" % _context(in_task))
		for at_s: float in [0.5, 2.55, 4.35]:
			check_near(
				_value_at(seen, at_s),
				0.0,
				0.05 * GROWTH_M,
				"%s: closed at %.2f s" % [_context(in_task), at_s]
			)
		for at_s: float in [1.6, 3.4, 5.6]:
			check_near(
				_value_at(seen, at_s),
				GROWTH_M,
				0.1 * GROWTH_M,
				"%s: open at %.2f s" % [_context(in_task), at_s]
			)


func test_fingers_that_open_too_far_and_come_back_are_one_zoom() -> void:
	var strokes: Array[Vector3] = [
		Vector3(0.6, 0.7, 1.25 * GROWTH_M), Vector3(1.3, 0.4, -0.25 * GROWTH_M)
	]
	for in_task: bool in [true, false]:
		var seen := _play(strokes, 3.0, in_task)
		check_equal(
			seen["events"], _zooms(1), "%s: an overshoot is no second zoom" % _context(in_task)
		)
		check_near(
			_value_at(seen, 2.5),
			GROWTH_M,
			0.1 * GROWTH_M,
			"%s: the value returns with the fingers" % _context(in_task)
		)


func test_a_hand_that_moves_without_opening_zooms_nothing() -> void:
	for in_task: bool in [true, false]:
		var seen := _play([], 4.0, in_task, Vector3(0.03, 0.02, 0.01))
		# It sways 37 degrees off a drag's axis: a drag may start and be aborted.
		var zooms_or_ends := (seen["events"] as Array[String]).filter(
			func(event: String) -> bool:
				return event.ends_with("zoom") or event.begins_with("ended")
		)
		check_equal(zooms_or_ends, [] as Array[String], "%s: no zoom" % _context(in_task))


func _context(in_task: bool) -> String:
	return "with a task" if in_task else "without a task"


func _zooms(count: int) -> Array[String]:
	var events: Array[String] = []
	for i in count:
		events.append_array(["started zoom", "ended zoom"])
	return events


func _value_at(seen: Dictionary, at_s: float) -> float:
	var values: PackedFloat64Array = seen["values"]
	return values[roundi(at_s / FRAME_S)]


## Signals, and the synthesised value at each frame, m. The hand sways by `sway_m`.
func _play(
	strokes: Array[Vector3], length_s: float, in_task: bool, sway_m: Vector3 = Vector3.ZERO
) -> Dictionary:
	var trial := {
		gesture = "zoom",
		start = Vector3(START_M, 0.0, 0.0),
		axis = Vector3.ZERO,
		amplitude_m = GROWTH_M,
	}
	var rig := Rig.new(trial, "", root)
	rig.tracker.source = ScriptSource.new()
	if not in_task:
		var models: Array[GestureModel] = []
		for gesture in GESTURES:
			models.append(load(Rig.MODEL % gesture) as GestureModel)
		rig.gesture_hmm.models = models
		rig.gesture_hmm.task = null
	var events: Array[String] = []
	rig.gesture_hmm.gesture_started.connect(
		func(gesture: StringName, _task: GestureTask) -> void: events.append("started %s" % gesture)
	)
	rig.gesture_hmm.gesture_aborted.connect(
		func(gesture: StringName, _task: GestureTask) -> void: events.append("aborted %s" % gesture)
	)
	rig.gesture_hmm.gesture_ended.connect(
		func(gesture: StringName, _time_s: float, _task: GestureTask, _fraction: float) -> void:
			events.append("ended %s" % gesture)
	)
	rig.tracker.start()
	var random := RandomNumberGenerator.new()
	random.seed = 7
	var values := PackedFloat64Array()
	for frame in roundi(length_s / FRAME_S):
		var t_s := frame * FRAME_S
		var radius_m := START_M + random.randfn(0.0, 1e-4)
		for stroke in strokes:
			radius_m += stroke.z * PushedHand.share((t_s - stroke.x) / stroke.y)
		rig.tracker.push_frame(t_s, _tips(radius_m, sin(TAU * 0.5 * t_s) * sway_m))
		values.append(rig.gesture_hmm.get_motion_value(GestureHMM.MOTION_SYNTHESISED))
	rig.free_nodes()
	return {events = events, values = values}


static func _tips(radius_m: float, centre_m: Vector3) -> Dictionary:
	var tips := {}
	var angles := {
		HandTracker.JOINT_THUMB: -2.4, HandTracker.JOINT_INDEX: 1.2, HandTracker.JOINT_MIDDLE: 2.0
	}
	for joint: int in angles:
		var angle: float = angles[joint]
		tips[joint] = centre_m + radius_m * Vector3(cos(angle), sin(angle), 0.0)
	return tips
