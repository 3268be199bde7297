extends "support/sample_test.gd"
## The add-on's samples and their chooser with a scripted mouse.

# engine options: --fixed-fps 90

const PushedHand := preload("support/pushed_hand.gd")

var _pointer := Vector2.ZERO


func test_clicks_press_keys() -> void:
	_open("key_panel")
	(_scene.get_node("Hand") as SampleHand).use(SampleHand.Device.MOUSE)
	_scene.connect(&"key_pressed", func(key: String) -> void: _events.append(key))
	for key: int in [0, 4, 11]:
		await _click(_hmm.tasks[key])
	check_equal("".join(_events), "15#", "three clicks")
	_close()


func test_the_mouse_drags_the_box_with_its_button_down() -> void:
	_open("pinch_drag")
	(_scene.get_node("Hand") as SampleHand).use(SampleHand.Device.MOUSE)
	var box := _scene.get_node("Box") as Node3D
	var start := box.position.x
	await _drag_mouse(_hmm.task, 1.0)
	check_near(box.position.x, start, 0.0, "not without")
	_point(_hmm.task.get_start())
	_button(MOUSE_BUTTON_LEFT, true)
	await _drag_mouse(_hmm.task, 1.0)
	check_near(box.position.x, start + _hmm.task.amplitude, 0.01, "it is there")
	_close()


func test_the_mouse_moves_the_slider_and_pulls_the_drawer() -> void:
	_open("slider")
	(_scene.get_node("Hand") as SampleHand).use(SampleHand.Device.MOUSE)
	await _drag_mouse(_hmm.task, 0.4)
	check_near(_scene.get("value") * _hmm.task.amplitude, 0.4 * _hmm.task.amplitude, 0.01, "it")
	_close()
	_open("drawer")
	(_scene.get_node("Hand") as SampleHand).use(SampleHand.Device.MOUSE)
	await _drag_mouse(_hmm.task, 1.0)
	check_near(_scene.call("get_opening"), 1.0, 0.01, "and it")
	_close()


func test_a_mouse_without_a_task_is_an_error() -> void:
	# expects error: set "task_path" of the MouseSource to a GestureTask
	var tracker := HandTracker.new()
	tracker.source = MouseSource.new()
	root.add_child(tracker)
	check(not tracker.is_running(), "it does not start")
	tracker.free()


func test_the_wheel_zooms_the_map() -> void:
	_open("zoom_map")
	(_scene.get_node("Hand") as SampleHand).use(SampleHand.Device.MOUSE)
	_point(_hmm.task.get_start())
	await _frames(80)
	for notch in 2:
		_button(MOUSE_BUTTON_WHEEL_UP, true)
		await _frames(1)
	await _frames(80)
	check_near(_scene.get("zoom"), 3.0, 0.15, "two notches")
	_close()


func test_a_click_in_the_chooser_opens_its_sample_and_escape_leads_back() -> void:
	change_scene_to_file(FOLDER % "samples")
	await _frames(3)
	_hmm = current_scene.get_node("GestureHMM")
	await _click(_hmm.tasks[1])
	await _frames(3)
	check_equal(current_scene.name, &"Drawer", "the second one")
	var escape := InputEventKey.new()
	escape.keycode = KEY_ESCAPE
	escape.pressed = true
	root.push_input(escape)
	await _frames(3)
	check_equal(current_scene.name, &"Samples", "and back")
	root.push_input(escape)
	await _frames(3)
	check_equal(current_scene.name, &"Menu", "from there to the project's main scene")
	current_scene.free()


## From rest at the start of `task` to rest at a fraction of its way.
func _drag_mouse(task: GestureTask, fraction: float) -> void:
	_point(task.get_start())
	await _frames(80)
	for frame in 61:
		var way := PushedHand.share(frame / 60.0) * fraction * task.amplitude
		_point(task.get_start() + way * task.get_axis())
		await _frames(1)
	await _frames(40)


func _click(task: GestureTask) -> void:
	_point(task.get_start() + task.amplitude * task.get_axis())
	await _frames(60)
	_button(MOUSE_BUTTON_LEFT, true)
	await _frames(40)
	_button(MOUSE_BUTTON_LEFT, false)
	await _frames(40)


func _point(place: Vector3) -> void:
	_pointer = root.get_camera_3d().unproject_position(place)
	var motion := InputEventMouseMotion.new()
	motion.position = _pointer
	root.push_input(motion, true)


func _button(index: MouseButton, is_pressed: bool) -> void:
	var button := InputEventMouseButton.new()
	button.button_index = index
	button.pressed = is_pressed
	button.position = _pointer
	root.push_input(button, true)
