extends "support/scene_test.gd"
## Actions of scripts in signal handlers, on arrays of properties, and on saved scenes.

const Rig := preload("support/rig.gd")

const STABLE := 0

var _folder := DirAccess.create_temp("steadyhand_handlers")
var _trials := Rig.write_trials(_folder.get_current_dir())


func test_a_handler_may_free_the_tracker() -> void:
	for does_push: bool in [false, true]:
		var rig := _make_rig()
		var tracker := rig.tracker
		rig.gesture_hmm.gesture_started.connect(
			func(_gesture: StringName, _task: GestureTask) -> void: tracker.free()
		)
		if does_push:
			_push_drag(rig)
		else:
			tracker.start()
			for step in range(0, 2400):
				if is_instance_valid(tracker):
					tracker.advance_to(step * Rig.STEP_S)
		check(not is_instance_valid(tracker), "freed while it delivered a frame")
		check(rig.gesture_hmm.tracker == null, "the GestureHMM has no tracker")
		rig.gesture_hmm.free()
		rig.task.free()


func test_a_handler_may_free_the_scene_of_the_gesture() -> void:
	for signal_name: StringName in [&"gesture_started", &"state_changed", &"motion_updated"]:
		var rig := _make_rig()
		var scene := Node.new()
		root.add_child(scene)
		rig.gesture_hmm.reparent(scene)
		# expects error: was freed or unreferenced while a signal is being emitted from it
		var leave := func() -> void: scene.free()
		rig.gesture_hmm.connect(
			signal_name, leave.unbind(2 if signal_name == &"gesture_started" else 1)
		)
		rig.tracker.start()
		rig.tracker.advance_to(2.4)
		check(not is_instance_valid(scene), "freed by a handler of %s" % signal_name)
		rig.tracker.free()
		rig.task.free()


func test_a_tracker_that_is_freed_leaves_no_gesture() -> void:
	var rig := _make_rig()
	var hmm := rig.gesture_hmm
	var states: Array[int] = []
	hmm.state_changed.connect(func(state: int) -> void: states.append(state))
	rig.tracker.start()
	var step := 0
	while hmm.gesture == &"" and step < 2400:
		step += 1
		rig.tracker.advance_to(step * Rig.STEP_S)
	check(hmm.gesture != &"", "under way")
	rig.tracker.free()
	check_equal(hmm.gesture, &"", "no gesture without a tracker")
	check_equal(hmm.state, -1, "no state")
	check_equal(states[-1], -1, "the signal has state -1")
	hmm.free()
	rig.task.free()


func test_a_handler_may_push_the_next_frame() -> void:
	var tracker := HandTracker.new()
	tracker.source = ScriptSource.new()
	tracker.autostart = false
	root.add_child(tracker)
	tracker.start()
	var stamps: Array[float] = []
	tracker.frame_received.connect(
		func(frame: HandFrame) -> void:
			stamps.append(frame.time)
			if frame.time < 0.25:
				tracker.push_frame(frame.time + 0.1, {HandTracker.JOINT_INDEX: Vector3.ZERO})
	)
	tracker.push_frame(0.0, {HandTracker.JOINT_INDEX: Vector3.ZERO})
	check_equal(stamps.size(), 4, "each frame is pushed by the handler of the one before")
	check_near(tracker.get_time(), 0.3, 1e-12, "the clock stays at the newest frame")
	# expects error: is before 0.3 s
	check(tracker.push_frame(0.05, {}) != OK, "an older frame is refused")
	tracker.free()


func test_a_reset_in_a_handler_sends_no_old_signals() -> void:
	var rig := _make_rig()
	var hmm := rig.gesture_hmm
	var states: Array[int] = []
	var has_reset: Array[bool] = [false]
	hmm.state_changed.connect(func(state: int) -> void: states.append(state))
	hmm.gesture_started.connect(
		func(_gesture: StringName, _task: GestureTask) -> void:
			if not has_reset[0]:
				has_reset[0] = true
				hmm.reset()
				check(states.is_empty(), "no state was sent before the reset")
	)
	rig.tracker.start()
	for step in range(0, 2400):
		rig.tracker.advance_to(step * Rig.STEP_S)
		if not states.is_empty():
			check_equal(states[-1], hmm.state, "the last signal has the present state")
			break
	rig.free_nodes()


func test_the_arrays_are_read_only_copies() -> void:
	# expects error: Array is in read-only state
	var rig := _make_rig()
	var hmm := rig.gesture_hmm
	for array: Array in [hmm.models, hmm.tasks]:
		check(array.is_read_only(), "append() is an error of the engine")
		array.append(null)
	check_equal(hmm.models.size(), 1, "and does not change the models")
	check_equal(hmm.tasks.size(), 1, "nor the tasks")
	var task := GestureTask.new()
	hmm.tasks += [task]
	check_equal(hmm.tasks, [rig.task, task] as Array[GestureTask], "a task is added")
	hmm.tasks = hmm.tasks.filter(func(one: GestureTask) -> bool: return one != task)
	check_equal(hmm.tasks, [rig.task] as Array[GestureTask], "and removed")
	task.free()
	var models: Array[GestureModel] = [hmm.models[0], hmm.models[0]]
	hmm.models = models
	models.clear()
	check_equal(hmm.models.size(), 2, "a change of the assigned array does not change them")
	rig.free_nodes()
	var synth := HapticSynth.new()
	var effects: Array[HapticEffect] = [SpringEffect.new()]
	synth.effects = effects
	effects.append(null)
	check(synth.effects.is_read_only(), "the effects are read-only, too")
	check_equal(synth.effects.size(), 1, "a change of the assigned array does not change them")
	synth.free()


func test_tasks_are_saved_with_their_scene() -> void:
	var scene := Node.new()
	var hmm := GestureHMM.new()
	var task := GestureTask.new()
	task.name = "Task"
	for node: Node in [task, hmm]:
		scene.add_child(node)
		node.owner = scene
	hmm.tasks = [task]
	var packed := PackedScene.new()
	check_equal(packed.pack(scene), OK, "the scene is packed")
	var copy := packed.instantiate()
	var copied := copy.get_child(1) as GestureHMM
	check(copied.tasks[0] == copy.get_node("Task"), "its tasks are the scene's own nodes")
	copy.free()
	scene.free()


func test_invalid_numbers_are_refused() -> void:
	var rig := _make_rig()
	var hmm := rig.gesture_hmm
	rig.record(0, 1000)
	for no_time: float in [NAN, INF, -INF]:
		check_equal(hmm.get_value_at(no_time), hmm.value, "an invalid time gives the present value")
	# expects error: : update_mode must be one of UPDATE_*
	rig.tracker.update_mode = 9 as HandTracker.UpdateMode
	check_equal(
		rig.tracker.update_mode, HandTracker.UPDATE_MANUAL, "an invalid update mode is refused"
	)
	# expects error: : motion must be one of MOTION_*
	hmm.motion = 7 as GestureHMM.Motion
	check_equal(hmm.motion, GestureHMM.MOTION_SYNTHESISED, "an invalid motion is refused")
	var spring := SpringEffect.new()
	# expects error: SpringEffect: drive must be one of DRIVE_*
	spring.drive = 9 as HapticEffect.Drive
	check_equal(spring.drive, HapticEffect.DRIVE_POSITION, "an invalid drive is refused")
	# expects error: SpringEffect: trigger must be one of TRIGGER_*
	spring.trigger = -1 as HapticEffect.Trigger
	check_equal(spring.trigger, HapticEffect.TRIGGER_MOVING, "an invalid trigger is refused")
	rig.free_nodes()

	var tracker := HandTracker.new()
	tracker.source = ScriptSource.new()
	tracker.autostart = false
	root.add_child(tracker)
	tracker.start()
	var far := {HandTracker.JOINT_INDEX: Vector3(3e38, 0.0, 0.0)}
	check_equal(tracker.push_frame(0.0, far), OK, "a position out of range is accepted")
	check(not tracker.is_joint_tracked(HandTracker.JOINT_INDEX), "the joint is not tracked")
	tracker.free()
	var source := SyntheticSource.new()
	source.seed = 1 << 40
	check_equal(source.seed, 1 << 40, "a seed may have 64 bits")
	# expects error: SyntheticSource: subject must be 0..4294967295
	source.subject = 1 << 40
	check_equal(source.subject, 0, "a subject of more than 32 bits is refused")
	var synth := HapticSynth.new()
	# expects error: : joypad must be -1 (none) or the number of a joypad
	synth.joypad = 1 << 40
	check_equal(synth.joypad, -1, "an invalid joypad is refused")
	synth.free()


func test_a_gesture_without_its_required_task_is_warned_of() -> void:
	var hmm := GestureHMM.new()
	var circle := FileAccess.get_file_as_string(Rig.MODEL % "horizontal_drag").replace(
		'"index_along_axis"', '"index_along_circle"'
	)
	var path := _folder.get_current_dir().path_join("circle.gesture")
	FileAccess.open(path, FileAccess.WRITE).store_string(circle)
	hmm.models = [load(path) as GestureModel]
	var tracker := HandTracker.new()
	tracker.source = ScriptSource.new()
	tracker.autostart = false
	hmm.tracker = tracker
	for node: Node in [tracker, hmm]:
		root.add_child(node)
	tracker.start()
	# expects warning: this gesture is measured from the task's start
	tracker.push_frame(0.0, {HandTracker.JOINT_INDEX: Vector3.ZERO})
	check(hmm.gesture == &"", "without a task it is not recognised")
	for node: Node in [hmm, tracker]:
		node.free()


func _push_drag(rig: Rig) -> void:
	rig.tracker.source = ScriptSource.new()
	rig.tracker.start()
	var trial := _trials.get_trial(STABLE)
	for frame in 200:
		if not is_instance_valid(rig.tracker):
			return
		var part := smoothstep(60.0, 130.0, frame)
		var tip: Vector3 = trial["start"] + part * trial["amplitude_m"] * trial["axis"]
		rig.tracker.push_frame(frame * 0.01, {HandTracker.JOINT_INDEX: tip})


func _make_rig() -> Rig:
	return Rig.new(_trials.get_trial(STABLE), _trials.get_measured_path(STABLE), root)
