extends "support/scene_test.gd"
## What a GestureHMM tells while a drag is under way.

const Rig := preload("support/rig.gd")

var _folder := DirAccess.create_temp("steadyhand_hmm")
var _trials := Rig.write_trials(_folder.get_current_dir())


func test_signals_of_a_drag() -> void:
	for index in _trials.get_count():
		var events: Array[String] = []
		var states: Array[int] = []
		var rig := _make_rig(index)
		rig.gesture_hmm.gesture_started.connect(
			func(gesture: StringName) -> void: events.append("started %s" % gesture)
		)
		rig.gesture_hmm.gesture_ended.connect(
			func(gesture: StringName, _time_s: float) -> void: events.append("ended %s" % gesture)
		)
		rig.gesture_hmm.state_changed.connect(func(state: int) -> void: states.append(state))
		check_equal(rig.gesture_hmm.state, -1, "no state before the gesture")
		rig.record(0, 2400)
		check_equal(
			events.slice(0, 2),
			["started horizontal_drag", "ended horizontal_drag"] as Array[String],
			"trial %d starts and ends" % index
		)
		var under_way := states.filter(func(state: int) -> bool: return state >= 0)
		var in_order := under_way.duplicate()
		in_order.sort()
		check(
			under_way.size() >= 2 and under_way == in_order,
			"states come from left to right: %s" % [states]
		)
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
	check(is_same, "value is that of the condition chosen, from the same instant on")
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
			"condition %d is what it would have been" % i
		)
	switched.free_nodes()


func test_only_the_tasks_model_is_active() -> void:
	var rig := _make_rig(0)
	rig.task.gesture = &"vertical_drag"
	rig.record(0, 2400)
	check_equal(String(rig.gesture_hmm.recognised), "", "another gesture's task: nothing seen")
	rig.free_nodes()


func test_reset_forgets() -> void:
	var rig := _make_rig(0)
	rig.record(0, 2400)
	check_equal(String(rig.gesture_hmm.recognised), "horizontal_drag", "recognised")
	rig.gesture_hmm.reset()
	check_equal(String(rig.gesture_hmm.recognised), "", "forgotten")
	check_equal(rig.gesture_hmm.value, 0.0, "at the start again")
	rig.free_nodes()


func test_warnings_name_the_fix() -> void:
	var hmm := GestureHMM.new()
	root.add_child(hmm)
	var warnings := "\n".join(hmm._get_configuration_warnings())
	check(warnings.contains("HandTracker"), "a GestureHMM without tracker: %s" % warnings)
	check(warnings.contains("GestureModel"), "and without model")
	var synth := HapticSynth.new()
	root.add_child(synth)
	warnings = "\n".join(synth._get_configuration_warnings())
	check(warnings.contains("GestureHMM"), "a HapticSynth without GestureHMM: %s" % warnings)
	var task := GestureTask.new()
	root.add_child(task)
	warnings = "\n".join(task._get_configuration_warnings())
	check(warnings.contains("gesture"), "a GestureTask without gesture: %s" % warnings)
	var tracker := HandTracker.new()
	tracker.source = HandTracker.SOURCE_RECORDED
	tracker.autostart = false
	root.add_child(tracker)
	warnings = "\n".join(tracker._get_configuration_warnings())
	check(warnings.contains("recording"), "a recorded HandTracker without file: %s" % warnings)
	var rig := _make_rig(0)
	for node: Node in [rig.tracker, rig.task, rig.gesture_hmm]:
		check_equal(
			Array(node._get_configuration_warnings()), [], "%s as it should be" % node.get_class()
		)
	rig.free_nodes()
	for node: Node in [hmm, synth, task, tracker]:
		node.free()


func _make_rig(index: int) -> Rig:
	return Rig.new(_trials.get_trial(index), _trials.get_measured_path(index), root)
