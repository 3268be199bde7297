extends "support/task_test.gd"
## A scene with several gestures, each at its own place, and one GestureHMM.


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
