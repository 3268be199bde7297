extends "support/scene_test.gd"
## Tasks that are moved and changed, one or all, as the keys of a panel that follows the player.

const PushedHand := preload("support/pushed_hand.gd")
const Rig := preload("support/rig.gd")

const FRAME_S := 1.0 / 90.0
const KEY_M := 0.04
const ROW := 10

var _events: Array[String] = []


func test_a_moving_panel_moves_all_its_tasks() -> void:
	var panel := Node3D.new()
	var hmm := _hmm(panel, 30)
	_push_tap(hmm, hmm.tasks[12], 0.0, 1.4)
	check_equal(hmm.current_task, hmm.tasks[12], "a tap is active")
	panel.position = Vector3(1.0, 0.5, 0.0)
	await process_frame
	await process_frame
	check_equal(_events, ["started", "aborted"] as Array[String], "the move aborts it")
	_push_tap(hmm, hmm.tasks[17], 2.0, 2.6)
	check_equal(
		_events,
		["started", "aborted", "started", "ended"] as Array[String],
		"a tap at the new place ends"
	)
	check_equal(hmm.current_task, hmm.tasks[17], "at its task")
	_free(hmm, panel)


func test_a_trembling_panel_keeps_the_gesture() -> void:
	var panel := Node3D.new()
	var hmm := _hmm(panel, 30)
	_push_tap(hmm, hmm.tasks[12], 0.0, 1.4)
	panel.position.x = 0.5e-3
	await process_frame
	await process_frame
	_push_tap(hmm, hmm.tasks[12], 1.4, 1.2, 1.4)
	check_equal(_events, ["started", "ended"] as Array[String], "the tap ends")
	_free(hmm, panel)


func test_a_task_of_a_removed_panel_stays_at_its_place() -> void:
	for is_top_level: bool in [false, true]:
		var room := Node3D.new()
		room.transform = Transform3D(Basis(Vector3.UP, 1.0), Vector3(5.0, 0.0, 0.0))
		var panel := Node3D.new()
		panel.transform = Transform3D(Basis(Vector3.BACK, 0.5 * PI), Vector3(1.0, 2.0, 3.0))
		var task := GestureTask.new()
		task.position = Vector3(0.1, 0.2, 0.3)
		task.top_level = is_top_level
		panel.add_child(task)
		room.add_child(panel)
		root.add_child(room)
		var start := task.get_start()
		var axis := task.get_axis()
		room.remove_child(panel)
		check(task.get_start().is_equal_approx(start), "outside the tree: %s" % start)
		check(task.get_axis().is_equal_approx(axis), "its direction: %s" % axis)
		task.position.x += 1.0
		check(not task.get_start().is_equal_approx(start), "its own move counts")
		root.add_child(panel)
		check(task.get_start().is_equal_approx(task.global_position), "in the tree again")
		panel.free()
		room.free()


func test_task_properties_take_effect_at_once() -> void:
	for what: StringName in [
		&"amplitude", &"direction", &"gesture", &"no_gesture", &"start_radius"
	]:
		var panel := Node3D.new()
		var hmm := _hmm(panel, 3)
		hmm.models = hmm.models + [load(Rig.MODEL % "horizontal_drag") as GestureModel]
		var task := hmm.tasks[1]
		_push_tap(hmm, task, 0.0, 1.4)
		match what:
			&"amplitude":
				task.amplitude = 0.15
			&"direction":
				task.direction = Vector3.DOWN
			&"gesture":
				task.gesture = &"horizontal_drag"
			&"no_gesture":
				task.gesture = &""
			&"start_radius":
				task.start_radius = 0.1  # has no effect on a tap
		var expected := "started" if what == &"start_radius" else "started aborted"
		check_equal(" ".join(_events), expected, "%s: the signals" % what)
		_free(hmm, panel)


## A tap at `task` and the rest before it, for `duration_s`, after the first `done_s`.
func _push_tap(
	hmm: GestureHMM, task: GestureTask, from_s: float, duration_s: float, done_s: float = 0.0
) -> void:
	for frame in int(duration_s / FRAME_S):
		var time_s := frame * FRAME_S
		var way := task.amplitude * PushedHand.share((time_s + done_s - 1.0) / 0.7)
		var tip := task.get_start() + way * task.get_axis() + PushedHand.tremor(time_s)
		hmm.tracker.push_frame(from_s + time_s, {HandTracker.JOINT_INDEX: tip})


## A GestureHMM for taps at `count` keys of `panel`; its signals are in _events.
func _hmm(panel: Node3D, count: int) -> GestureHMM:
	var tracker := HandTracker.new()
	tracker.source = ScriptSource.new()
	var hmm := GestureHMM.new()
	hmm.models = [load(Rig.MODEL % "tap") as GestureModel]
	hmm.tracker = tracker
	for node: Node in [panel, tracker, hmm]:
		root.add_child(node)
	var tasks: Array[GestureTask] = []
	for key in count:
		var task := GestureTask.new()
		task.gesture = &"tap"
		task.direction = Vector3.FORWARD
		task.amplitude = 0.1
		task.position = Vector3(KEY_M * (key % ROW), KEY_M * (key / ROW), -0.4)
		panel.add_child(task)
		tasks.append(task)
	hmm.tasks = tasks
	PushedHand.listen(hmm, _events)
	return hmm


func _free(hmm: GestureHMM, panel: Node3D) -> void:
	hmm.tracker.free()
	hmm.free()
	panel.free()
