extends "support/scene_test.gd"
## A scene with several gestures, each at its own place, and one GestureHMM.

const PushedHand := preload("support/pushed_hand.gd")
const Rig := preload("support/rig.gd")

const FRAME_S := 1.0 / 110.0
const REST_S := 0.6
const MOVE_S := 0.7


func test_each_signal_has_the_task_of_its_gesture() -> void:
	var corner := Vector3(0.2, 0.0, 0.0)
	var top := Vector3(0.2, 0.2, 0.0)
	var tasks: Array[GestureTask] = [
		_task(&"tap", top, Vector3.FORWARD, 0.15),
		_task(&"horizontal_drag", Vector3.ZERO, Vector3.RIGHT, 0.2),
		_task(&"vertical_drag", corner, Vector3.UP, 0.2),
	]
	for mode: GestureHMM.Mode in [GestureHMM.MODE_PHASE, GestureHMM.MODE_PAPER]:
		var hmm := _hmm(tasks)
		hmm.mode = mode
		var seen := _play(hmm, [Vector3.ZERO, corner, top, top + 0.15 * Vector3.FORWARD])
		var expected: Array[String] = []
		for i: int in [1, 2, 0]:
			expected.append("started %s at task %d" % [tasks[i].gesture, i])
			expected.append("ended %s at task %d" % [tasks[i].gesture, i])
		check_equal(seen, expected, "mode %d" % mode)
		check_near(hmm.value, 0.15, 0.01, "mode %d: the value is the last one's" % mode)
		_free(hmm)
	for task in tasks:
		task.free()


func test_a_gesture_is_felt_the_same_at_one_of_several_tasks() -> void:
	var end := Vector3(0.2, 0.0, 0.0)
	var task := _task(&"horizontal_drag", Vector3.ZERO, Vector3.RIGHT, 0.2)
	var before := _task(&"horizontal_drag", Vector3(-0.6, 0.1, 0.0), Vector3.RIGHT, 0.2)
	var beyond := _task(&"vertical_drag", Vector3(0.0, -0.7, 0.0), Vector3.UP, 0.4)
	var alone := _felt([task], [Vector3.ZERO, end])
	check(alone.max() as float > 0.9, "the spring is stretched")
	for tasks: Array[GestureTask] in [
		[before, task, beyond] as Array[GestureTask],
		[beyond, before, task] as Array[GestureTask],
	]:
		var felt := _felt(tasks, [Vector3.ZERO, end])
		var instants := range(mini(felt.size(), alone.size()))
		var off := instants.map(func(i: int) -> float: return absf(felt[i] - alone[i]))
		check_near(off.max() as float, 0.0, 0.0, "at task %d" % tasks.find(task))
	for one: GestureTask in [task, before, beyond]:
		one.free()


func test_a_gesture_from_the_last_ones_end_has_the_same_haptics() -> void:
	var end := Vector3(0.2, 0.0, 0.0)
	var below := Vector3(0.2, -0.15, 0.0)
	var places: Array[Vector3] = [Vector3.ZERO, end, below, below + Vector3(0.0, 0.0, -0.15)]
	var drag := _task(&"horizontal_drag", Vector3.ZERO, Vector3.RIGHT, 0.2)
	var tap := _task(&"tap", below, Vector3.FORWARD, 0.15)
	var alone := _felt([tap], places)
	var both := _felt([drag, tap], places)
	var set_out := roundi(1000.0 * (3.0 * REST_S + 2.0 * MOVE_S))
	var instants := range(set_out, mini(both.size(), alone.size()))
	# The tap's estimator starts later after a drag, so that its end may differ by some ms.
	var off := instants.map(
		func(i: int) -> float:
			var near := range(maxi(i - 3, 0), mini(i + 4, both.size()))
			return near.map(func(k: int) -> float: return absf(both[k] - alone[i])).min()
	)
	check(instants.any(func(i: int) -> bool: return alone[i] > 0.2), "the tap is felt")
	check_near(off.max() as float, 0.0, 0.02, "the same vibration after a drag")
	for one: GestureTask in [drag, tap]:
		one.free()


func test_a_direction_may_have_any_length() -> void:
	for length: float in [1e-20, 1e-3, 3.0, 1e20]:
		var task := _task(&"horizontal_drag", Vector3.ZERO, Vector3(0.6, 0.0, -0.8) * length, 0.2)
		check_near((task.get_axis() - Vector3(0.6, 0.0, -0.8)).length(), 0.0, 1e-6, "%s" % length)
		task.free()


func test_tasks_on_one_line_end_one_after_the_other() -> void:
	var middle := Vector3(0.2, 0.0, 0.0)
	var end := Vector3(0.4, 0.0, 0.0)
	var first := _task(&"horizontal_drag", Vector3.ZERO, Vector3.RIGHT, 0.2)
	var second := _task(&"horizontal_drag", middle, Vector3.RIGHT, 0.2)
	var both := _task(&"horizontal_drag", Vector3.ZERO, Vector3.RIGHT, 0.4)
	var from_box_to_box := _hmm([first, second])
	check_equal(
		_ends(_play(from_box_to_box, [Vector3.ZERO, middle, end])),
		["ended horizontal_drag at task 0", "ended horizontal_drag at task 1"] as Array[String],
		"two boxes"
	)
	_free(from_box_to_box)
	var near_and_far := _hmm([both, first])
	check_equal(
		_ends(_play(near_and_far, [Vector3.ZERO, end])),
		["ended horizontal_drag at task 1", "ended horizontal_drag at task 0"] as Array[String],
		"a near task and a far one"
	)
	check_near(near_and_far.value, 0.4, 0.02, "the value of the far task")
	_free(near_and_far)
	for task in [first, second, both]:
		task.free()


func test_a_reset_at_a_start_with_an_immediate_end_sends_aborted() -> void:
	var far := _task(&"horizontal_drag", Vector3.ZERO, Vector3.RIGHT, 0.4)
	var near := _task(&"horizontal_drag", Vector3.ZERO, Vector3.RIGHT, 0.2)
	var hmm := _hmm([far, near])
	var events: Array[String] = []
	var reset := func(_gesture: StringName, _task: GestureTask) -> void:
		events.append("started at %d" % hmm.tasks.find(hmm.current_task))
		if hmm.current_task == near:
			hmm.reset()
	hmm.gesture_started.connect(reset)
	hmm.gesture_ended.connect(
		func(_gesture: StringName, _time_s: float, _task: GestureTask, _fraction: float) -> void:
			events.append("ended")
	)
	hmm.gesture_aborted.connect(
		func(_gesture: StringName, _task: GestureTask) -> void: events.append("aborted")
	)
	_play(hmm, [Vector3.ZERO, Vector3(0.4, 0.0, 0.0)])
	check(events.has("started at 1"), "the near task has started: %s" % [events])
	var over := events.count("ended") + events.count("aborted")
	check_equal(
		over, events.size() - over, "each started gesture has ended or is aborted: %s" % [events]
	)
	_free(hmm)
	for one: GestureTask in [far, near]:
		one.free()


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


## The amplitude of the vibration at each instant.
func _felt(tasks: Array[GestureTask], places: Array[Vector3]) -> Array[float]:
	var hmm := _hmm(tasks)
	var synth := HapticSynth.new()
	synth.effects = [SpringEffect.new(), ImpulseEffect.new()]
	synth.gesture_hmm = hmm
	root.add_child(synth)
	var felt: Array[float] = []
	var note := func(_time_s: float) -> void: felt.append(synth.get_amplitude())
	hmm.motion_updated.connect(note)
	_play(hmm, places)
	synth.free()
	_free(hmm)
	return felt


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
