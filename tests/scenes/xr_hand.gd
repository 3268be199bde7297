extends "support/scene_test.gd"
## The example's script of a hand that XRServer tracks, by a tracker that is made up.

const Example := preload("res://examples/xr_hand.gd")
const PushedHand := preload("support/pushed_hand.gd")
const Rig := preload("support/rig.gd")

const RIGHT := &"/user/hand_tracker/right"
const INDEX := HandTracker.JOINT_INDEX
const INDEX_TIP := XRHandTracker.HAND_JOINT_INDEX_FINGER_TIP


func test_frames_are_in_the_world_or_in_a_space_that_the_game_moves() -> void:
	var hand := _add_hand()
	XRServer.world_origin = Transform3D(Basis(), Vector3(0.0, 1.0, 0.0))
	var tracker := _add_tracker()
	await _frames(2)
	check_equal(tracker.get_joint_position(INDEX), Vector3(0.1, 1.2, -0.3), "in the world")
	check(not tracker.is_joint_tracked(HandTracker.JOINT_THUMB), "a joint that is not tracked")
	tracker.in_world = false
	XRServer.world_origin.origin += Vector3(3.0, 0.0, -4.0)
	await _frames(2)
	var with_player := Vector3(0.1, 0.2, -0.3)
	check_equal(tracker.get_joint_position(INDEX), with_player, "with the player, who is moved")
	hand.has_tracking_data = false
	await _frames(2)
	check(not tracker.is_joint_tracked(INDEX), "a hand that is lost")
	_remove(hand, tracker)


func test_the_scale_of_the_world_is_the_world_s_only() -> void:
	var hand := _add_hand()
	var tracker := _add_tracker()
	XRServer.world_scale = 2.0
	await _frames(2)
	var doubled := Vector3(0.2, 0.4, -0.6)
	check(tracker.get_joint_position(INDEX).is_equal_approx(doubled), "in the world")
	tracker.in_world = false
	await _frames(2)
	check(tracker.get_joint_position(INDEX).is_equal_approx(0.5 * doubled), "as the body is")
	XRServer.world_scale = 1.0
	_remove(hand, tracker)


func test_a_player_who_turns_in_the_room_takes_the_space_along() -> void:
	var hand := _add_hand()
	var head := _add_head()
	var tracker := _add_tracker()
	tracker.in_world = false
	for turned: float in [0.0, 0.5 * PI, -0.75 * PI]:
		_turn(head, turned)
		var start := Vector3(0.1, 0.2, -0.3).rotated(Vector3.UP, turned)
		await _move(hand, start, start, 0.4)
		var from := tracker.get_joint_position(INDEX)
		for step in range(1, 8):
			# The head looks after the hand, which rests in none of the frames, however long they are.
			_turn(head, turned - 0.15 * (step - 1))
			var place := start + step * Vector3(0.03, 0.0, -0.01).rotated(Vector3.UP, turned)
			hand.set_hand_joint_transform(INDEX_TIP, Transform3D(Basis(), place))
			await _frames(1)
		await _frames(1)
		var way := tracker.get_joint_position(INDEX) - from
		check(way.distance_to(Vector3(0.21, 0.0, -0.07)) < 1e-3, "%s rad: %s" % [turned, way])
	tracker.turns_with_player = false
	await _frames(2)
	var seen := hand.get_hand_joint_transform(INDEX_TIP).origin
	check(tracker.get_joint_position(INDEX).is_equal_approx(seen), "the origin's space")
	XRServer.remove_tracker(head)
	_remove(hand, tracker)


func test_the_tap_of_a_player_who_has_turned_is_one() -> void:
	var hand := _add_hand()
	var head := _add_head()
	var tracker := _add_tracker()
	tracker.in_world = false
	var hmm := GestureHMM.new()
	var gestures: Array[String] = ["horizontal_drag", "tap", "vertical_drag"]
	for gesture in gestures:
		hmm.models = hmm.models + [load(Rig.MODEL % gesture) as GestureModel]
	hmm.tracker = tracker
	root.add_child(hmm)
	var start := Vector3(0.1, 1.2, -0.3)
	await _move(hand, start, start, 0.3)
	# A quarter to the left: ahead is where the left was.
	_turn(head, 0.5 * PI)
	start = start.rotated(Vector3.UP, 0.5 * PI)
	await _move(hand, start, start, 1.0)
	await _move(hand, start, start + Vector3(-0.15, 0.0, 0.0), 0.7)
	await _move(hand, start + Vector3(-0.15, 0.0, 0.0), start + Vector3(-0.15, 0.0, 0.0), 0.8)
	check_equal(hmm.recognised, &"tap", "it goes ahead")
	hmm.free()
	XRServer.remove_tracker(head)
	_remove(hand, tracker)


func test_a_tracker_that_is_no_hands_is_told_of_once() -> void:
	# expects one warning: /user/hand_tracker/right is no XRHandTracker but XRControllerTracker
	var controller := XRControllerTracker.new()
	controller.name = RIGHT
	XRServer.add_tracker(controller)
	var tracker := _add_tracker()
	await _frames(4)
	check(not tracker.is_joint_tracked(INDEX), "it has no joints")
	_remove(controller, tracker)


func _frames(count: int) -> void:
	for frame in count:
		await process_frame


## As smoothly as a hand does, at the pace of the clock.
func _move(hand: XRHandTracker, from: Vector3, to: Vector3, duration_s: float) -> void:
	var began_us := Time.get_ticks_usec()
	var passed := 0.0
	while passed < 1.0:
		passed = minf(1e-6 * (Time.get_ticks_usec() - began_us) / duration_s, 1.0)
		var tip := from.lerp(to, PushedHand.share(passed))
		hand.set_hand_joint_transform(INDEX_TIP, Transform3D(Basis(), tip))
		await process_frame
	await process_frame


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


func _add_hand() -> XRHandTracker:
	var hand := XRHandTracker.new()
	hand.name = RIGHT
	hand.has_tracking_data = true
	# The engine leaves them uninitialised.
	for joint in XRHandTracker.HAND_JOINT_MAX:
		hand.set_hand_joint_flags(joint, 0)
	hand.set_hand_joint_transform(INDEX_TIP, Transform3D(Basis(), Vector3(0.1, 0.2, -0.3)))
	hand.set_hand_joint_flags(INDEX_TIP, XRHandTracker.HAND_JOINT_FLAG_POSITION_TRACKED)
	XRServer.add_tracker(hand)
	return hand


func _add_tracker() -> Example:
	var tracker := Example.new()
	root.add_child(tracker)
	return tracker


func _remove(xr_tracker: XRTracker, tracker: Example) -> void:
	XRServer.remove_tracker(xr_tracker)
	XRServer.world_origin = Transform3D()
	tracker.free()
