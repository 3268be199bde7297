extends "support/scene_test.gd"
## What helps to set a scene up: the tracker's HUD, the shape of a task in the editor's 3D view.

const TaskShape := preload("res://addons/steadyhand/editor/task_shape.gd")


func test_the_hud_tells_how_a_tracker_does() -> void:
	var tracker := HandTracker.new()
	var hud := (load("res://addons/steadyhand/tracker_hud.tscn") as PackedScene).instantiate()
	for node: Node in [tracker, hud]:
		root.add_child(node)
	check_equal(hud.call("describe"), "no tracker", "without one")
	hud.set("tracker", tracker)
	# expects error: set "source", e.g. to an XRSource
	tracker.start()
	_check_says(hud, 'no source: set "source"')
	tracker.source = ScriptSource.new()
	tracker.start()
	_check_says(hud, "ScriptSource: no hand")
	for frame in 100:
		tracker.push_frame(frame / 60.0, {HandTracker.JOINT_INDEX: Vector3.ONE})
	_check_says(hud, "hand tracked\n60.0 Hz, jitter 0.00 ms, latency unknown, noise unknown")
	_check_says(hud, "\n0 dropouts, 0 freezes, 0 jumps")
	for frame in 2:
		await process_frame
	check((hud.get_node("Panel/Label") as Label).text == hud.call("describe"), "it is shown")
	for node: Node in [hud, tracker]:
		node.free()


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
	check_near(radii.min(), 0.02, 1e-6, "a radius: from its start")
	check_near(radii.max(), 0.32, 1e-6, "to its end")
	task.free()


func _check_says(hud: Node, text: String) -> void:
	var said: String = hud.call("describe")
	check(said.contains(text), ("'%s' is in '%s'" % [text, said]).replace("\n", " / "))
