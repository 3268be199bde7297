extends "support/scene_test.gd"
## Values that no node can use get one error each, and files with a clock jump one warning.

const Rig := preload("support/rig.gd")

const TRIAL := {
	gesture = "horizontal_drag", amplitude_m = 0.2, start = Vector3.ZERO, axis = Vector3.RIGHT
}

var _folder := DirAccess.create_temp("steadyhand_bad_values")


func test_a_curve_of_too_many_samples_is_refused() -> void:
	# expects one error: count must be in 0..30000000, is 2147483647
	# expects one error: count must be in 0..30000000, is -1
	# expects one error: rate_hz must be above 0 and t0 finite
	var path := _write("one.csv", "t,index_x,index_y,index_z\n0,0,0,0\n")
	check_equal(_curve_size(path, 0.0, 2147483647), 0, "two thousand million samples are refused")
	check_equal(_curve_size(path, 0.0, -1), 0, "a negative count is refused")
	check_equal(_curve_size(path, NAN, 10), 0, "a start that is no number is refused")
	check_equal(_curve_size(path, 0.0, 10), 10, "ten samples are given")


func test_a_table_of_too_many_names_is_refused() -> void:
	# expects one error: more than 1000 different names
	var names := PackedStringArray()
	for i in 1001:
		names.append("gesture %d" % i)
	check(MotionMetrics.confusion(names, names).is_empty(), "1001 names are refused")
	names.resize(1000)
	check_equal(MotionMetrics.confusion(names, names).size(), 1000, "1000 names are counted")


func test_a_synthetic_set_that_fits_no_memory_is_refused() -> void:
	# expects one error: more than 100000 trials
	# expects one error: a trial would last longer than 3600 s
	for options: Dictionary in [
		{subjects = 10000, trials_per_subject = 10000},
		{duration = 3600.0, earlier_rounds = 100},
	]:
		var refused := TrialSet.write_synthetic(_path("too_large"), options)
		check_equal(refused, ERR_INVALID_PARAMETER, "%s is refused" % options)
	check(not DirAccess.dir_exists_absolute(_path("too_large")), "nothing is written")


func test_a_model_named_none_is_refused() -> void:
	# expects one error: gesture: 'none' stands for no gesture in results; choose another name
	var model := load(Rig.MODEL % "horizontal_drag") as GestureModel
	var text := model.to_text().replace('"horizontal_drag"', '"none"')
	var copy := GestureModel.new()
	check(copy.parse_text(text) != OK, "the model is refused")
	check_equal(copy.to_text(), "", "the resource stays empty")


func test_training_of_none_is_refused() -> void:
	# expects one error: GestureTrainer: the gesture's name 'none' stands for no gesture in results
	var trials := Rig.write_trials(_path("trials"))
	check(GestureTrainer.new().train(trials, "none") == null, "training gives no model")


func test_a_far_task_is_not_used() -> void:
	# expects one warning: its global position is not finite, or beyond 1e9 m
	var gesture_hmm := GestureHMM.new()
	var task := GestureTask.new()
	task.gesture = "horizontal_drag"
	task.direction = Vector3.FORWARD
	task.position = Vector3(1e30, 0, 0)
	gesture_hmm.models = [load(Rig.MODEL % "horizontal_drag") as GestureModel]
	gesture_hmm.tracker = HandTracker.new()
	gesture_hmm.tracker.source = ScriptSource.new()
	gesture_hmm.tracker.update_mode = HandTracker.UPDATE_MANUAL
	gesture_hmm.task = task
	for node: Node in [gesture_hmm.tracker, task, gesture_hmm]:
		root.add_child(node)
	await process_frame
	gesture_hmm.tracker.start()
	for i in 20:
		gesture_hmm.tracker.push_frame(0.01 * i, {HandTracker.JOINT_INDEX: Vector3(0.01 * i, 0, 0)})
	check_equal(gesture_hmm.value, 0.0, "the output stays 0")
	for node: Node in [gesture_hmm, task, gesture_hmm.tracker]:
		node.queue_free()
	await process_frame


func test_numbers_that_are_no_enumerators_are_refused() -> void:
	# expects error: mode must be MODE_PHASE or MODE_PAPER, is
	# expects error: quality must be one of QUALITY_*, is
	# expects error: : motion must be one of MOTION_*, is
	# expects error: get_motion_value: motion must be one of MOTION_*, is
	# expects error: CustomEffect: drive must be one of DRIVE_*, is
	# expects error: CustomEffect: trigger must be one of TRIGGER_*, is
	var gesture_hmm := GestureHMM.new()
	var effect := CustomEffect.new()
	for number: int in [-1, 5, 255, 1 << 31, 1 << 32, (1 << 63) - 1, -(1 << 63)]:
		for property: String in ["mode", "quality", "motion"]:
			_check_keeps(gesture_hmm, property, number)
		for property: String in ["drive", "trigger"]:
			_check_keeps(effect, property, number)
		check_equal(
			gesture_hmm.call("get_motion_value", number), 0.0, "motion %d has no value" % number
		)
	gesture_hmm.free()


func test_a_confidence_out_of_range_is_limited_with_a_warning_per_run() -> void:
	# expects one warning: push_frame: confidence must be 0..1, is 100.0; 1.0 is used
	# expects one warning: push_frame: confidence must be 0..1, is nan; 0.0 is used
	var tracker := HandTracker.new()
	tracker.source = ScriptSource.new()
	tracker.update_mode = HandTracker.UPDATE_MANUAL
	root.add_child(tracker)
	var received := PackedFloat64Array()
	tracker.frame_received.connect(
		func(frame: HandFrame) -> void: received.append(frame.confidence)
	)
	for run: PackedFloat64Array in [[0.7, 100.0, 100.0, NAN], [1.0, 0.0, NAN, -INF]]:
		tracker.start()
		for i in run.size():
			var joints := {HandTracker.JOINT_INDEX: Vector3.ONE}
			check_equal(tracker.push_frame(0.01 * i, joints, run[i]), OK, "%s is taken" % run[i])
	var limited := PackedFloat64Array([0.7, 1.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0])
	check_equal(received, limited, "the frames have")
	tracker.free()


func test_a_clock_jump_is_closed_up() -> void:
	# expects one warning: jump.csv:4: t: the clock jumps by 200000 s
	var text := "t,index_x,index_y,index_z\n0,0,0,0\n0.1,0,0,0\n200000.1,0,0,0\n200000.2,1,0,0\n"
	var source := RecordedSource.new()
	source.track = _write("jump.csv", text)
	var tracker := HandTracker.new()
	tracker.source = source
	tracker.update_mode = HandTracker.UPDATE_MANUAL
	tracker.autostart = false
	root.add_child(tracker)
	tracker.start()
	tracker.advance(0.35)
	check_equal(
		tracker.get_joint_position(HandTracker.JOINT_INDEX), Vector3.RIGHT, "the last row is played"
	)
	tracker.free()


func _curve_size(path: String, t0_s: float, count: int) -> int:
	var track := RecordedTrack.load_file(path)
	return MotionMetrics.feature_curve(track, "index_along_axis", TRIAL, t0_s, 1000.0, count).size()


func _check_keeps(object: Object, property: String, number: int) -> void:
	var before: int = object.get(property)
	object.set(property, number)
	check_equal(object.get(property), before, "%s = %d is refused" % [property, number])


func _path(name: String) -> String:
	return _folder.get_current_dir().path_join(name)


func _write(name: String, text: String) -> String:
	FileAccess.open(_path(name), FileAccess.WRITE).store_string(text)
	return _path(name)
