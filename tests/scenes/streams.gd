extends "support/scene_test.gd"
## A script's stream of frames: its end, refused frames, and missing frames.

const PushedHand := preload("support/pushed_hand.gd")
const Rig := preload("support/rig.gd")

const FRAME_S := 1.0 / 90.0
const ONSET_S := 1.0
const DURATION_S := 0.8
const HALF_WAY_S := 1.45

var _events: Array[String] = []


func test_a_tracker_that_stops_leaves_no_gesture() -> void:
	for how: StringName in [&"stop", &"handler", &"no_source", &"start"]:
		var hmm := _hmm()
		var tracker := hmm.tracker
		if how == &"handler":
			hmm.gesture_started.connect(tracker.stop.unbind(2))
		_push_drag(tracker, HALF_WAY_S)
		match how:
			&"stop":
				tracker.stop()
			&"start":
				tracker.start()
			&"no_source":
				tracker.source = RecordedSource.new()
				# expects one error: set "track" of the RecordedSource to a recording (*.csv)
				check_equal(tracker.start(), ERR_CANT_OPEN, "it cannot be started")
		check_equal(_events, ["started", "aborted"] as Array[String], "%s: the signals" % how)
		check_equal(hmm.gesture, &"", "%s: no active gesture" % how)
		check_equal(hmm.state, -1, "%s: no state" % how)
		check_equal(hmm.value, 0.0, "%s: no motion" % how)
		_free(hmm)


func test_a_stop_after_the_end_does_not_abort_the_gesture() -> void:
	var hmm := _hmm()
	_push_drag(hmm.tracker, 2.5)
	hmm.tracker.stop()
	hmm.tracker.stop()
	check_equal(_events, ["started", "ended"] as Array[String], "the signals")
	check_equal(hmm.recognised, &"horizontal_drag", "it was recognised")
	_free(hmm)


func test_a_handler_of_tracking_lost_may_restart_the_tracker() -> void:
	var hmm := _hmm()
	var tracker := hmm.tracker
	_push_drag(tracker, HALF_WAY_S)
	var start := func() -> void: tracker.start()
	tracker.tracking_lost.connect(start, CONNECT_ONE_SHOT)
	tracker.stop()
	check(tracker.is_running(), "it runs")
	_push_drag(tracker, 2.5)
	var both: Array[String] = ["started", "aborted", "started", "ended"]
	check_equal(_events, both, "the first gesture is aborted, the next one ends")
	_free(hmm)


func test_frames_of_another_thread_need_call_deferred() -> void:
	for is_deferred: bool in [false, true]:
		var hmm := _hmm()
		var tracker := hmm.tracker
		var results: Array[Error] = []
		var push := func() -> void:
			for frame in 300:
				var time_s := frame * FRAME_S
				if is_deferred:
					tracker.push_frame.call_deferred(time_s, _hand(time_s))
				else:
					results.append(tracker.push_frame(time_s, _hand(time_s)))
		var thread := Thread.new()
		thread.start(push)
		# expects one error: HandTracker: push_frame: call it from the main thread
		thread.wait_to_finish()
		await process_frame
		await process_frame
		var count := 0 if is_deferred else 300
		check_equal(results.count(ERR_INVALID_PARAMETER), count, "refused")
		var expected := "started ended" if is_deferred else ""
		check_equal(" ".join(_events), expected, "the signals, deferred: %s" % is_deferred)
		check_equal(
			tracker.get_time() > 0.0, is_deferred, "the clock advances only with accepted frames"
		)
		_free(hmm)


func test_a_new_clock_needs_a_start() -> void:
	var hmm := _hmm()
	var tracker := hmm.tracker
	var losses: Array[float] = []
	tracker.tracking_lost.connect(func() -> void: losses.append(tracker.get_time()))
	tracker.push_frame(1000.0, _hand(0.0))
	# expects one error: s is before 1000.0 s, the time of the last frame
	for time_s: float in [0.0, 0.5]:
		check_equal(tracker.push_frame(time_s, _hand(0.0)), ERR_INVALID_PARAMETER, "refused")
		tracker.push_frame(1000.1, _hand(0.0))
	check_equal(losses.size(), 0, "single late frames do not lose the hand")
	for frame in 30:
		tracker.push_frame(frame * FRAME_S, _hand(0.0))
	check_equal(losses, [1000.1] as Array[float], "only late frames lose it")
	tracker.start()
	_push_drag(tracker, 2.5)
	check_equal(_events, ["started", "ended"] as Array[String], "a start accepts the new clock")
	_free(hmm)


func test_a_hand_that_never_comes_is_warned_of_once() -> void:
	# expects one warning: no frame for 5 s from HandTracker '
	# expects one warning: no hand for 20 s: all frames of HandTracker '
	Engine.time_scale = 100.0
	for what: StringName in [&"nothing", &"empty", &"hand", &"not_running", &"synthetic"]:
		var hmm := _hmm()
		match what:
			&"not_running":
				hmm.tracker.stop()
			&"synthetic":
				hmm.tracker.update_mode = HandTracker.UPDATE_MANUAL
				hmm.tracker.source = SyntheticSource.new()
				hmm.tracker.start()
		var wait_s := 22.0 if what == &"empty" or what == &"hand" else 6.0
		var passed_s := 0.0
		while passed_s < wait_s:
			await process_frame
			passed_s += minf(root.get_process_delta_time(), 0.1)
			if what == &"empty":
				hmm.tracker.push_frame(passed_s, {})
			elif what == &"hand" and passed_s < 1.0:
				hmm.tracker.push_frame(passed_s, _hand(0.0))
		check(true, "%s: the wait is over" % what)
		_free(hmm)
	Engine.time_scale = 1.0


func test_a_removed_tracker_gives_no_warning() -> void:
	# expects one warning: no gesture is recognised. Set its "tracker"
	var without := GestureHMM.new()
	root.add_child(without)
	for what: StringName in [&"set_to_none", &"freed"]:
		var hmm := _hmm()
		await process_frame
		await process_frame
		var tracker := hmm.tracker
		if what == &"set_to_none":
			hmm.tracker = null
		tracker.free()
		await process_frame
		await process_frame
		check(hmm.tracker == null, "%s: it has no tracker" % what)
		hmm.task.free()
		hmm.free()
	without.free()


## Pushes a drag of 20 cm from the origin, with times from 0 to `until_s`.
func _push_drag(tracker: HandTracker, until_s: float) -> void:
	var frame := 0
	while frame * FRAME_S < until_s and tracker.is_running():
		tracker.push_frame(frame * FRAME_S, _hand(frame * FRAME_S))
		frame += 1


func _hand(time_s: float) -> Dictionary:
	var way := 0.2 * PushedHand.share((time_s - ONSET_S) / DURATION_S)
	return {HandTracker.JOINT_INDEX: Vector3(way, 0.0, 0.0) + PushedHand.tremor(time_s)}


## A GestureHMM for a drag at the origin, with a running tracker; its signals are in _events.
func _hmm() -> GestureHMM:
	var tracker := HandTracker.new()
	tracker.source = ScriptSource.new()
	var task := GestureTask.new()
	var hmm := GestureHMM.new()
	task.gesture = &"horizontal_drag"
	hmm.models = [load(Rig.MODEL % "horizontal_drag") as GestureModel]
	hmm.task = task
	hmm.tracker = tracker
	for node: Node in [tracker, task, hmm]:
		root.add_child(node)
	PushedHand.listen(hmm, _events)
	return hmm


func _free(hmm: GestureHMM) -> void:
	hmm.tracker.free()
	hmm.task.free()
	hmm.free()
