extends "support/scene_test.gd"
## Signals and properties of a GestureHMM during a drag.

const Rig := preload("support/rig.gd")

## Index of the trial at the stable position.
const STABLE := 0

var _folder := DirAccess.create_temp("steadyhand_hmm")
var _trials := Rig.write_trials(_folder.get_current_dir())


func test_signals_of_a_drag() -> void:
	var events: Array[String] = []
	var states: Array[int] = []
	var rig := _make_rig(STABLE)
	rig.gesture_hmm.gesture_started.connect(
		func(gesture: StringName, _task: GestureTask) -> void: events.append("started %s" % gesture)
	)
	rig.gesture_hmm.gesture_ended.connect(
		func(gesture: StringName, _time_s: float, _task: GestureTask, _fraction: float) -> void:
			events.append("ended %s" % gesture)
	)
	rig.gesture_hmm.state_changed.connect(func(state: int) -> void: states.append(state))
	check_equal(rig.gesture_hmm.state, -1, "no state before the gesture")
	rig.record(0, 2400)
	check_equal(
		events,
		["started horizontal_drag", "ended horizontal_drag"] as Array[String],
		"a drag starts and ends once"
	)
	check_equal(states.slice(0, 1), [0] as Array[int], "the first state is 0")
	check(states.has(3), "the last state is reached: %s" % [states])
	rig.free_nodes()


func test_progress_is_a_share() -> void:
	var folder := _folder.get_current_dir().path_join("taps")
	var trials := Rig.write_trials(folder, 2, "tap")
	var least := INF
	var most := -INF
	for trial in trials.get_count():
		var rig := Rig.new(trials.get_trial(trial), trials.get_measured_path(trial), root)
		rig.tracker.start()
		for step in 2400:
			rig.tracker.advance_to(step * Rig.STEP_S)
			least = minf(least, rig.gesture_hmm.progress)
			most = maxf(most, rig.gesture_hmm.progress)
		rig.free_nodes()
	check_equal(least, 0.0, "from 0")
	check_equal(most, 1.0, "to 1")


func test_half_a_drag_is_aborted() -> void:
	for leaves: bool in [false, true]:
		var events: Array[String] = []
		var rig := _make_rig(STABLE)
		rig.tracker.source = ScriptSource.new()
		rig.gesture_hmm.gesture_started.connect(
			func(gesture: StringName, _task: GestureTask) -> void:
				events.append("started %s" % gesture)
		)
		rig.gesture_hmm.gesture_aborted.connect(
			func(gesture: StringName, _task: GestureTask) -> void:
				events.append("aborted %s" % gesture)
		)
		rig.gesture_hmm.gesture_ended.connect(
			func(gesture: StringName, _time_s: float, _task: GestureTask, _fraction: float) -> void:
				events.append("ended %s" % gesture)
		)
		var is_probability := true
		var random := RandomNumberGenerator.new()
		random.seed = 7
		var trial: Dictionary = _trials.get_trial(STABLE)
		rig.tracker.start()
		for frame in 400:
			# Half of the way, and back or out of sight, on cosines.
			var phase := clampf((frame * 0.01 - 0.5) / 2.0, 0.0, 0.5 if leaves else 1.0)
			var part := 0.25 * (1.0 - cos(TAU * phase)) * float(trial["amplitude_m"])
			var tremble := random.randfn(0.0, 1e-4)
			var tip: Vector3 = trial["start"] + (part + tremble) * trial["axis"]
			var is_seen := not leaves or frame <= 200
			rig.tracker.push_frame(frame * 0.01, {HandTracker.JOINT_INDEX: tip} if is_seen else {})
			var confidence := rig.gesture_hmm.confidence
			is_probability = is_probability and confidence >= 0.0 and confidence <= 1.0
		check_equal(
			events,
			["started horizontal_drag", "aborted horizontal_drag"] as Array[String],
			"half a drag starts and is aborted"
		)
		check(is_probability, "confidence stays within 0..1")
		check_equal(rig.gesture_hmm.confidence, 0.0, "confidence is 0 without an active gesture")
		check_near(rig.gesture_hmm.value, 0.0, 0.002, "the motion is back at the start")
		rig.free_nodes()


func test_condition_is_switched_live() -> void:
	var rig := _make_rig(0)
	rig.tracker.start()
	var is_same := true
	for step in range(0, 2400):
		rig.tracker.advance_to(step * Rig.STEP_S)
		var motion := Rig.MOTIONS[step % Rig.MOTIONS.size()]
		rig.gesture_hmm.motion = motion
		is_same = is_same and rig.gesture_hmm.value == rig.gesture_hmm.get_motion_value(motion)
	check(is_same, "value is that of the chosen condition from the switch on")
	rig.free_nodes()

	var undisturbed := _make_rig(0)
	var values := undisturbed.record(0, 2399)
	var last := values.slice(values.size() - Rig.MOTIONS.size())
	undisturbed.free_nodes()
	var switched := _make_rig(0)
	switched.tracker.start()
	for step in range(0, 2400):
		switched.gesture_hmm.motion = Rig.MOTIONS[step % Rig.MOTIONS.size()]
		switched.tracker.advance_to(step * Rig.STEP_S)
	for i in Rig.MOTIONS.size():
		check_equal(
			switched.gesture_hmm.get_motion_value(Rig.MOTIONS[i]),
			last[i],
			"condition %d is the same as without a switch" % i
		)
	switched.free_nodes()


func test_only_the_tasks_model_is_active() -> void:
	var rig := _make_rig(0)
	rig.task.gesture = &"vertical_drag"
	rig.record(0, 2400)
	check_equal(String(rig.gesture_hmm.recognised), "", "not recognised at another gesture's task")
	rig.free_nodes()


func test_a_task_without_a_gesture_is_for_a_single_model_only() -> void:
	var names: Array[String] = ["horizontal_drag", "tap", "vertical_drag", "zoom"]
	var orders: Array[Array] = [names, names.duplicate(), ["horizontal_drag"]]
	orders[1].reverse()
	for order in orders:
		var rig := _make_rig(STABLE)
		var models: Array[GestureModel] = []
		for gesture: String in order:
			models.append(load(Rig.MODEL % gesture) as GestureModel)
		rig.gesture_hmm.models = models
		rig.task.gesture = &""
		rig.record(0, 2400)
		check_equal(String(rig.gesture_hmm.recognised), "horizontal_drag", "%s" % [order])
		rig.free_nodes()


func test_get_value_at_predicts_the_value() -> void:
	var rig := _make_rig(STABLE)
	rig.tracker.start()
	rig.tracker.advance_to(1.0)
	var hmm := rig.gesture_hmm
	check_equal(hmm.get_value_at(hmm.time), hmm.value, "the present value")
	check_equal(hmm.get_value_at(hmm.time - 1.0), hmm.value, "a past time gives the present value")
	var furthest := 0.0
	for step in range(1000, 2000, 10):
		rig.tracker.advance_to(step * Rig.STEP_S)
		var ahead := hmm.get_value_at((step + 1) * Rig.STEP_S)
		rig.tracker.advance_to((step + 1) * Rig.STEP_S)
		furthest = maxf(furthest, absf(ahead - hmm.value))
	check(furthest < 0.0005, "1 ms ahead: at most %f m off" % furthest)
	rig.free_nodes()


func test_quality() -> void:
	var gesture_hmm := GestureHMM.new()
	check_equal(gesture_hmm.quality, GestureHMM.QUALITY_BALANCED, "balanced by default")
	gesture_hmm.free()

	var curves: Array[PackedFloat64Array] = []
	for quality: GestureHMM.Quality in [
		GestureHMM.QUALITY_FAST, GestureHMM.QUALITY_BALANCED, GestureHMM.QUALITY_ACCURATE
	]:
		var rig := _make_rig(STABLE)
		rig.gesture_hmm.quality = quality
		curves.append(rig.record(0, 2400))
		check_equal(String(rig.gesture_hmm.recognised), "horizontal_drag", "recognised")
		rig.free_nodes()
	check(curves[0] != curves[2] and curves[1] != curves[2], "each quality gives another motion")
	var amplitude: float = _trials.get_trial(STABLE)["amplitude_m"]
	for i in 2:
		var furthest := 0.0
		for step in curves[2].size():
			furthest = maxf(furthest, absf(curves[i][step] - curves[2][step]))
		check(furthest < 0.05 * amplitude, "near the accurate one with good tracking")


func test_a_known_sensor_latency_is_compensated() -> void:
	const LATENCY_MS := 50
	var amplitude: float = _trials.get_trial(STABLE)["amplitude_m"]
	var half_way_ms: Array[int] = []
	for latency_ms: int in [0, LATENCY_MS]:
		var rig := _make_rig(STABLE)
		rig.gesture_hmm.sensor_latency = latency_ms / 1000.0
		var values := rig.record(0, 2400)
		var step := 0
		while values[(step + 1) * Rig.MOTIONS.size() - 1] < 0.5 * amplitude:
			step += 1
		half_way_ms.append(step)
		rig.free_nodes()
	var earlier_ms := half_way_ms[0] - half_way_ms[1]
	check(absi(earlier_ms - LATENCY_MS) < 10, "earlier by %d ms" % earlier_ms)


func test_min_confidence_may_change_at_any_time() -> void:
	# expects error: min_confidence must be 0..1, is
	var rig := _make_rig(STABLE)
	var hmm := rig.gesture_hmm
	hmm.tasks = []
	hmm.min_confidence = 1.01
	hmm.min_confidence = -0.01
	hmm.min_confidence = NAN
	check_equal(hmm.min_confidence, 0.0, "values out of range are refused")
	var least: Array[float] = []
	hmm.gesture_started.connect(
		func(_gesture: StringName, _task: GestureTask) -> void: least.append(hmm.confidence)
	)
	for wanted: float in [0.9, 1.0]:
		hmm.min_confidence = wanted
		rig.record(0, 2400)
		var is_shown := wanted < 1.0
		check_equal(String(hmm.recognised), "horizontal_drag" if is_shown else "", "at %s" % wanted)
		check_equal(least.size(), 1, "started once with 0.9")
	check(least[0] >= 0.9, "started at confidence %s" % least[0])
	# The confidence stays below 1. From half of the movement on, 0 is enough.
	rig.tracker.start()
	var trial := _trials.get_trial(STABLE)
	var half_way_s: float = 0.5 * (trial["start_s"] + trial["end_s"])
	rig.tracker.advance_to(half_way_s)
	check_equal(hmm.gesture, &"", "not active half-way")
	hmm.min_confidence = 0.0
	rig.tracker.advance_to(half_way_s + 0.1)
	check_equal(String(hmm.gesture), "horizontal_drag", "active after the change")
	rig.free_nodes()


func test_joints_that_no_frame_holds_are_named() -> void:
	# expects warning: It needs thumb, index, middle; no frame had thumb, middle
	var rig := _make_rig(STABLE)
	rig.tracker.source = ScriptSource.new()
	rig.gesture_hmm.models = [load(Rig.MODEL % "zoom")]
	rig.task.gesture = &"zoom"
	rig.task.start_radius = 0.03
	rig.tracker.start()
	for i in 1000:
		rig.tracker.push_frame(0.01 * i, {HandTracker.JOINT_INDEX: Vector3(0.001 * i, 0, 0)})
		if i == 500:
			rig.task.amplitude *= 1.1
	rig.free_nodes()


func test_joints_of_no_model_without_a_task_are_named() -> void:
	# expects one warning: 'horizontal_drag' is not recognised. It needs index; no frame had index
	var rig := _make_rig(STABLE)
	rig.tracker.source = ScriptSource.new()
	rig.gesture_hmm.models = [load(Rig.MODEL % "horizontal_drag"), load(Rig.MODEL % "tap")]
	rig.gesture_hmm.tasks = []
	rig.tracker.start()
	for i in 1000:
		rig.tracker.push_frame(0.01 * i, {HandTracker.JOINT_PALM: Vector3(0.001 * i, 0, 0)})
	rig.free_nodes()


func test_warnings_name_what_prevents_recognition() -> void:
	# expects warning: because "models" is empty. Set it to an array of *.gesture files
	# expects warning: because all "models" are empty
	# expects warning: because "models" has none of 'tap'
	# expects warning: Set "direction" of GestureTask
	# expects warning: Set "start_radius" of GestureTask
	# expects warning: no gesture is recognised. Set its "tracker"
	# expects warning: nothing is felt. Set its "gesture_hmm"
	var rig := _make_rig(STABLE)
	var hmm := rig.gesture_hmm
	var own := hmm.models
	rig.tracker.start()
	hmm.models = []
	rig.tracker.advance(0.01)
	hmm.models = [GestureModel.new()]
	rig.tracker.advance(0.01)
	hmm.models = own
	rig.task.gesture = &"tap"
	rig.tracker.advance(0.01)
	rig.task.gesture = &"horizontal_drag"
	rig.task.direction = Vector3.ZERO
	rig.tracker.advance(0.01)
	# The only model: a task without a gesture is for it.
	hmm.models = [load(Rig.MODEL % "zoom"), GestureModel.new()]
	rig.task.gesture = &""
	rig.tracker.advance(0.01)
	rig.free_nodes()
	var nodes: Array[Node] = [GestureHMM.new(), HapticSynth.new()]
	for node in nodes:
		root.add_child(node)
	for frame in 2:
		await process_frame
	for node in nodes:
		node.free()


func test_reset_clears_gesture_and_value() -> void:
	var rig := _make_rig(0)
	rig.record(0, 2400)
	check_equal(String(rig.gesture_hmm.recognised), "horizontal_drag", "recognised")
	rig.gesture_hmm.reset()
	check_equal(String(rig.gesture_hmm.recognised), "", "recognised is cleared")
	check_equal(rig.gesture_hmm.value, 0.0, "the value is 0")
	rig.free_nodes()


func _make_rig(index: int) -> Rig:
	return Rig.new(_trials.get_trial(index), _trials.get_measured_path(index), root)
