extends "support/scene_test.gd"
## Scripts change tracker, models and tasks during a gesture. Other gestures continue to the last
## bit, an aborted one emits its signal, and a new stream is followed from its first frame.

const PushedHand := preload("support/pushed_hand.gd")
const Rig := preload("support/rig.gd")

const FRAME_S := 0.01037
const ONSET_S := 0.8
const DURATION_S := 0.8
const CHANGE_S := 1.25
const END := Vector3(0.2, 0.0, 0.0)
const ELSEWHERE := Vector3(0.3, 0.3, 0.0)

var _events: Array[String] = []


func test_unrelated_changes_keep_an_active_gesture() -> void:
	var values := PackedFloat64Array()
	var changes: Array[StringName] = [
		&"nothing",
		&"move_other",
		&"free_other",
		&"set_same",
		&"add_task",
		&"add_same_task",
		&"reorder",
		&"add_model",
		&"add_same_model"
	]
	for change in changes:
		var tasks: Array[GestureTask] = [_task(&"horizontal_drag"), _task(&"tap", ELSEWHERE)]
		var hmm := _hmm(["horizontal_drag", "tap"], tasks)
		var other := tasks[1]
		var make_it := func() -> void:
			match change:
				&"move_other":
					other.position.x += 0.1
					other.force_update_transform()
				&"free_other":
					other.free()
				&"set_same":
					hmm.tasks = hmm.tasks
					hmm.models = hmm.models
				&"add_task":
					hmm.tasks = hmm.tasks + [_task(&"tap", 2.0 * ELSEWHERE)]
				&"add_same_task":
					hmm.tasks = hmm.tasks + [_task(&"horizontal_drag")]
				&"reorder":
					hmm.tasks = [other, tasks[0]] as Array[GestureTask]
				&"add_model":
					hmm.models = hmm.models + [_model("zoom")]
				&"add_same_model":
					hmm.models = hmm.models + [_model("horizontal_drag")]
		var seen := _drag(hmm, make_it)
		check_equal(_events, ["started", "ended"] as Array[String], "%s: the signals" % change)
		if values.is_empty():
			values = seen
		check(seen == values, "%s: the motion is the same, to the last bit" % change)
		check_near(values[-1], 0.2, 0.01, "%s: the motion reaches the end" % change)
		_free(hmm)


func test_changes_that_abort_an_active_gesture_send_aborted() -> void:
	var changes: Array[StringName] = [
		&"move",
		&"free",
		&"no_models",
		&"quality",
		&"mode",
		&"sensor_latency",
		&"tracker",
		&"source",
		&"restart",
		&"reset"
	]
	for change in changes:
		var task := _task(&"horizontal_drag")
		var hmm := _hmm(["horizontal_drag", "tap"], [task, _task(&"tap", ELSEWHERE)])
		var tracker := hmm.tracker
		var synth := HapticSynth.new()
		synth.gesture_hmm = hmm
		var amplitudes: Array[float] = []
		var note := func(_gesture: StringName, _task: GestureTask) -> void:
			amplitudes.append(synth.get_amplitude())
		hmm.gesture_aborted.connect(note)
		var make_it := func() -> void:
			check(synth.get_amplitude() > 0.1, "%s: it vibrates before" % change)
			match change:
				&"move":
					task.position = 2.0 * ELSEWHERE
					task.force_update_transform()
				&"free":
					task.free()
				&"no_models":
					hmm.models = [_model("tap")] as Array[GestureModel]
				&"quality":
					hmm.quality = GestureHMM.QUALITY_FAST
				&"mode":
					hmm.mode = GestureHMM.MODE_PAPER
				&"sensor_latency":
					hmm.sensor_latency = 0.03
				&"tracker":
					hmm.tracker = null
				&"source":
					tracker.source = ScriptSource.new()
				&"restart":
					tracker.start()
				&"reset":
					hmm.reset()
		# expects one warning: because "models" has none of 'horizontal_drag'
		_drag(hmm, make_it, CHANGE_S + 0.1)
		check_equal(
			_events.slice(0, 2), ["started", "aborted"] as Array[String], "%s: the signals" % change
		)
		check_equal(amplitudes[0], 0.0, "%s: the amplitude at the signal" % change)
		for node: Node in [hmm, tracker, synth]:
			node.free()


func test_a_handler_may_restart_the_tracker_at_the_end_of_a_gesture() -> void:
	for with_second: bool in [false, true]:
		var hmm := _hmm(["horizontal_drag"], [_task(&"horizontal_drag")])
		var tracker := hmm.tracker
		var second := _hmm(["horizontal_drag"], [_task(&"horizontal_drag")])
		second.tracker.free()
		second.tracker = tracker if with_second else null
		var runs: Array[int] = [1]
		var start_anew := func(
			_gesture: StringName, _time_s: float, _task: GestureTask, _fraction: float
		) -> void:
			runs[0] += 1
			tracker.start()
		hmm.gesture_ended.connect(start_anew)
		PushedHand.listen(second if with_second else hmm, _events)
		for run in 4:
			if run == 0:
				tracker.start()
			var frame := 0
			while runs[0] == run + 1 and frame < 300:
				tracker.push_frame(frame * FRAME_S, _hand(frame * FRAME_S))
				frame += 1
			check_equal(runs[0], run + 2, "run %d ends its gesture" % (run + 1))
		check_equal(_events.count("started"), 4, "with a second one: %s" % with_second)
		second.free()
		_free(hmm)


func test_a_handler_may_change_the_tracker() -> void:
	var hmm := _hmm(["horizontal_drag"], [_task(&"horizontal_drag")])
	var left := hmm.tracker
	var right := _tracker()
	for tracker: HandTracker in [left, right]:
		tracker.start()
	var ends: Array[float] = []
	hmm.gesture_ended.connect(
		func(_gesture: StringName, time_s: float, _task: GestureTask, _fraction: float) -> void:
			ends.append(time_s)
			hmm.tracker = right
	)
	# The clock of the right hand is 5 s behind.
	for frame in 900:
		var time_s := frame * FRAME_S
		left.push_frame(time_s, _hand(time_s - 4.5))
		right.push_frame(time_s - 5.0, _hand(time_s - 5.0 - 2.0))
	check_equal(ends.size(), 2, "a drag of each hand")
	check(ends[0] > 5.0 and ends[1] < 4.5, "each end is on its tracker's clock")
	left.free()
	right.free()
	hmm.free()


func test_repeated_frames_give_signals_in_order() -> void:
	var path := "res://addons/steadyhand/models/%s.gesture"
	check(FileAccess.file_exists(path % "horizontal_drag"), "there is a model")
	for seed_of_hand in 40:
		var hmm := _hmm(["horizontal_drag"], [])
		PushedHand.listen(hmm, _events)
		hmm.tracker.start()
		var random := RandomNumberGenerator.new()
		random.seed = seed_of_hand
		var at := Vector3.ZERO
		var to := Vector3.ZERO
		var from_s := 0.0
		var take_s := 1.0
		for frame in 700:
			var time_s := frame / 90.0
			if time_s > from_s + take_s:
				at = to
				from_s = time_s
				take_s = random.randf_range(0.25, 1.0)
				to = Vector3(random.randf_range(-0.3, 0.3), 0.0, 0.0)
			var tip := at.lerp(to, PushedHand.share((time_s - from_s) / (0.7 * take_s)))
			for time in 2:
				hmm.tracker.push_frame(time_s, {HandTracker.JOINT_INDEX: tip})
		var is_active := false
		var are_in_order := true
		for event in _events:
			are_in_order = are_in_order and is_active != (event == "started")
			is_active = event == "started"
		check(are_in_order, "hand %d: starts and ends alternate" % seed_of_hand)
		_free(hmm)


func test_all_signals_of_a_frame_are_sent_if_handlers_change_properties() -> void:
	for signal_name: StringName in [&"gesture_started", &"gesture_aborted", &"state_changed"]:
		for change: StringName in [&"models", &"reset"]:
			var starts := 0
			# Zooms with bad tracking, some of which look like a drag of the index at first.
			for subject: int in [0, 4, 8, 12, 16, 20]:
				var hmm := _hmm(["zoom", "tap", "vertical_drag", "horizontal_drag"], [])
				var tracker := hmm.tracker
				var source := SyntheticSource.new()
				source.gesture = &"zoom"
				source.position = SyntheticSource.POSITION_UNSTABLE
				source.subject = subject
				source.seed = subject
				tracker.source = source
				tracker.start()
				PushedHand.listen(hmm, _events)
				var states: Array[int] = [-1]
				hmm.state_changed.connect(func(state: int) -> void: states.append(state))
				var set_again := func() -> void:
					if change == &"reset":
						hmm.reset()
					else:
						hmm.models = hmm.models
				hmm.connect(
					signal_name, set_again.unbind(1 if signal_name == &"state_changed" else 2)
				)
				var mistakes := 0
				for frame in 400:
					tracker.advance(0.01)
					mistakes += int(states[-1] != hmm.state)
				var is_active := false
				for event in _events:
					mistakes += int(is_active == (event == "started"))
					is_active = event == "started"
				starts += _events.count("started")
				check_equal(mistakes, 0, "%s in %s, subject %d" % [change, signal_name, subject])
				_free(hmm)
			check(starts > 5, "there were gestures")


func test_a_recording_continues_if_another_cannot_begin() -> void:
	var folder := DirAccess.create_temp("steadyhand_changes")
	var path := folder.get_current_dir().path_join("kept.csv")
	var tracker := _tracker()
	tracker.start()
	check_equal(tracker.start_recording(path), OK, "the first one begins")
	tracker.push_frame(0.0, _hand(0.0))
	# expects one error: this is a folder, not a file
	folder.make_dir("folder.csv")
	var other := folder.get_current_dir().path_join("folder.csv")
	check(tracker.start_recording(other) != OK, "the second one is refused")
	tracker.push_frame(1.0, _hand(1.0))
	tracker.stop_recording()
	var rows := FileAccess.get_file_as_string(path).split("\n", false)
	check(
		rows[-1].begins_with("1.0") or rows[-1].begins_with("1,"),
		"the first one has the next frame"
	)
	tracker.free()


func test_each_mistake_of_a_pushed_frame_is_explained() -> void:
	var tracker := _tracker()
	# expects one error: push_frame: call start() first
	# expects one error: push_frame: the time 1.0 s is before 2.0 s
	# expects one error: push_frame: the time must be finite
	# expects one error: push_frame: there is no joint 99
	# expects one error: the key 'index' is of type String
	# expects one error: that of joint 10 is of type float
	for time in 2:
		check(tracker.push_frame(0.0, {}) != OK, "not started")
	tracker.start()
	tracker.push_frame(2.0, {})
	for time in 2:
		check(tracker.push_frame(1.0, {}) != OK, "late")
		check(tracker.push_frame(NAN, {}) != OK, "time is NAN")
		check(tracker.push_frame(3.0, {99: Vector3.ZERO}) != OK, "an unknown joint")
		check(tracker.push_frame(3.0, {"index": Vector3.ZERO}) != OK, "a joint by name")
		check(tracker.push_frame(3.0, {HandTracker.JOINT_INDEX: 0.1}) != OK, "a number as position")
	tracker.free()


func test_a_progress_handler_may_free_the_trainer() -> void:
	var folder := DirAccess.create_temp("steadyhand_changes")
	var trials := Rig.write_trials(folder.get_current_dir())
	var held: Array[GestureTrainer] = [GestureTrainer.new()]
	held[0].progressed.connect(func(_done: float) -> void: held.clear())
	var model: GestureModel = held[0].train(trials, &"horizontal_drag")
	check(held.is_empty() and model != null, "the training completes")


## A drag from rest with the change at CHANGE_S. The signals are in _events. Returns the value at
## each instant.
func _drag(hmm: GestureHMM, change: Callable, until_s: float = 2.4) -> PackedFloat64Array:
	var values := PackedFloat64Array()
	PushedHand.listen(hmm, _events)
	hmm.motion_updated.connect(func(_time_s: float) -> void: values.append(hmm.value))
	var tracker := hmm.tracker
	tracker.start()
	var is_changed := false
	var frame := 0
	while frame * FRAME_S < until_s:
		if not is_changed and frame * FRAME_S > CHANGE_S:
			is_changed = true
			change.call()
		tracker.push_frame(frame * FRAME_S, _hand(frame * FRAME_S))
		frame += 1
	return values


func _hand(time_s: float) -> Dictionary:
	var tip := END * PushedHand.share((time_s - ONSET_S) / DURATION_S)
	return {HandTracker.JOINT_INDEX: tip + PushedHand.tremor(time_s)}


func _task(gesture: StringName, start: Vector3 = Vector3.ZERO) -> GestureTask:
	var task := GestureTask.new()
	task.gesture = gesture
	task.direction = Vector3.RIGHT if gesture == &"horizontal_drag" else Vector3.FORWARD
	task.amplitude = 0.2
	root.add_child(task)
	task.global_position = start
	return task


func _tracker() -> HandTracker:
	var tracker := HandTracker.new()
	tracker.source = ScriptSource.new()
	tracker.autostart = false
	root.add_child(tracker)
	return tracker


func _model(gesture: String) -> GestureModel:
	return load(Rig.MODEL % gesture) as GestureModel


func _hmm(gestures: Array[String], tasks: Array[GestureTask]) -> GestureHMM:
	var hmm := GestureHMM.new()
	var models: Array[GestureModel] = []
	for gesture in gestures:
		models.append(_model(gesture))
	hmm.models = models
	hmm.tasks = tasks
	hmm.tracker = _tracker()
	root.add_child(hmm)
	return hmm


func _free(hmm: GestureHMM) -> void:
	hmm.tracker.free()
	for task in hmm.tasks:
		if is_instance_valid(task):
			task.free()
	hmm.free()
