extends "support/scene_test.gd"
## Frames that a script pushes: joints, mistakes, statistics, and gestures at tasks.

const PushedHand := preload("support/pushed_hand.gd")
const Rig := preload("support/rig.gd")

const FRAME_S := 0.01
const INDEX := HandTracker.JOINT_INDEX
const PLACE := Vector3(0.1, 1.2, -0.3)


func test_frames_pushed_right_after_the_source_is_set() -> void:
	var tracker := HandTracker.new()
	root.add_child(tracker)
	tracker.source = ScriptSource.new()
	check_equal(tracker.push_frame(1.0, {INDEX: PLACE}), OK, "the first frame is taken")
	check(tracker.is_joint_tracked(INDEX), "the frame is delivered")
	await process_frame
	check(tracker.is_joint_tracked(INDEX), "the next frame does not restart it")
	tracker.free()


func test_joints_are_numbered_as_in_xr_hand_tracker() -> void:
	var tracker := _tracker()
	var joints := {}
	for joint in XRHandTracker.HAND_JOINT_MAX:
		joints[joint] = Vector3(0.0, 1.0, 0.01 * joint)
	tracker.push_frame(0.0, joints)
	check_equal(tracker.get_joint_position(INDEX).z, Vector3(0, 0, 0.1).z, "the index tip")
	var distal := XRHandTracker.HAND_JOINT_INDEX_FINGER_PHALANX_DISTAL
	check(tracker.is_joint_tracked(distal as HandTracker.Joint), "all 26 joints are kept")
	tracker.free()


func test_wrong_joints_are_named_with_key_and_type() -> void:
	# expects one error: the key 'index' is of type String
	# expects one error: that of joint 10 is of type Vector2
	for joints: Dictionary in [{"index": PLACE}, {INDEX: Vector2.ONE}]:
		var tracker := _tracker()
		check_equal(tracker.push_frame(0.0, joints), ERR_INVALID_PARAMETER, "%s" % joints)
		tracker.free()


func test_frames_are_typed() -> void:
	var tracker := _tracker()
	var frames: Array[HandFrame] = []
	tracker.frame_received.connect(func(frame: HandFrame) -> void: frames.append(frame))
	tracker.start()
	tracker.push_frame(1.0, {INDEX: PLACE, HandTracker.JOINT_PALM: 2.0 * PLACE}, 0.7)
	tracker.push_frame(1.01, {})
	check_equal(frames.size(), 2, "one for each")
	check_equal(frames[0].time, 1.0, "time")
	check_equal(frames[0].confidence, 0.7, "confidence")
	check_equal(frames[0].get_joints().keys(), [HandTracker.JOINT_PALM, INDEX], "joints")
	check_equal(frames[0].get_joint_position(INDEX), PLACE, "position")
	check(is_nan(frames[0].device_time), "without a device there is no device time")
	check(not frames[1].is_tracked(), "an empty frame")
	tracker.free()


func test_impossible_frames_are_dropped() -> void:
	# expects one warning: the source sends positions that are not finite
	# expects one warning: the source sends all joints at exactly (0, 0, 0)
	var tracker := _tracker()
	var bad: Array[Vector3] = [Vector3(NAN, 0, 0), Vector3(0, INF, 0), Vector3.ZERO]
	for frame in 60:
		var place := PLACE if frame < 30 else bad[frame % 3]
		tracker.push_frame(frame * FRAME_S, {INDEX: place, HandTracker.JOINT_PALM: place})
		if frame >= 30:
			check(not tracker.is_joint_tracked(INDEX), "%s is not a valid position" % place)
	check(not tracker.is_hand_tracked(), "the hand is lost")
	tracker.free()


func test_statistics() -> void:
	var tracker := _tracker()
	for frame in 300:
		var is_lost := frame >= 100 and frame < 120
		tracker.push_frame(frame / 90.0, {} if is_lost else {INDEX: PLACE})
	check_near(tracker.frame_rate, 90.0, 0.1, "rate")
	check_near(tracker.frame_jitter, 0.0, 1e-9, "jitter")
	check_equal(tracker.dropout_count, 1, "dropouts")
	check(is_nan(tracker.latency), "the latency is not known")
	check(is_nan(tracker.noise), "the noise of a hand that never moves is not known")
	var noise := RandomNumberGenerator.new()
	noise.seed = 3
	tracker.start()
	var place := PLACE
	for frame in 600:
		var is_frozen := frame >= 300 and frame < 330
		if not is_frozen:
			place = PLACE + Vector3(0.1 * sin(0.02 * frame), 0, 0)
			place += 2e-4 * Vector3(noise.randfn(), noise.randfn(), noise.randfn())
		var jump := Vector3(0, 0.3, 0) if frame >= 450 and frame < 455 else Vector3.ZERO
		tracker.push_frame(frame / 90.0, {INDEX: place + jump})
	check_near(tracker.reading_rate, 90.0, 0.1, "reading rate")
	check_near(tracker.noise, 2e-4, 1e-4, "noise")
	check_equal(tracker.dropout_count, 0, "dropouts")
	check_equal(tracker.freeze_count, 1, "freezes")
	check_equal(tracker.jump_count, 1, "jumps")
	tracker.free()


func test_a_task_without_a_hand_is_warned_of_once() -> void:
	# expects one warning: the fingertip has come no nearer to its start than 0.5
	# expects one warning: the hand leaves its start towards (0.0, 1.0, 0.0)
	# expects one warning: m. Give the source's positions in metres, or move the GestureTask
	for distance_m: float in [0.5, 50.0, 0.0]:
		var is_far := distance_m > 0.0
		var tracker := _tracker()
		var task := GestureTask.new()
		task.gesture = &"horizontal_drag"
		task.position = PLACE + distance_m * Vector3.LEFT
		var hmm := _hmm(tracker, task)
		for frame in 2400:
			var way := 0.2 * PushedHand.share(absf(fposmod(frame / 150.0, 2.0) - 1.0))
			var tip := PLACE + Vector3(way if is_far else 0.0, 0.0 if is_far else way, 0.0)
			tracker.push_frame(frame * FRAME_S, {INDEX: tip})
		for node: Node in [hmm, task, tracker]:
			node.free()


func test_signals_carry_the_task() -> void:
	var tracker := _tracker()
	var task := GestureTask.new()
	task.position = PLACE
	var hmm := _hmm(tracker, task)
	var tasks: Array[GestureTask] = []
	hmm.gesture_started.connect(
		func(_gesture: StringName, at: GestureTask) -> void: tasks.append(at)
	)
	hmm.gesture_aborted.connect(
		func(_gesture: StringName, at: GestureTask) -> void: tasks.append(at)
	)
	for frame in 160:
		var way := 0.2 * PushedHand.share((frame - 100) / 80.0)
		tracker.push_frame(frame * FRAME_S, {INDEX: PLACE + Vector3(way, 0, 0)})
	tracker.stop()
	check_equal(tasks, [task, task] as Array[GestureTask], "started and aborted at the task")
	for node: Node in [hmm, task, tracker]:
		node.free()


func _tracker() -> HandTracker:
	var tracker := HandTracker.new()
	tracker.source = ScriptSource.new()
	tracker.autostart = false
	tracker.update_mode = HandTracker.UPDATE_MANUAL
	root.add_child(tracker)
	tracker.start()
	return tracker


func _hmm(tracker: HandTracker, task: GestureTask) -> GestureHMM:
	var hmm := GestureHMM.new()
	hmm.models = [load(Rig.MODEL % "horizontal_drag") as GestureModel]
	hmm.tracker = tracker
	hmm.task = task
	for node: Node in [task, hmm]:
		root.add_child(node)
	return hmm
