extends "support/scene_test.gd"
## The add-on's help for tests of a game: GestureTestHand and the templates.

# engine options: --fixed-fps 90

const TEMPLATES := "res://addons/steadyhand/testing/templates/"
const FRAMEWORKS := "support/test_frameworks.gd"
const WAY := 0.2

var _tracker: HandTracker = null
var _hmm: GestureHMM = null


func test_the_template_without_a_framework_passes_faster_than_real_time() -> void:
	var output: Array[String] = []
	var began_ms := Time.get_ticks_msec()
	var status := _run_script(TEMPLATES.path_join("script_test.gd"), output)
	check_equal(status, 0, "it passes")
	check(output[0].contains("pass  a key is pressed"), "the template presses a key")
	print("it took %d ms" % (Time.get_ticks_msec() - began_ms))


func test_the_template_without_a_framework_fails_where_no_key_is_pressed() -> void:
	var folder := DirAccess.create_temp("steadyhand_template")
	var path := folder.get_current_dir().path_join("script_test.gd")
	var source := FileAccess.get_file_as_string(TEMPLATES.path_join("script_test.gd"))
	var file := FileAccess.open(path, FileAccess.WRITE)
	file.store_string(source.replace("hand.make_gesture(hmm.tasks[4])", "hand.reach(hmm.tasks[4])"))
	file.close()
	check_equal(_run_script(path, []), 3, "all checks fail")


func test_the_templates_for_frameworks_pass() -> void:
	for template: String in ["gut_test.txt", "gdunit4_test.txt"]:
		var base := (get_script() as Script).resource_path.get_base_dir().path_join(FRAMEWORKS)
		var source := FileAccess.get_file_as_string(TEMPLATES.path_join(template))
		var script := GDScript.new()
		script.source_code = source.replace(source.get_slice("\n", 0), 'extends "%s"' % base)
		check_equal(script.reload(), OK, "%s parses" % template)
		for method in script.get_script_method_list():
			if (method["name"] as String).begins_with("test_"):
				var test := script.new() as Node
				root.add_child(test)
				test.call("before_each" if test.has_method("before_each") else "before_test")
				await test.call(method["name"])
				check_equal(test.get("failures"), [] as Array[String], method["name"])
				test.free()


func test_a_gesture_is_made_at_its_task_in_the_time_given() -> void:
	var hand := _make_nodes()
	var times_s: Array[float] = []
	_hmm.gesture_started.connect(
		func(_gesture: StringName, _task: GestureTask) -> void: times_s.append(_hmm.time)
	)
	_hmm.gesture_ended.connect(
		func(_gesture: StringName, time_s: float, _task: GestureTask, _f: float) -> void:
			times_s.append(time_s)
	)
	await hand.make_gesture(_hmm.task, 1.2)
	check_equal(times_s.size(), 2, "one gesture")
	check_near(times_s[1] - times_s[0], 1.2, 0.35, "the gesture has the given duration")
	check_near(hand.get_place().x, _hmm.task.get_start().x + WAY, 1e-6, "the hand is at the end")
	_free_nodes()


func test_a_fraction_of_a_gesture_does_not_end() -> void:
	var hand := _make_nodes()
	var is_ended := [false]
	_hmm.gesture_ended.connect(
		func(_g: StringName, _time_s: float, _t: GestureTask, _f: float) -> void: is_ended[0] = true
	)
	await hand.make_gesture(_hmm.task, 0.8, 0.5)
	check(not is_ended[0], "half of it")
	check_near(_hmm.value, 0.5 * WAY, 0.005, "is followed")
	_free_nodes()


func test_a_second_gesture_replaces_the_first() -> void:
	var hand := _make_nodes()
	var other := GestureTask.new()
	other.position = Vector3(0.3, 1.3, -0.4)
	other.amplitude = WAY
	_hmm.add_child(other)
	hand.make_gesture(_hmm.task)
	await hand.rest(1.0)
	hand.make_gesture(other)
	await hand.rest(2.5)
	check(hand.is_busy, "busy after the time of the first gesture")
	check_near(hand.get_place().y, 1.3, 1e-6, "the hand is at the second task")
	await hand.rest(1.5)
	check(not hand.is_busy, "not busy after the second gesture")
	check_near(hand.get_place().x, other.get_start().x + WAY, 1e-6, "the hand is at its end")
	_free_nodes()


func test_faults_are_seen_by_the_tracker() -> void:
	var hand := _make_nodes()
	await hand.reach(_hmm.task)
	hand.move_to(_hmm.task.get_start() + Vector3.RIGHT, 6.0)
	await hand.rest(1.5)
	hand.drop_out(0.2)
	await hand.rest(1.0)
	check_equal(_tracker.dropout_count, 1, "one dropout")
	hand.freeze(0.2)
	await hand.rest(1.0)
	check_equal(_tracker.freeze_count, 1, "one freeze")
	hand.jump(0.3 * Vector3.UP, 0.2)
	await hand.rest(1.0)
	check_equal(_tracker.jump_count, 1, "one jump")
	_free_nodes()


func test_random_faults_spoil_the_hand() -> void:
	var faults := DegradedSource.new()
	faults.dropouts_per_minute = 60.0
	faults.dropout_duration = 0.2
	var hand := _make_nodes(faults)
	await hand.rest(10.0)
	check(_tracker.dropout_count > 3, "%d dropouts in 10 s" % _tracker.dropout_count)
	_free_nodes()


func test_wait_for_ends_at_its_timeout() -> void:
	var hand := _make_nodes()
	await hand.rest(0.1)
	var began_s := _tracker.get_time()
	check(not await hand.wait_for(_hmm.gesture_ended, 2.0), "no end")
	check_near(_tracker.get_time() - began_s, 2.0, 0.03, "of simulated time")
	_free_nodes()


func test_the_hand_follows_the_time_scale_of_the_game() -> void:
	for mode: HandTracker.UpdateMode in [HandTracker.UPDATE_IDLE, HandTracker.UPDATE_PHYSICS]:
		for scale: float in [0.5, 4.0]:
			Engine.time_scale = scale
			var hand := _make_nodes()
			_tracker.update_mode = mode
			await hand.rest(0.1)
			var timer := create_timer(2.0)
			await hand.rest(1.9)
			check_near(timer.time_left, 0.1, 0.08, "mode %d, scale %s: a timer" % [mode, scale])
			hand.make_gesture(_hmm.task)
			check(await hand.wait_for(_hmm.gesture_ended, 5.0), "a gesture ends")
			_free_nodes()
	Engine.time_scale = 1.0


func test_a_hand_without_a_tracker_is_an_error() -> void:
	# expects one error: GestureTestHand: no HandTracker follows it
	await GestureTestHand.new().rest(1.0)
	check(true, "it returns")


func test_a_hand_without_a_place_is_an_error() -> void:
	# expects one error: GestureTestHand: attach() needs a HandTracker, is null
	# expects one error: : add the HandTracker to the scene tree before GestureTestHand.attach()
	check(GestureTestHand.attach(null) != null, "without a tracker")
	var tracker := HandTracker.new()
	GestureTestHand.attach(tracker)
	check(not tracker.is_running(), "outside the tree")
	tracker.free()


func test_a_gesture_that_no_hand_makes_is_an_error() -> void:
	# expects one error: GestureTestHand: make_gesture() needs a GestureTask, is null
	# expects one error: GestureTestHand: reach() needs a GestureTask, is null
	# expects one error: and fraction 0..1, are -1.0 and 1.0
	# expects one error: and fraction 0..1, are 0.0 and 7.0
	# expects one error: and fraction 0..1, are 0.0 and -1.0
	var hand := _make_nodes()
	await hand.make_gesture(null)
	await hand.reach(null)
	await hand.make_gesture(_hmm.task, -1.0)
	await hand.make_gesture(_hmm.task, 0.0, 7.0)
	await hand.make_gesture(_hmm.task, 0.0, -1.0)
	check_equal(hand.get_place(), Vector3.ZERO, "the hand stays")
	_free_nodes()


func test_a_hand_with_equal_time_stamps_is_an_error() -> void:
	# expects one error: its time does not advance, because HandTracker 'Paused' is paused
	# expects one error: because HandTracker 'Manual' is in UPDATE_MANUAL. Set another update_mode
	var hand := _make_nodes()
	_tracker.name = &"Paused"
	paused = true
	check(not await hand.wait_for(_hmm.gesture_ended, 1.0), "no end in a paused game")
	paused = false
	_tracker.name = &"Manual"
	_tracker.update_mode = HandTracker.UPDATE_MANUAL
	check(not await hand.wait_for(_hmm.gesture_ended, 1.0), "by a script")
	_free_nodes()


func _make_nodes(faults: DegradedSource = null) -> GestureTestHand:
	_tracker = HandTracker.new()
	_hmm = GestureHMM.new()
	_hmm.models = [load("res://addons/steadyhand/models/horizontal_drag.gesture") as GestureModel]
	_hmm.tracker = _tracker
	var task := GestureTask.new()
	task.position = Vector3(0.3, 1.0, -0.4)
	task.amplitude = WAY
	_hmm.add_child(task)
	_hmm.task = task
	root.add_child(_tracker)
	root.add_child(_hmm)
	return GestureTestHand.attach(_tracker, faults)


func _free_nodes() -> void:
	_hmm.free()
	_tracker.free()


func _run_script(path: String, output: Array[String]) -> int:
	var arguments := ["--headless", "--fixed-fps", "90", "--path"]
	arguments.append_array([ProjectSettings.globalize_path("res://"), "--script", path])
	var printed: Array = []
	var godot := OS.get_environment("GODOT")
	var status := OS.execute(
		godot if godot != "" else OS.get_executable_path(), arguments, printed, true
	)
	output.append(printed[0] as String)
	return status
