extends "support/scene_test.gd"
## The display of a tracked hand, and the player's rig without a headset.

const HandView := preload("res://xr/hand_view.gd")

const FINGER_BONES := 4 + 4 * 4 - 1


func test_a_simulated_hand_is_shown_whole() -> void:
	var tracker := HandTracker.new()
	tracker.source = SyntheticSource.new()
	tracker.update_mode = HandTracker.UPDATE_MANUAL
	XRServer.world_origin = Transform3D(Basis(Vector3.UP, 0.5), Vector3(5.0, 1.0, 0.0))
	XRServer.world_scale = 2.0
	var view := HandView.new()
	view.tracker = tracker
	for node: Node in [tracker, view]:
		root.add_child(node)
	tracker.start()
	tracker.advance(0.5)
	for frame in 2:
		await process_frame
	var shown := view.get_children().filter(
		func(shape: MeshInstance3D) -> bool: return shape.visible
	)
	check_equal(shown.size(), HandView.PALM.size() + FINGER_BONES + 5, "bones and fingertips")
	var tip := tracker.get_joint_position(HandTracker.JOINT_INDEX)
	var is_at_tip := func(shape: MeshInstance3D) -> bool:
		return shape.mesh is SphereMesh and shape.global_position.is_equal_approx(tip)
	check(shown.any(is_at_tip), "a fingertip is at its tracked position")
	tracker.stop()
	for frame in 2:
		await process_frame
	var is_hidden := func(shape: MeshInstance3D) -> bool: return not shape.visible
	check(view.get_children().all(is_hidden), "a lost hand is hidden")
	XRServer.world_origin = Transform3D()
	XRServer.world_scale = 1.0
	for node: Node in [view, tracker]:
		node.free()


func test_the_rig_does_nothing_without_a_headset() -> void:
	var rig := (load("res://xr/xr_rig.tscn") as PackedScene).instantiate()
	root.add_child(rig)
	await process_frame
	check(not rig.call("is_active"), "no XR interface")
	check(not root.use_xr, "the viewport stays as it is")
	check(not (rig.get_node("Right") as HandTracker).is_running(), "the tracker does not run")
	var camera := rig.get_node("XRCamera3D") as Node3D
	camera.transform = Transform3D(Basis(Vector3.UP, 1.0), Vector3(0.3, 1.5, -0.4))
	rig.call("recentre")
	check(camera.global_position.is_equal_approx(Vector3(0, 1.2, 0)), "the head is at the seat")
	check(camera.global_basis.z.is_equal_approx(Vector3.BACK), "and looks ahead")
	rig.free()
