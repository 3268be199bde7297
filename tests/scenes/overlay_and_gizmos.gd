extends "support/scene_test.gd"
## Help for the set-up of a scene: the debug overlay, and the shapes in the editor's 3D view.

const DebugOverlay := preload("res://addons/steadyhand/debug_overlay.gd")
const TaskShape := preload("res://addons/steadyhand/editor/task_shape.gd")
const TrackerShape := preload("res://addons/steadyhand/editor/tracker_shape.gd")


func test_the_overlay_describes_the_tracker() -> void:
	var tracker := HandTracker.new()
	var overlay := _add_overlay()
	root.add_child(tracker)
	check_equal(overlay.describe_tracker(), "no tracker", "without one")
	overlay.tracker = tracker
	# expects error: set "source", e.g. to an XRSource
	tracker.start()
	_check_shows(overlay, 'no source: set "source"')
	tracker.source = ScriptSource.new()
	tracker.start()
	_check_shows(overlay, "ScriptSource: no hand")
	for frame in 100:
		tracker.push_frame(frame / 60.0, {HandTracker.JOINT_INDEX: Vector3.ONE})
	_check_shows(overlay, "hand tracked\n60.0 Hz, jitter 0.00 ms, latency unknown, noise unknown")
	_check_shows(overlay, "\n0 dropouts, 0 freezes, 0 jumps")
	for frame in 2:
		await process_frame
	var label := overlay.get_node("Panel/Rows/Tracker") as Label
	check_equal(label.text, overlay.describe_tracker(), "it is shown")
	for node: Node in [overlay, tracker]:
		node.free()


func test_the_overlay_finds_the_gesture_hmm_of_each_scene() -> void:
	var overlay := _add_overlay()
	var points := overlay.get_node("Points") as Control
	await process_frame
	for scene in 2:
		await process_frame
		check_equal(overlay.describe_tracker(), "no tracker", "before scene %d" % scene)
		check(not points.visible, "no points in it")
		var tracker := HandTracker.new()
		tracker.source = ScriptSource.new()
		var hmm := GestureHMM.new()
		tracker.add_child(hmm)
		root.add_child(tracker)
		await process_frame
		await process_frame
		check_equal(overlay.gesture_hmm, hmm, "the GestureHMM of scene %d" % scene)
		_check_shows(overlay, "ScriptSource: no hand")
		check(points.visible, "its points")
		tracker.free()
	overlay.free()


func test_a_task_is_an_arrow_of_its_length_in_the_world() -> void:
	var task := GestureTask.new()
	task.position = Vector3(1, 2, 3)
	task.rotation = Vector3(0.3, -0.5, 0.7)
	task.scale = Vector3(2, 2, 2)
	task.direction = Vector3(0, 1, 1)
	task.amplitude = 0.3
	root.add_child(task)
	var lines := TaskShape.lines(task)
	check(task.to_global(lines[0]).is_equal_approx(task.get_start()), "from the start")
	var end := task.get_start() + 0.3 * task.get_axis()
	check(task.to_global(lines[1]).is_equal_approx(end), "to the end")
	task.start_radius = 0.02
	var radii := Array(TaskShape.lines(task)).map(func(p: Vector3) -> float: return p.length())
	check_near(radii.min(), 0.02, 1e-6, "a radius starts at the start radius")
	check_near(radii.max(), 0.32, 1e-6, "to its end")
	task.free()


func test_the_start_cylinder_is_where_a_gesture_may_begin() -> void:
	var task := GestureTask.new()
	task.position = Vector3(1, 2, 3)
	task.scale = Vector3(2, 2, 2)
	task.direction = Vector3(0, 0, 1)
	task.amplitude = 0.3
	root.add_child(task)
	for point in TaskShape.start_cylinder(task):
		var offset := task.to_global(point) - task.get_start()
		var along := offset.dot(task.get_axis())
		check_near(absf(along), 0.18, 1e-5, "along the axis")
		check_near((offset - along * task.get_axis()).length(), 0.18, 1e-5, "around it")
	task.start_radius = 0.02
	check(TaskShape.start_cylinder(task).is_empty(), "a radius begins anywhere")
	task.free()


func test_the_range_of_a_tracker_is_where_its_device_is() -> void:
	var tracker := HandTracker.new()
	tracker.autostart = false
	tracker.position = Vector3(5, 5, 5)
	tracker.rotation = Vector3(0.1, 0.2, 0.3)
	root.add_child(tracker)
	check(TrackerShape.lines(tracker).is_empty(), "without a source")
	tracker.source = SyntheticSource.new()
	check(TrackerShape.lines(tracker).is_empty(), "a simulation has no range")
	var leap := LeapSource.new()
	leap.device_transform = Transform3D(Basis(), Vector3(0, 0.8, -0.4))
	tracker.source = leap
	var farthest := 0.0
	for point in TrackerShape.lines(tracker):
		var offset := tracker.to_global(point) - leap.device_transform.origin
		check(offset.y > 0.0, "above the device")
		farthest = maxf(farthest, offset.length())
	check_near(farthest, 0.6, 1e-4, "the range is at most 60 cm")
	leap.mounting = LeapSource.MOUNTING_HMD
	check(TrackerShape.lines(tracker).is_empty(), "no range for a moving headset")
	tracker.free()


func _add_overlay() -> DebugOverlay:
	var scene := load("res://addons/steadyhand/debug_overlay.tscn") as PackedScene
	var overlay := scene.instantiate() as DebugOverlay
	root.add_child(overlay)
	return overlay


func _check_shows(overlay: DebugOverlay, text: String) -> void:
	var shown_text := overlay.describe_tracker()
	check(shown_text.contains(text), ("'%s' is in '%s'" % [text, shown_text]).replace("\n", " / "))
