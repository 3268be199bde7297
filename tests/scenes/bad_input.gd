extends "support/scene_test.gd"
## Each bad file gives one clear error. Calls to a node before and after it still work.

const Rig := preload("support/rig.gd")

const GOOD_TRACK := "t,index_x,index_y,index_z\n0.0,0.1,0.2,0.3\n0.1,0.1,0.2,0.3\n"

var _folder := DirAccess.create_temp("steadyhand_bad_input")
var _messages: Array[String] = []


func test_missing_recording() -> void:
	# expects error: missing.csv
	_check_tracker_refuses("missing.csv", "missing.csv")


func test_broken_cell() -> void:
	# expects error: cell.csv:3
	_write("cell.csv", "t,index_x,index_y,index_z\n0.0,0.1,0.2,0.3\n0.1,abc,0.2,0.3\n")
	_check_tracker_refuses("cell.csv", "cell.csv:3")


func test_time_going_back() -> void:
	# expects error: back.csv:3
	_write("back.csv", "t,index_x,index_y,index_z\n5.0,0.1,0.2,0.3\n0.1,0.1,0.2,0.3\n")
	_check_tracker_refuses("back.csv", "back.csv:3")


func test_binary() -> void:
	# expects error: binary.csv
	var bytes := PackedByteArray()
	for i in 4000:
		bytes.append((i * 197 + i / 7) % 256)
	FileAccess.open(_path("binary.csv"), FileAccess.WRITE).store_buffer(bytes)
	_check_tracker_refuses("binary.csv", "binary.csv")


func test_empty_file() -> void:
	# expects error: empty.csv
	_write("empty.csv", "")
	_check_tracker_refuses("empty.csv", "empty.csv")


func test_wrong_model() -> void:
	# expects error: wrong.gesture
	_write("wrong.gesture", '{"gesture": "horizontal_drag"}')
	check(load(_path("wrong.gesture")) == null, "a file that is no model gives null")


func test_text_that_is_no_model() -> void:
	# expects error: not valid JSON
	var model := load(Rig.MODEL % "horizontal_drag") as GestureModel
	var text := model.to_text()
	var copy := GestureModel.new()
	check_equal(copy.parse_text(text), OK, "a model's own text is read")
	check(copy.parse_text("nonsense") != OK, "nonsense is refused")
	check_equal(copy.to_text(), text, "the old data stays")


func test_missing_trial_set() -> void:
	# expects error: no_set
	check(TrialSet.load_folder(_path("no_set")) == null, "a missing folder gives null")


func test_invalid_options_of_a_synthetic_set_are_refused() -> void:
	# expects error: there is no option 'subject'
	# expects error: duration: -1.000000 s is not in 0..3600
	# expects error: duration: inf s is not in 0..3600
	# expects error: paces: 100.000000 is not in 0.1..10
	# expects error: subjects: 'a' is not a number
	# expects error: gestures: 'tap' is not a list
	for options: Dictionary in [
		{subject = 1},
		{duration = -1.0},
		{duration = INF},
		{paces = [1.0, 100.0]},
		{subjects = "a"},
		{gestures = "tap"},
	]:
		var refused := TrialSet.write_synthetic(_path("no_set_made"), options)
		check_equal(refused, ERR_INVALID_PARAMETER, "%s is refused" % options)
	check(not DirAccess.dir_exists_absolute(_path("no_set_made")), "nothing is written")


func test_times_in_milliseconds_warn_once() -> void:
	# expects one warning: the times of successive frames are more than 10 s apart
	var tracker := _make_tracker()
	tracker.source = ScriptSource.new()
	var gesture_hmm := GestureHMM.new()
	gesture_hmm.models = [load(Rig.MODEL % "horizontal_drag") as GestureModel]
	tracker.add_child(gesture_hmm)
	gesture_hmm.tracker = tracker
	tracker.start()
	var time := 0.0
	for i in 40:
		time += 9.0 if i % 8 == 7 else 11.0
		tracker.push_frame(time, {HandTracker.JOINT_INDEX: Vector3(0.1, 1.0, -0.3)})
	check_equal(gesture_hmm.gesture, &"", "no gesture")
	tracker.free()


func test_recording_to_a_bad_path() -> void:
	# expects error: no_folder
	# expects error: start_recording: the path must end with .csv
	var tracker := _make_tracker()
	tracker.source = ScriptSource.new()
	tracker.start()
	check(tracker.start_recording(_path("no_folder/track.csv")) != OK, "refused")
	check(tracker.start_recording("") != OK, "an empty path is refused")
	var file := FileAccess.open(_path("precious.txt"), FileAccess.WRITE)
	file.store_string("precious")
	file.close()
	check(tracker.start_recording(_path("precious.txt")) != OK, "another file ending is refused")
	check_equal(FileAccess.get_file_as_string(_path("precious.txt")), "precious", "which is kept")
	tracker.push_frame(0.0, {HandTracker.JOINT_INDEX: Vector3.ONE})
	check(tracker.is_joint_tracked(HandTracker.JOINT_INDEX), "the tracker continues")
	tracker.free()


func test_invalid_frames_change_no_output() -> void:
	# expects error: push_frame
	var rig := _make_script_rig()
	rig.tracker.start()
	rig.tracker.push_frame(1.0, {HandTracker.JOINT_INDEX: Vector3(0.01, 0, 0)})
	rig.tracker.push_frame(NAN, {HandTracker.JOINT_INDEX: Vector3.ZERO})
	rig.tracker.push_frame(1.01, {HandTracker.JOINT_INDEX: Vector3(NAN, INF, 0)})
	rig.tracker.push_frame(0.5, {HandTracker.JOINT_INDEX: Vector3.ZERO})
	rig.tracker.push_frame(1.02, {HandTracker.JOINT_INDEX: Vector3(1e30, -1e30, 0)})
	rig.tracker.push_frame(1.03, {HandTracker.JOINT_INDEX: Vector3(0.02, 0, 0)})
	var is_finite_everywhere := true
	for motion in Rig.MOTIONS:
		var value := rig.gesture_hmm.get_motion_value(motion)
		is_finite_everywhere = is_finite_everywhere and is_finite(value)
	check(is_finite_everywhere, "every condition stays finite")
	check_equal(rig.tracker.get_time(), 1.03, "the clock advances with the good frames")
	rig.free_nodes()


func test_fingertips_in_line_or_in_one_point() -> void:
	var trial := {
		gesture = "zoom", amplitude_m = 0.03, start = Vector3(0.015, 0, 0), axis = Vector3.ZERO
	}
	var rig := Rig.new(trial, "", root)
	rig.tracker.source = ScriptSource.new()
	rig.tracker.start()
	var line := Vector3(0.02, 0.01, 0.3)
	_push_tips(rig, 1.0, [Vector3(0.02, 0, 0), Vector3(-0.02, 0, 9), Vector3(0, 0.02, -9)])
	var seen := rig.gesture_hmm.get_motion_value(GestureHMM.MOTION_MEASURED)
	check_near(seen, 0.005, 1e-6, "20 mm, 5 mm more than at the start, for any z")
	var is_finite_everywhere := true
	for scale: float in [1e-9, 1.0, 1e9]:
		for tips: Array in [
			[line, 2.0 * line, 3.0 * line],
			[line, line, 2.0 * line],
			[line, line, line],
			[Vector3.ZERO, Vector3.ZERO, Vector3.ZERO],
		]:
			_push_tips(rig, rig.tracker.get_time() + 0.01, tips, scale)
			for motion in Rig.MOTIONS:
				var value := rig.gesture_hmm.get_motion_value(motion)
				is_finite_everywhere = is_finite_everywhere and is_finite(value)
	check(is_finite_everywhere, "every condition stays finite")
	var kept := rig.gesture_hmm.get_motion_value(GestureHMM.MOTION_MEASURED)
	check_equal(kept, seen, "fingertips in line are not measured")
	rig.free_nodes()


func _push_tips(rig: Rig, time_s: float, tips: Array, scale: float = 1.0) -> void:
	var joints := {}
	for i in tips.size():
		joints[Rig.TIPS[i]] = scale * (tips[i] as Vector3)
	rig.tracker.push_frame(time_s, joints)


func _check_tracker_refuses(name: String, place: String) -> void:
	_messages = []
	var tracker := _make_tracker()
	var source := tracker.source as RecordedSource
	source.track = _path(name)
	tracker.failed.connect(func(message: String) -> void: _messages.append(message))
	check(tracker.start() != OK, "%s is refused" % name)
	check(not tracker.is_running(), "nothing runs")
	check(
		_messages.size() == 1 and _messages[0].contains(place),
		"one message that names %s: %s" % [place, _messages]
	)
	_write("good.csv", GOOD_TRACK)
	source.track = _path("good.csv")
	check_equal(tracker.start(), OK, "a good file is played after it")
	tracker.advance(1.0)
	check(tracker.is_finished(), "to its end")
	tracker.free()


func _make_tracker() -> HandTracker:
	var tracker := HandTracker.new()
	tracker.source = RecordedSource.new()
	tracker.update_mode = HandTracker.UPDATE_MANUAL
	tracker.autostart = false
	root.add_child(tracker)
	return tracker


func _make_script_rig() -> Rig:
	var trial := {
		gesture = "horizontal_drag",
		amplitude_m = 0.2,
		start = Vector3.ZERO,
		axis = Vector3.RIGHT,
	}
	var rig := Rig.new(trial, "", root)
	rig.tracker.source = ScriptSource.new()
	return rig


func _path(name: String) -> String:
	return _folder.get_current_dir().path_join(name)


func _write(name: String, text: String) -> void:
	FileAccess.open(_path(name), FileAccess.WRITE).store_string(text)
