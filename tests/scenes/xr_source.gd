extends "support/scene_test.gd"
## XRSource on an XRHandTracker that the test moves.

const PushedHand := preload("support/pushed_hand.gd")
const Rig := preload("support/rig.gd")
const XRHand := preload("support/xr_hand.gd")

const STEP_S := 1.0 / 90.0
const INDEX := HandTracker.JOINT_INDEX
const PALM := HandTracker.JOINT_PALM
const PLACE := Vector3(0.1, 0.2, -0.3)

var _time_s := 0.0


func test_a_scene_without_a_script_vibrates() -> void:
	var folder := (get_script() as Script).resource_path.get_base_dir()
	var packed := load(folder.path_join("support/no_script.tscn")) as PackedScene
	var scene := packed.instantiate()
	root.add_child(scene)
	var hmm := scene.get_node("GestureHMM") as GestureHMM
	var synth := scene.get_node("HapticSynth") as HapticSynth
	var events: Array[String] = []
	PushedHand.listen(hmm, events)
	var hand := XRHand.new()
	hand.register()
	var start := (scene.get_node("GestureTask") as GestureTask).get_start()
	var most := 0.0
	Engine.max_fps = 90
	var began_us := Time.get_ticks_usec()
	var now_s := 0.0
	while now_s < 3.2:
		now_s = 1e-6 * (Time.get_ticks_usec() - began_us)
		var way := 0.2 * PushedHand.share((now_s - 1.0) / 0.8)
		hand.place(start + Vector3(way, 0.0, 0.0) + PushedHand.tremor(now_s))
		await process_frame
		most = maxf(most, synth.get_amplitude())
	Engine.max_fps = 0
	check_equal(events, ["started", "ended"] as Array[String], "one drag")
	check(most > 0.1, "it vibrates: %s" % most)
	scene.free()
	hand.remove()


func test_world_and_origin_space() -> void:
	var hand := _add_hand()
	XRServer.world_origin = Transform3D(Basis(), Vector3(0.0, 1.0, 0.0))
	var tracker := _add_tracker(XRSource.SPACE_WORLD)
	tracker.advance(STEP_S)
	check(_index(tracker).is_equal_approx(Vector3(0.1, 1.2, -0.3)), "in the world")
	check(not tracker.is_joint_tracked(HandTracker.JOINT_THUMB), "the thumb is not tracked")
	(tracker.source as XRSource).space = XRSource.SPACE_ORIGIN
	XRServer.world_origin.origin += Vector3(3.0, 0.0, -4.0)
	tracker.advance(STEP_S)
	check(_index(tracker).is_equal_approx(PLACE), "it moves with the player")
	_remove(hand, tracker)


func test_world_scale_scales_the_world_space_only() -> void:
	var hand := _add_hand()
	XRServer.world_scale = 2.0
	for space: XRSource.Space in [XRSource.SPACE_WORLD, XRSource.SPACE_ORIGIN]:
		var tracker := _add_tracker(space)
		tracker.advance(STEP_S)
		var expected := 2.0 * PLACE if space == XRSource.SPACE_WORLD else PLACE
		check(_index(tracker).is_equal_approx(expected), "space %d" % space)
		tracker.free()
	XRServer.world_scale = 1.0
	hand.remove()


func test_nodes_follow_a_published_hand_to_the_real_hand() -> void:
	var hand := _add_hand()
	var head := _add_head()
	_turn(head, 1.0)
	var origin := XROrigin3D.new()
	origin.transform = Transform3D(Basis(Vector3.UP, 0.5), Vector3(5.0, 1.0, 0.0))
	origin.world_scale = 2.0
	var follower := XRNode3D.new()
	follower.tracker = &"/steadyhand/right"
	origin.add_child(follower)
	root.add_child(origin)
	var sources: Array[HandSource] = []
	for space: XRSource.Space in [XRSource.SPACE_WORLD, XRSource.SPACE_ORIGIN, XRSource.SPACE_BODY]:
		var source := XRSource.new()
		source.space = space
		sources.append(source)
	var degraded := DegradedSource.new()
	degraded.source = sources[XRSource.SPACE_ORIGIN]
	sources.append(degraded)
	var palm := origin.transform * (2.0 * (PLACE + XRHand.PALM_OFFSET))
	for source in sources:
		var tracker := _add_tracker()
		tracker.source = source
		tracker.publish_name = follower.tracker
		tracker.start()
		tracker.advance(STEP_S)
		check(follower.global_position.is_equal_approx(palm), "%s: %s" % [source, palm])
		tracker.free()
	origin.free()
	XRServer.world_origin = Transform3D()
	XRServer.world_scale = 1.0
	XRServer.remove_tracker(head)
	hand.remove()


func test_the_tracker_may_come_after_the_node_and_be_replaced() -> void:
	var tracker := _add_tracker()
	var ready: Array[int] = [0]
	tracker.source_ready.connect(func() -> void: ready[0] += 1)
	tracker.advance(STEP_S)
	check(not tracker.is_joint_tracked(INDEX), "no tracker yet")
	var hand := _add_hand()
	tracker.advance(STEP_S)
	check(tracker.is_joint_tracked(INDEX), "registered after the node")
	var other := _add_hand()
	other.place(2.0 * PLACE)
	tracker.advance(STEP_S)
	check(_index(tracker).is_equal_approx(2.0 * PLACE), "replaced by another of the same name")
	other.remove()
	_steps(tracker, 30)
	check(not tracker.is_hand_tracked(), "removed")
	check_equal(ready[0], 1, "source_ready comes with the hand")
	tracker.free()
	check(hand.tracker != null, "the first tracker was replaced")


func test_a_missing_tracker_is_an_error_reported_once() -> void:
	# expects one error: the XRServer has no hand tracker '/user/hand_tracker/left'
	var tracker := _add_tracker()
	var reasons: Array[String] = []
	tracker.failed.connect(func(reason: String) -> void: reasons.append(reason))
	(tracker.source as XRSource).hand = HandTracker.HAND_LEFT
	_steps(tracker, 90 * 12)
	check_equal(reasons.size(), 1, "failed")
	tracker.free()


func test_a_tracker_of_another_class_is_reported_once() -> void:
	# expects one error: is an XRControllerTracker, not an XRHandTracker
	var controller := XRControllerTracker.new()
	controller.name = XRHand.RIGHT
	XRServer.add_tracker(controller)
	var tracker := _add_tracker()
	_steps(tracker, 4)
	check(not tracker.is_joint_tracked(INDEX), "it has no joints")
	XRServer.remove_tracker(controller)
	tracker.free()


func test_inferred_joints_are_marked() -> void:
	var hand := _add_hand()
	hand.place(PLACE, XRHand.INFERRED)
	var tracker := _add_tracker()
	var frames: Array[HandFrame] = []
	tracker.frame_received.connect(func(frame: HandFrame) -> void: frames.append(frame))
	tracker.advance(STEP_S)
	check(tracker.is_joint_tracked(INDEX), "an inferred joint is tracked")
	check(tracker.is_joint_inferred(INDEX), "and marked")
	check(frames[-1].is_joint_inferred(INDEX), "it is inferred in the frame, too")
	hand.place(PLACE)
	tracker.advance(STEP_S)
	check(not tracker.is_joint_inferred(INDEX), "a tracked joint is not inferred")
	(tracker.source as XRSource).use_inferred = false
	hand.place(PLACE, XRHand.INFERRED)
	tracker.advance(STEP_S)
	check(not tracker.is_joint_tracked(INDEX), "left out if the user turns it off")
	_remove(hand, tracker)


func test_a_short_dropout_is_no_loss() -> void:
	var hand := _add_hand()
	var tracker := _add_tracker()
	var losses: Array[int] = [0]
	tracker.tracking_lost.connect(func() -> void: losses[0] += 1)
	_move(tracker, hand, PLACE, PLACE, 0.5)
	hand.tracker.has_tracking_data = false
	_steps(tracker, int(0.08 / STEP_S))
	check_equal(losses[0], 0, "0.08 s")
	hand.tracker.has_tracking_data = true
	_move(tracker, hand, PLACE, PLACE, 0.5)
	hand.tracker.has_tracking_data = false
	_steps(tracker, int(0.15 / STEP_S))
	check_equal(losses[0], 1, "0.15 s")
	_remove(hand, tracker)


func test_a_frozen_pose_is_lost_after_half_a_second() -> void:
	var hand := _add_hand()
	var tracker := _add_tracker()
	_move(tracker, hand, PLACE, PLACE, 0.3)
	_steps(tracker, int(0.45 / STEP_S))
	check(tracker.is_hand_tracked(), "0.45 s")
	_steps(tracker, int(0.25 / STEP_S))
	check(not tracker.is_hand_tracked(), "0.7 s")
	_move(tracker, hand, PLACE, PLACE, 0.1)
	check(tracker.is_hand_tracked(), "restored as it moves")
	_remove(hand, tracker)


func test_a_hand_that_turns_into_the_other_is_an_outlier() -> void:
	var right := _add_hand()
	var left := XRHand.new(XRHand.LEFT)
	left.register()
	var tracker := _add_tracker()
	var farthest := 0.0
	for step in 90:
		_time_s += STEP_S
		var tremor := PushedHand.tremor(_time_s)
		var is_swapped := step >= 40 and step < 46
		left.place(PLACE + Vector3(-0.3, 0.0, 0.0) + tremor)
		right.place(PLACE + (Vector3(-0.3, 0.0, 0.0) if is_swapped else Vector3.ZERO) - tremor)
		tracker.advance(STEP_S)
		farthest = maxf(farthest, _index(tracker).distance_to(PLACE))
		if is_swapped:
			check(not tracker.is_joint_tracked(INDEX), "frame %d is left out" % step)
	check(farthest < 0.01, "the hand never jumps: %s m" % farthest)
	check(tracker.is_joint_tracked(INDEX), "the hand is tracked again")
	left.remove()
	_remove(right, tracker)


func test_both_hands_at_once() -> void:
	var right := _add_hand()
	var left := XRHand.new(XRHand.LEFT)
	left.place(-PLACE)
	left.register()
	var trackers: Array[HandTracker] = [_add_tracker(), _add_tracker()]
	(trackers[1].source as XRSource).hand = HandTracker.HAND_LEFT
	for tracker in trackers:
		tracker.advance(STEP_S)
	check(_index(trackers[0]).is_equal_approx(PLACE), "the right one")
	check(_index(trackers[1]).is_equal_approx(-PLACE), "the left one")
	trackers[1].free()
	left.remove()
	_remove(right, trackers[0])


func test_body_space_turns_with_a_player_who_turns() -> void:
	var hand := _add_hand()
	var head := _add_head()
	var tracker := _add_tracker(XRSource.SPACE_BODY)
	for turned: float in [0.0, 0.5 * PI, -0.75 * PI]:
		_turn(head, turned)
		var start := PLACE.rotated(Vector3.UP, turned)
		_move(tracker, hand, start, start, 0.4)
		var from := _index(tracker)
		for step in range(1, 8):
			# The head follows the hand, which moves in every frame.
			_turn(head, turned - 0.15 * (step - 1))
			hand.place(start + step * Vector3(0.03, 0.0, -0.01).rotated(Vector3.UP, turned))
			tracker.advance(STEP_S)
		var way := _index(tracker) - from
		check(way.distance_to(Vector3(0.21, 0.0, -0.07)) < 1e-3, "%s rad: %s" % [turned, way])
	XRServer.remove_tracker(head)
	_remove(hand, tracker)


func test_a_tap_of_a_turned_player_is_recognised() -> void:
	var hand := _add_hand()
	var head := _add_head()
	var tracker := _add_tracker(XRSource.SPACE_BODY)
	var hmm := GestureHMM.new()
	for gesture: String in ["horizontal_drag", "tap", "vertical_drag"]:
		hmm.models = hmm.models + [load(Rig.MODEL % gesture) as GestureModel]
	hmm.tracker = tracker
	root.add_child(hmm)
	# A quarter turn to the left.
	_turn(head, 0.5 * PI)
	var start := Vector3(0.1, 1.2, -0.3).rotated(Vector3.UP, 0.5 * PI)
	var end := start + Vector3(-0.15, 0.0, 0.0)
	_move(tracker, hand, start, start, 1.0)
	_move(tracker, hand, start, end, 0.7)
	_move(tracker, hand, end, end, 0.8)
	check_equal(hmm.recognised, &"tap", "it goes ahead")
	hmm.free()
	XRServer.remove_tracker(head)
	_remove(hand, tracker)


func _index(tracker: HandTracker) -> Vector3:
	return tracker.get_joint_position(INDEX)


func _steps(tracker: HandTracker, count: int) -> void:
	for step in count:
		_time_s += STEP_S
		tracker.advance(STEP_S)


## A minimum-jerk movement with tremor.
func _move(tracker: HandTracker, hand: XRHand, from: Vector3, to: Vector3, taken_s: float) -> void:
	for step in int(taken_s / STEP_S):
		_time_s += STEP_S
		var share := PushedHand.share(step * STEP_S / taken_s)
		hand.place(from.lerp(to, share) + PushedHand.tremor(_time_s))
		tracker.advance(STEP_S)


func _turn(head: XRPositionalTracker, turned: float) -> void:
	var looks_down := Basis(Vector3.UP, turned) * Basis(Vector3.RIGHT, -0.5)
	var place := Transform3D(looks_down, Vector3(0.0, 1.6, 0.0))
	const SURE := XRPose.XR_TRACKING_CONFIDENCE_HIGH
	head.set_pose(&"default", place, Vector3.ZERO, Vector3.ZERO, SURE)


func _add_head() -> XRPositionalTracker:
	var head := XRPositionalTracker.new()
	head.name = &"head"
	head.type = XRServer.TRACKER_HEAD
	XRServer.add_tracker(head)
	_turn(head, 0.0)
	return head


func _add_hand() -> XRHand:
	var hand := XRHand.new()
	hand.place(PLACE)
	hand.register()
	return hand


func _add_tracker(space: XRSource.Space = XRSource.SPACE_WORLD) -> HandTracker:
	var source := XRSource.new()
	source.space = space
	var tracker := HandTracker.new()
	tracker.source = source
	tracker.update_mode = HandTracker.UPDATE_MANUAL
	root.add_child(tracker)
	return tracker


func _remove(hand: XRHand, tracker: HandTracker) -> void:
	hand.remove()
	XRServer.world_origin = Transform3D()
	tracker.free()
