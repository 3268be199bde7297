extends "support/task_test.gd"
## Tasks that are changed, moved or freed at any time, and tasks with settings that cannot be right.


func test_a_direction_may_have_any_length() -> void:
	for length: float in [1e-20, 1e-3, 3.0, 1e20]:
		var task := _task(&"horizontal_drag", Vector3.ZERO, Vector3(0.6, 0.0, -0.8) * length, 0.2)
		check_near((task.get_axis() - Vector3(0.6, 0.0, -0.8)).length(), 0.0, 1e-6, "%s" % length)
		task.free()


func test_changes_of_tasks_take_effect_at_any_time() -> void:
	var task := _task(&"horizontal_drag", Vector3.ZERO, Vector3.RIGHT, 0.2)
	var other := _task(&"tap", Vector3.ZERO, Vector3.FORWARD, 0.15)
	var hmm := _hmm([task, null, other])
	check_equal(hmm.task, task, "task is the first task")
	check(hmm.current_task == null, "no current task before a gesture")
	_play(hmm, [Vector3.ZERO, Vector3(0.2, 0.0, 0.0)])
	check_equal(hmm.current_task, task, "the current task after its gesture")
	task.free()
	check(hmm.current_task == null and hmm.task == null, "null after it was freed")
	hmm.task = other
	check_equal(hmm.tasks, [other] as Array[GestureTask], "only the other task is left")
	check_equal(
		_ends(_play(hmm, [Vector3.ZERO, 0.15 * Vector3.FORWARD])),
		["ended tap at task 0"] as Array[String],
		"the gesture of the other task"
	)
	hmm.task = null
	check_equal(hmm.tasks, [] as Array[GestureTask], "the list is empty")
	_free(hmm)
	other.free()


func test_a_freed_task_is_ignored() -> void:
	var end := Vector3(0.2, 0.0, 0.0)
	for are_others: bool in [false, true]:
		var task := _task(&"horizontal_drag", Vector3.ZERO, Vector3.RIGHT, 0.2)
		var other := _task(&"vertical_drag", end, Vector3.UP, 0.2)
		var tasks: Array[GestureTask] = [task]
		if are_others:
			tasks.append(other)
		var hmm := _hmm(tasks)
		# expects one warning: all of its "tasks" are null or were freed
		hmm.tracker.frame_received.connect(
			func(_frame: HandFrame) -> void: task.free(), CONNECT_ONE_SHOT
		)
		var seen := _ends(_play(hmm, [Vector3.ZERO, end, end + 0.2 * Vector3.UP]))
		var expected: Array[String] = []
		if are_others:
			expected.append("ended vertical_drag at task 1")
		check_equal(seen, expected, "the other task is used" if are_others else "no gesture ends")
		_free(hmm)
		other.free()


func test_a_task_without_a_finite_position_is_warned_of_and_ignored() -> void:
	var nowhere := _task(&"tap", Vector3(NAN, INF, 0.0), Vector3.FORWARD, 0.15)
	nowhere.name = &"Nowhere"
	var task := _task(&"horizontal_drag", Vector3.ZERO, Vector3.RIGHT, 0.2)
	var hmm := _hmm([nowhere, task])
	# expects one warning: /Nowhere': its global position is not finite
	hmm.tracker.frame_received.connect(
		func(_frame: HandFrame) -> void:
			nowhere.position.y = NAN
			nowhere.force_update_transform()
	)
	var seen := _ends(_play(hmm, [Vector3.ZERO, Vector3(0.2, 0.0, 0.0)]))
	check_equal(
		seen, ["ended horizontal_drag at task 1"] as Array[String], "the other task is used"
	)
	_free(hmm)
	nowhere.free()
	task.free()


func test_a_default_task_of_another_direction_is_warned_of() -> void:
	# expects one warning: to that of 'vertical_drag', is (1, 0, 0)
	# expects one warning: to that of 'tap', is (1, 0, 0)
	for gesture: StringName in [&"vertical_drag", &"tap"]:
		for turned: float in [0.0, 0.5 * PI]:
			var task := _task(gesture, Vector3.ZERO, Vector3.RIGHT, 0.2)
			task.rotate_z(turned)
			var hmm := _hmm([task])
			hmm.tracker.start()
			hmm.tracker.push_frame(0.0, {})
			_free(hmm)
			task.free()


func test_a_task_in_millimetres_is_warned_of() -> void:
	# expects error: : amplitude must be
	# expects one error: : start_radius must be
	# expects one warning: in metres, is 200
	var task := _task(&"horizontal_drag", Vector3.ZERO, Vector3.RIGHT, 0.2)
	task.amplitude = 1e300
	task.amplitude = 1e-300
	task.start_radius = 1e300
	check_equal([task.amplitude, task.start_radius], [0.2, 0.0], "invalid lengths are refused")
	task.amplitude = 200.0
	var hmm := _hmm([task])
	hmm.tracker.start()
	hmm.tracker.push_frame(0.0, {})
	_free(hmm)
	task.free()


func test_a_task_of_a_radius_may_turn_and_move() -> void:
	var task := _task(&"zoom", Vector3.ZERO, Vector3.RIGHT, 0.05)
	task.start_radius = 0.02
	var hmm := _hmm([task])
	hmm.models = [load(Rig.MODEL % "zoom") as GestureModel]
	var ended: Array[StringName] = []
	hmm.gesture_ended.connect(
		func(gesture: StringName, _time_s: float, _task: GestureTask, _fraction: float) -> void:
			ended.append(gesture)
	)
	hmm.tracker.start()
	for frame in 220:
		var p := smoothstep(60.0, 140.0, frame)
		var joints := {}
		for tip in Rig.TIPS.size():
			joints[Rig.TIPS[tip]] = (
				(0.02 + 0.05 * p) * Vector3.RIGHT.rotated(Vector3.BACK, TAU * tip / 3.0)
			)
		hmm.tracker.push_frame(frame * FRAME_S, joints)
		task.rotation.y = 0.01 * frame
		task.position = Vector3(0.01 * frame, NAN, 0.0)
		task.force_update_transform()
	check_equal(ended, [&"zoom"] as Array[StringName], "rotation and position have no effect")
	_free(hmm)
	task.free()


func test_a_task_moved_before_the_first_frame_has_no_warning() -> void:
	var task := _task(&"horizontal_drag", Vector3.ZERO, Vector3.RIGHT, 0.2)
	var hmm := _hmm([task])
	for step in 200:
		task.position.x = 0.01 * step
		task.force_update_transform()
	check_near(task.get_start().x, 1.99, 1e-6, "the task is at its place")
	_free(hmm)
	task.free()


func test_a_task_that_follows_the_hand_is_warned_of_and_never_ends() -> void:
	var task := _task(&"horizontal_drag", Vector3.ZERO, Vector3.RIGHT, 0.2)
	task.name = "Carried"
	var hmm := _hmm([task])
	var end := Vector3(0.2, 0.0, 0.0)
	var carry := func(_time_s: float) -> void:
		task.position.x = 0.5 * hmm.value
		task.force_update_transform()  # as at the end of each frame of a game
	# expects one warning: GestureTask '/root/Carried' keeps moving
	hmm.motion_updated.connect(carry)
	check_equal(
		_ends(_play(hmm, [Vector3.ZERO, end])), [] as Array[String], "a moving task never ends"
	)
	hmm.motion_updated.disconnect(carry)
	task.position = Vector3.ZERO
	check_equal(
		_ends(_play(hmm, [Vector3.ZERO, end])),
		["ended horizontal_drag at task 0"] as Array[String],
		"a task at rest ends"
	)
	_free(hmm)
	task.free()


func test_a_trembling_task_keeps_its_position() -> void:
	for tremble_m: float in [1e-7, 1e-5, 3e-4]:
		var task := _task(&"horizontal_drag", Vector3.ZERO, Vector3.RIGHT, 0.2)
		var hmm := _hmm([task])
		var tremble := func(time_s: float) -> void:
			task.position.y = tremble_m * sin(777.0 * time_s)
			task.force_update_transform()
		hmm.motion_updated.connect(tremble)
		check_equal(
			_ends(_play(hmm, [Vector3.ZERO, Vector3(0.2, 0.0, 0.0)])),
			["ended horizontal_drag at task 0"] as Array[String],
			"by %s m" % tremble_m
		)
		_free(hmm)
		task.free()


func test_a_task_that_was_freed_is_null_in_the_list() -> void:
	var task := _task(&"horizontal_drag", Vector3.ZERO, Vector3.RIGHT, 0.2)
	var hmm := _hmm([task])
	task.free()
	check_equal(hmm.tasks, [null] as Array[GestureTask], "the entry is null")
	var copy := hmm.duplicate() as GestureHMM
	check(copy.tasks.is_empty() or copy.tasks[0] == null, "the engine may copy the node")
	copy.free()
	_free(hmm)
