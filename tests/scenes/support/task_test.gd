extends "scene_test.gd"
## A test of a GestureHMM with tasks, and a hand that goes from place to place.

const PushedHand := preload("pushed_hand.gd")
const Rig := preload("rig.gd")

const FRAME_S := 1.0 / 110.0
const REST_S := 0.6
const MOVE_S := 0.7


func _task(gesture: StringName, start: Vector3, direction: Vector3, way_m: float) -> GestureTask:
	var task := GestureTask.new()
	task.gesture = gesture
	task.direction = direction
	task.amplitude = way_m
	root.add_child(task)
	task.global_position = start
	return task


func _hmm(tasks: Array[GestureTask]) -> GestureHMM:
	var tracker := HandTracker.new()
	tracker.source = ScriptSource.new()
	tracker.autostart = false
	var hmm := GestureHMM.new()
	var models: Array[GestureModel] = []
	for gesture: String in ["horizontal_drag", "vertical_drag", "tap"]:
		models.append(load(Rig.MODEL % gesture) as GestureModel)
	hmm.models = models
	hmm.tasks = tasks
	hmm.tracker = tracker
	root.add_child(tracker)
	root.add_child(hmm)
	return hmm


func _free(hmm: GestureHMM) -> void:
	hmm.tracker.free()
	hmm.free()


func _ends(seen: Array[String]) -> Array[String]:
	return seen.filter(func(event: String) -> bool: return event.begins_with("ended"))


## A hand that rests at each place and makes minimum-jerk movements between them. Returns the
## signals with the index of `current_task`.
func _play(hmm: GestureHMM, places: Array[Vector3]) -> Array[String]:
	var seen: Array[String] = []
	var note := func(gesture: StringName, _task: GestureTask, what: String) -> void:
		seen.append("%s %s at task %d" % [what, gesture, hmm.tasks.find(hmm.current_task)])
	var started := note.bind("started")
	var ended := func(
		gesture: StringName, _time_s: float, task: GestureTask, _fraction: float
	) -> void:
		note.call(gesture, task, "ended")
	hmm.gesture_started.connect(started)
	hmm.gesture_ended.connect(ended)
	hmm.tracker.start()
	var time_s := 0.0
	while time_s < (REST_S + MOVE_S) * places.size():
		var at := (time_s - REST_S) / (REST_S + MOVE_S)
		var from := clampi(floori(at), 0, places.size() - 1)
		var to := mini(from + 1, places.size() - 1)
		var share := PushedHand.share((at - from) * (REST_S + MOVE_S) / MOVE_S)
		var tip := places[from].lerp(places[to], share)
		hmm.tracker.push_frame(time_s, {HandTracker.JOINT_INDEX: tip})
		time_s += FRAME_S
	hmm.gesture_started.disconnect(started)
	hmm.gesture_ended.disconnect(ended)
	return seen
