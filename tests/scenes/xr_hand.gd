extends "support/scene_test.gd"
## The example's script of a hand that XRServer tracks, by a tracker that is made up.

const Example := preload("res://examples/xr_hand.gd")

const RIGHT := &"/user/hand_tracker/right"
const INDEX := HandTracker.JOINT_INDEX
const INDEX_TIP := XRHandTracker.HAND_JOINT_INDEX_FINGER_TIP


## A player whom a script moves, after the tracker in the tree.
class Mover:
	extends XROrigin3D

	func _process(_delta: float) -> void:
		position.x += 0.02


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


func test_a_hand_goes_along_in_the_frame_in_which_the_player_is_moved() -> void:
	var hand := _add_hand()
	var tracker := _add_tracker()
	var origin := Mover.new()
	root.add_child(origin)
	origin.current = true
	var behind: Array[float] = []
	await _frames(2)
	for frame in 4:
		await process_frame
		var shown := origin.global_transform * Vector3(0.1, 0.2, -0.3)
		behind.append(shown.distance_to(tracker.get_joint_position(INDEX)))
	check(behind.max() < 1e-5, "where it is shown: %s" % [behind])
	origin.free()
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
