extends "support/sample_test.gd"
## The add-on's samples with a simulated hand, a recording and an OpenXR hand.

# engine options: --fixed-fps 90

const PushedHand := preload("support/pushed_hand.gd")
const XRHand := preload("support/xr_hand.gd")


func test_the_key_that_is_tapped_is_the_key_that_is_pressed() -> void:
	var hand := _open("key_panel")
	_scene.connect(&"key_pressed", func(key: String) -> void: _events.append(key))
	var keys := ""
	for task in _hmm.tasks:
		await hand.make_gesture(task)
		keys += (task.get_node("../Cap/Label") as Label3D).text
	check_equal("".join(_events), keys, "all keys")
	_close()


func test_the_drawer_opens_and_closes() -> void:
	var hand := _open("drawer")
	await hand.make_gesture(_hmm.tasks[0], 0.0, 0.5)
	check_near(_scene.call("get_opening"), 0.5, 0.05, "pulled half-way")
	await hand.move_to(_hmm.tasks[0].get_start(), 0.8)
	await hand.make_gesture(_hmm.tasks[0])
	check_near(_scene.call("get_opening"), 1.0, 0.01, "pulled")
	await hand.make_gesture(_hmm.tasks[1])
	check_near(_scene.call("get_opening"), 0.0, 0.01, "pushed back")
	_close()


func test_the_slider_is_within_1_cm_of_a_hand_that_stops() -> void:
	var hand := _open("slider")
	var task := _hmm.task
	await hand.reach(task)
	for stop: float in [0.3, 0.62, 1.0, 0.45, 0.1, 0.8, 0.0]:
		await hand.move_to(task.get_start() + stop * task.amplitude * task.get_axis(), 0.8)
		await hand.rest(0.5)
		var way: float = _scene.get("value") * task.amplitude
		check_near(way, stop * task.amplitude, 0.01, "at %s" % stop)
	_close()


func test_the_slider_stays_where_the_hand_leaves_it() -> void:
	var hand := _open("slider")
	var task := _hmm.task
	await hand.make_gesture(task, 0.8, 0.5)
	var left: float = _scene.get("value")
	await hand.move_to(hand.get_place() + 0.2 * Vector3.UP, 0.6)
	await hand.move_to(hand.get_place() + 0.1 * Vector3.RIGHT, 0.6)
	check_near(_scene.get("value"), left, 0.02, "there")
	_close()


func test_the_box_moves_only_in_a_pinch() -> void:
	var hand := _open("pinch_drag")
	var box := _scene.get_node("Box") as Node3D
	var start := box.position.x
	_scene.connect(&"box_placed", func() -> void: _events.append("placed"))
	_scene.connect(&"box_dropped", func() -> void: _events.append("dropped"))
	await hand.make_gesture(_hmm.task)
	check_near(box.position.x, start, 0.0, "open fingers")
	hand.pinches = true
	await hand.make_gesture(_hmm.task)
	check_near(box.position.x, start + _hmm.task.amplitude, 0.01, "pinched")
	check_equal(_events, ["placed"] as Array[String], "placed")
	_close()


func test_a_box_that_is_let_go_half_way_is_back_at_its_start() -> void:
	var hand := _open("pinch_drag")
	var box := _scene.get_node("Box") as Node3D
	var start := box.position.x
	await hand.reach(_hmm.task)
	await hand.pinch()
	await hand.move_to(hand.get_place() + 0.5 * _hmm.task.amplitude * _hmm.task.get_axis(), 0.8)
	await hand.rest(0.5)
	check_near(box.position.x, start + 0.5 * _hmm.task.amplitude, 0.01, "half-way")
	await hand.release()
	await hand.rest(0.5)
	check_near(box.position.x, start, 0.0, "let go")
	_close()


func test_the_map_grows_by_as_much_as_the_fingers_open() -> void:
	var hand := _open("zoom_map")
	var whole := (_hmm.task.start_radius + _hmm.task.amplitude) / _hmm.task.start_radius
	await hand.make_gesture(_hmm.task)
	check_near(_scene.get("zoom"), whole, 0.15, "a stroke")
	await hand.make_gesture(_hmm.task)
	check_near(_scene.get("zoom"), whole * whole, 0.9, "and another")
	_close()


func test_the_fingertips_light_up_as_the_vibration_is_felt() -> void:
	var hand := _open("drawer")
	var tip := _scene.get_node("SampleStage/Fingertips/Index") as MeshInstance3D
	var material := tip.material_override as StandardMaterial3D
	await hand.reach(_hmm.task)
	check_near(material.emission_energy_multiplier, 0.0, 0.1, "at rest")
	hand.move_to(_hmm.task.get_start() + _hmm.task.amplitude * _hmm.task.get_axis(), 0.8)
	await hand.rest(0.5)
	check(material.emission_energy_multiplier > 0.5, "in the middle of a pull")
	_close()


func test_every_sample_shows_by_itself_how_it_is_done() -> void:
	for sample: String in ["key_panel", "drawer", "slider", "pinch_drag", "zoom_map"]:
		_open(sample)
		var hand := _scene.get_node("Hand") as SampleHand
		hand.use(SampleHand.Device.SHOWN)
		_hmm.gesture_ended.connect(
			func(_g: StringName, _time_s: float, _t: GestureTask, _f: float) -> void:
				_events.append("ended")
		)
		for frame in 600:
			await process_frame
		check(not _events.is_empty(), sample)
		_close()


func test_a_recording_in_the_hand_s_source_is_played() -> void:
	var hand := _open("drawer")
	var track := DirAccess.create_temp("steadyhand_samples")
	var path := track.get_current_dir().path_join("pull.csv")
	_hmm.tracker.start_recording(path)
	await hand.make_gesture(_hmm.task)
	_close()
	var recording := RecordedSource.new()
	recording.track = path
	_scene = (load(FOLDER % "drawer") as PackedScene).instantiate()
	(_scene.get_node("Hand") as HandTracker).source = recording
	root.add_child(_scene)
	await _frames(250)
	check_near(_scene.call("get_opening"), 1.0, 0.01, "the drawer is open")
	_close()


func test_an_xr_hand_pulls_the_drawer_and_taps_the_way_back() -> void:
	var xr_hand := XRHand.new()
	xr_hand.register()
	change_scene_to_file(FOLDER % "drawer")
	await _frames(3)
	_hmm = current_scene.get_node("GestureHMM")
	(current_scene.get_node("Hand") as SampleHand).use(SampleHand.Device.OPENXR)
	var back: GestureTask = current_scene.get_node("SampleStage").call("add_back_key")
	await _move_xr_hand(xr_hand, _hmm.task, 0.8)
	check_near(current_scene.call("get_opening"), 1.0, 0.01, "it is open")
	await _move_xr_hand(xr_hand, back, 0.3)
	check_equal(current_scene.name, &"Samples", "the chooser")
	current_scene.free()
	xr_hand.remove()


func test_a_copied_script_of_a_sample_loads() -> void:
	var folder := DirAccess.create_temp("steadyhand_samples")
	for sample: String in ["drawer", "key_panel", "pinch_drag", "slider", "zoom_map"]:
		var copy := folder.get_current_dir().path_join(sample + ".gd")
		DirAccess.copy_absolute((FOLDER % sample).replace(".tscn", ".gd"), copy)
		var script := load(copy) as GDScript
		check(script != null and script.can_instantiate(), "%s loads in another folder" % sample)


func test_the_add_on_uses_nothing_outside_its_folder() -> void:
	var outside := RegEx.create_from_string('res://(?!addons/steadyhand/)[^"]*')
	var folders: Array[String] = ["res://addons/steadyhand"]
	var files := 0
	while not folders.is_empty():
		var folder: String = folders.pop_back()
		for name in DirAccess.get_directories_at(folder):
			folders.append(folder.path_join(name))
		for name in DirAccess.get_files_at(folder):
			if name.get_extension() in ["gd", "tscn", "tres"]:
				var path := folder.path_join(name)
				var found := outside.search(FileAccess.get_file_as_string(path))
				# Templates are for copying; the editor keeps takes and models in the project.
				var may_name_others := folder.ends_with("templates") or "/editor" in folder
				if found != null and not may_name_others:
					check(false, "%s uses %s" % [path, found.get_string()])
				files += 1
	check(files > 20, "%d files" % files)


## From rest at the start of `task` to rest at its end.
func _move_xr_hand(xr_hand: XRHand, task: GestureTask, duration_s: float) -> void:
	var start := task.get_start()
	var way := task.amplitude * task.get_axis()
	for frame in roundi(90.0 * (duration_s + 1.6)):
		var time_s := frame / 90.0
		var share := PushedHand.share((time_s - 0.8) / duration_s)
		xr_hand.place(start + share * way + PushedHand.tremor(time_s))
		await process_frame
