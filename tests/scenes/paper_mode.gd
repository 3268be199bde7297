extends "support/scene_test.gd"
## `paper` mode without a task: HMMs recognise the gesture.

const Rig := preload("support/rig.gd")

const LENGTH_S := 5.0


func test_each_gesture_of_a_synthetic_hand_starts_and_ends_without_a_task() -> void:
	var ways: Array[Vector3] = [
		Vector3.RIGHT, Vector3.LEFT, Vector3.UP, Vector3.DOWN, Vector3.FORWARD, Vector3.DOWN
	]
	var gestures: Array[StringName] = [
		&"horizontal_drag",
		&"horizontal_drag",
		&"vertical_drag",
		&"vertical_drag",
		&"tap",
		&"tap",
		&"zoom",
	]
	for i in gestures.size():
		var source := SyntheticSource.new()
		source.gesture = gestures[i]
		source.placement = SyntheticSource.PLACEMENT_FIXED
		source.start = Vector3(0.0, 1.2, -0.3)
		if i < ways.size():
			source.direction = ways[i]
		# HMMs distinguish a tap downwards from a drag by its speed.
		source.pace = 0.6 if gestures[i] == &"tap" else 1.0
		source.amplitude = {&"tap": 0.15, &"zoom": 0.04}.get(gestures[i], 0.2)
		var hmm := _hmm(source, ["horizontal_drag", "vertical_drag", "tap", "zoom"])
		var seen := _events(hmm)
		_play(hmm)
		# A movement down may begin as a drag, until the hand comes back.
		var last: Array[String] = seen.slice(seen.rfind("started %s" % gestures[i]))
		var expected: Array[String] = ["started %s" % gestures[i], "ended %s" % gestures[i]]
		check_equal(last, expected, "%s, way %d" % [gestures[i], i])
		var ended := seen.filter(func(event: String) -> bool: return event.begins_with("ended"))
		check_equal(ended.size(), 1, "%s, way %d: one end" % [gestures[i], i])
		_free(hmm)


func test_a_model_without_hmms_warns_and_is_not_recognised_without_a_task() -> void:
	var folder := DirAccess.create_temp("steadyhand_paper_mode")
	var path := folder.get_current_dir().path_join("push.gesture")
	var text := FileAccess.get_file_as_string(Rig.MODEL % "horizontal_drag")
	FileAccess.open(path, FileAccess.WRITE).store_string(text.replace("horizontal_drag", "push"))
	for mode: GestureHMM.Mode in [GestureHMM.MODE_PHASE, GestureHMM.MODE_PAPER]:
		var hmm := _hmm(SyntheticSource.new(), ["horizontal_drag"])
		hmm.mode = mode
		# expects warning: Train the model of 'push' again with GestureTrainer
		hmm.models = [load(path) as GestureModel]
		var seen := _events(hmm)
		_play(hmm)
		check_equal(seen, [] as Array[String], "mode %d: the signals" % mode)
		_free(hmm)


func _hmm(source: HandSource, gestures: Array[String]) -> GestureHMM:
	var hmm := GestureHMM.new()
	hmm.tracker = HandTracker.new()
	hmm.tracker.source = source
	hmm.tracker.update_mode = HandTracker.UPDATE_MANUAL
	hmm.tracker.autostart = false
	hmm.mode = GestureHMM.MODE_PAPER
	var models: Array[GestureModel] = []
	for gesture in gestures:
		models.append(load(Rig.MODEL % gesture) as GestureModel)
	hmm.models = models
	root.add_child(hmm.tracker)
	root.add_child(hmm)
	return hmm


func _events(hmm: GestureHMM) -> Array[String]:
	var seen: Array[String] = []
	hmm.gesture_started.connect(
		func(gesture: StringName, _task: GestureTask) -> void: seen.append("started %s" % gesture)
	)
	hmm.gesture_aborted.connect(
		func(gesture: StringName, _task: GestureTask) -> void: seen.append("aborted %s" % gesture)
	)
	hmm.gesture_ended.connect(
		func(gesture: StringName, _time_s: float, _task: GestureTask, _fraction: float) -> void:
			seen.append("ended %s" % gesture)
	)
	return seen


func _play(hmm: GestureHMM) -> void:
	hmm.tracker.start()
	var time_s := 0.0
	while time_s < LENGTH_S and not hmm.tracker.is_finished():
		hmm.tracker.advance_to(time_s)
		time_s += 0.01


func _free(hmm: GestureHMM) -> void:
	hmm.tracker.free()
	hmm.free()
