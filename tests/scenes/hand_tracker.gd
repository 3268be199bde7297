extends "support/scene_test.gd"
## Sources of frames: recordings, scripts, synthetic people.

const TRACK := """# origin: test
t,index_x,index_y,index_z,confidence
1.0,0.01,0.02,-0.3,1
1.01,0.02,0.02,-0.3,1
1.02,,,,0
1.5,,,,0
1.51,0.05,0.02,-0.3,0.9
"""

var _folder := DirAccess.create_temp("steadyhand_tracker")
var _stamps: Array[float] = []
var _events: Array[String] = []


func test_recorded_source_plays_frames_and_signals() -> void:
	var tracker := _make_tracker(_recording(_write("track.csv", TRACK)))
	check_equal(tracker.start(), OK, "a recording starts")
	check_equal(tracker.get_start_time(), 1.0, "the clock starts with the first frame")
	check_near(tracker.get_duration(), 0.51, 1e-12, "duration")
	tracker.advance_to(1.015)
	check_equal(_stamps, [1.0, 1.01] as Array[float], "only frames up to this time")
	check_equal(tracker.get_time(), 1.015, "the clock is at that time")
	check(tracker.is_joint_tracked(HandTracker.JOINT_INDEX), "the index tip is tracked")
	check(not tracker.is_joint_tracked(HandTracker.JOINT_THUMB), "the thumb is not")
	check_equal(
		tracker.get_joint_position(HandTracker.JOINT_INDEX),
		Vector3(0.02, 0.02, -0.3),
		"the last frame's position"
	)
	tracker.advance(0.4)
	check(not tracker.is_joint_tracked(HandTracker.JOINT_INDEX), "an empty cell: not tracked")
	tracker.advance(1.0)
	check_equal(_stamps.size(), 5, "all frames came")
	check(tracker.is_finished(), "finished")
	check_equal(
		_events,
		["found", "lost", "found", "lost", "finished"] as Array[String],
		"found, lost, finished"
	)
	tracker.free()


func test_a_recording_that_was_cut_off_is_played_to_the_cut() -> void:
	var cut := TRACK.substr(0, TRACK.length() - 10)
	var tracker := _make_tracker(_recording(_write("track.csv", cut)))
	# expects warning: this last row is cut off and left out. The 4 rows before it are read
	check_equal(tracker.start(), OK, "it starts")
	tracker.advance(5.0)
	check_equal(_stamps, [1.0, 1.01, 1.02, 1.5] as Array[float], "its whole rows")
	tracker.free()


func test_frames_once_over_step_sizes() -> void:
	for step_s: float in [0.001, 0.007, 0.3, 5.0]:
		var tracker := _make_tracker(_recording(_write("track.csv", TRACK)))
		tracker.start()
		while not tracker.is_finished():
			tracker.advance(step_s)
		check_equal(_stamps, [1.0, 1.01, 1.02, 1.5, 1.51] as Array[float], "steps of %s s" % step_s)
		tracker.free()


func test_loop_never_goes_back_in_time() -> void:
	var source := _recording(_write("track.csv", TRACK))
	source.loop = true
	var tracker := _make_tracker(source)
	tracker.start()
	tracker.advance(2.0)
	var is_rising := true
	for i in range(1, _stamps.size()):
		is_rising = is_rising and _stamps[i] > _stamps[i - 1]
	check(_stamps.size() >= 15 and is_rising, "loops follow each other in time")
	check(not tracker.is_finished(), "a loop does not finish")
	tracker.free()


func test_the_loop_setting_is_read_at_the_start() -> void:
	var source := _recording(_write("track.csv", TRACK))
	var tracker := _make_tracker(source)
	tracker.start()
	source.loop = true
	tracker.advance(4000.0)
	check(tracker.is_finished(), "a track started without a loop ends")
	tracker.start()
	source.loop = false
	# expects error: advance() moves a looped track by at most an hour
	tracker.advance(1e9)
	check_equal(tracker.get_time(), 1.0, "a track started in a loop stays in it")
	tracker.free()


func test_script_source() -> void:
	var tracker := _make_tracker(ScriptSource.new())
	tracker.start()
	var tip := Vector3(0.1, 0.2, -0.3)
	tracker.push_frame(10.0, {HandTracker.JOINT_INDEX: tip})
	tracker.push_frame(10.02, {HandTracker.JOINT_INDEX: tip * 2.0})
	check_equal(_stamps, [10.0, 10.02] as Array[float], "each pushed frame is received")
	check_equal(tracker.get_joint_position(HandTracker.JOINT_INDEX), tip * 2.0, "its position")
	check_equal(tracker.get_time(), 10.02, "the clock is the last stamp")
	tracker.advance(0.5)
	check_near(tracker.get_time(), 10.52, 1e-12, "the clock is the time of advance_to()")
	check_equal(_events, ["found", "lost"] as Array[String], "a hand without frames is lost")
	check(tracker.is_joint_tracked(HandTracker.JOINT_INDEX), "the last frame has the index tip")
	tracker.stop()
	check(not tracker.is_joint_tracked(HandTracker.JOINT_INDEX), "not after the tracker is stopped")
	tracker.free()


func test_frames_of_wrong_units_are_warned_of_once() -> void:
	# expects one warning: the hand moves, but the time does not
	# expects one warning: Give times in seconds
	# expects one warning: Give positions in metres
	for scale: Vector2 in [Vector2(0.0, 1.0), Vector2(1000.0, 1.0), Vector2(1.0, 1000.0)]:
		var tracker := _make_tracker(ScriptSource.new())
		tracker.start()
		for frame in 200:
			var time := frame / 90.0
			var tip := Vector3(0.1 * sin(2.0 * time), 1.0, -0.3)
			tracker.push_frame(scale.x * time, {HandTracker.JOINT_INDEX: scale.y * tip})
		tracker.free()


func test_synthetic_source() -> void:
	var counts: Array[int] = []
	var positions: Array[Vector3] = []
	for seed: int in [1, 1, 2]:
		var source := SyntheticSource.new()
		source.seed = seed
		var tracker := _make_tracker(source)
		check_equal(tracker.start(), OK, "synthetic person %d starts" % seed)
		tracker.advance(1.5)
		counts.append(_stamps.size())
		positions.append(tracker.get_joint_position(HandTracker.JOINT_INDEX))
		tracker.free()
	check(counts[0] > 50, "frames come at a camera's rate")
	check_equal(positions[0], positions[1], "one seed, one motion")
	check(positions[0] != positions[2], "another seed, another motion")


func test_plays_by_itself() -> void:
	var tracker := _make_tracker(_recording(_write("track.csv", TRACK)))
	tracker.update_mode = HandTracker.UPDATE_IDLE
	tracker.start()
	var began_ms := Time.get_ticks_msec()
	while not tracker.is_finished() and Time.get_ticks_msec() - began_ms < 5000:
		await process_frame
	check(tracker.is_finished(), "the playback ends without manual steps")
	check_equal(_stamps.size(), 5, "all frames came")
	tracker.free()


func test_a_tracker_records_its_frames() -> void:
	var tracker := _make_tracker(SyntheticSource.new())
	var copy_path := _folder.get_current_dir().path_join("copy.csv")
	check_equal(tracker.start_recording(copy_path), OK, "a recording begins")
	var positions := _collect_positions(tracker)
	tracker.start()
	while not tracker.is_finished():
		tracker.advance(0.004)
	tracker.stop_recording()
	var stamps := _stamps
	tracker.free()

	var copy := _make_tracker(_recording(copy_path))
	var copied_positions := _collect_positions(copy)
	copy.start()
	copy.advance(100.0)
	check(stamps.size() > 100 and _stamps == stamps, "the copy has the same stamps")
	check(copied_positions == positions, "the copy has the same positions")
	copy.free()


func test_a_played_recording_is_not_overwritten() -> void:
	var path := _write("track.csv", TRACK)
	var source := RecordedSource.new()
	source.track = path
	var tracker := _make_tracker(source)
	var folder := path.get_base_dir()
	# expects error: track.csv. Record to another file
	check_equal(tracker.start_recording(path), ERR_FILE_ALREADY_IN_USE, "refused before the start")
	tracker.start()
	source.track = folder.path_join("other.csv")
	var by_another_name := folder.path_join("../%s/./track.csv" % folder.get_file())
	check_equal(tracker.start_recording(by_another_name), ERR_FILE_ALREADY_IN_USE, "while it plays")
	check_equal(FileAccess.get_file_as_string(path), TRACK, "the file is as it was")
	tracker.stop()
	check_equal(tracker.start_recording(path), OK, "allowed once it is no longer played")
	tracker.free()


func test_two_trackers_do_not_record_to_one_file() -> void:
	var path := _folder.get_current_dir().path_join("both.csv")
	var by_another_name := path.get_base_dir().path_join("./both.csv")
	var trackers: Array[HandTracker] = []
	for name: String in ["Left", "Right"]:
		trackers.append(_make_tracker(ScriptSource.new()))
		trackers[-1].name = name
		trackers[-1].start()
	var left := trackers[0]
	var right := trackers[1]
	check_equal(left.start_recording(path), OK, "one records")
	# expects one error: /Right':
	# expects one error: both.csv is being written by HandTracker '
	# expects one error: /Left'. Give each a file of its own
	check_equal(right.start_recording(by_another_name), ERR_FILE_ALREADY_IN_USE, "the other not")
	for i in 3:
		for tracker in trackers:
			tracker.push_frame(i, {HandTracker.JOINT_INDEX: Vector3.ONE})
	left.stop_recording()
	var rows := FileAccess.get_file_as_string(path).split("\n", false)
	check_equal(rows.size(), 5, "all rows of the first recording are there, below two header lines")
	check_equal(right.start_recording(path), OK, "the file can be used after the recording")
	left.free()
	right.free()


## Filled as frames come.
func _collect_positions(tracker: HandTracker) -> Array[Vector3]:
	var positions: Array[Vector3] = []
	tracker.frame_received.connect(
		func(_frame: HandFrame) -> void:
			positions.append(tracker.get_joint_position(HandTracker.JOINT_INDEX))
	)
	return positions


func _make_tracker(source: HandSource) -> HandTracker:
	_stamps = []
	_events = []
	var tracker := HandTracker.new()
	tracker.source = source
	tracker.autostart = false
	tracker.update_mode = HandTracker.UPDATE_MANUAL
	tracker.frame_received.connect(func(frame: HandFrame) -> void: _stamps.append(frame.time))
	tracker.tracking_restored.connect(func() -> void: _events.append("found"))
	tracker.tracking_lost.connect(func() -> void: _events.append("lost"))
	tracker.finished.connect(func() -> void: _events.append("finished"))
	root.add_child(tracker)
	return tracker


func _recording(path: String) -> RecordedSource:
	var source := RecordedSource.new()
	source.track = path
	return source


func _write(name: String, text: String) -> String:
	var path := _folder.get_current_dir().path_join(name)
	FileAccess.open(path, FileAccess.WRITE).store_string(text)
	return path
