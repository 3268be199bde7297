extends "support/scene_test.gd"
## Whole sessions: a simulated person's from end to end, and a pushed hand's as a person's.

const Columns := preload("res://study/study_columns.gd")
const Conditions := preload("res://scripts/conditions.gd")
const DesktopPanel := preload("res://study/desktop_questionnaire_panel.gd")
const StudyHand := preload("res://study/study_hand.gd")
const StudyScene := preload("res://study/study_scene.gd")
const StudyTrialLog := preload("res://study/study_trial_log.gd")
const StudyView := preload("res://study/study_view.gd")
const SyntheticHand := preload("res://study/synthetic_study_hand.gd")
const SyntheticPanel := preload("res://study/synthetic_questionnaire_panel.gd")
const ToolRun := preload("support/tool_run.gd")
const TrialRows := preload("support/trial_rows.gd")
const TrialRun := preload("res://tools/trial_run.gd")

const MOTION_COLUMNS := 10

var _root := DirAccess.create_temp("steadyhand_study_run").get_current_dir()


func test_a_simulated_session_writes_every_file() -> void:
	var session := _simulate("whole", "p01")
	check(session.is_complete(), "the session is complete")
	var rows := TrialRows.read(session.folder)
	check_equal(rows.size(), 18, "a row for each trial: 16 and 2 practice trials")
	for i in rows.size():
		var row := rows[i]
		var planned := session.trials[i]
		for column: String in ["trial", "gesture", "position", "condition", "repetition", "block"]:
			check_equal(row[column], str(planned[column]), "trial %d: %s" % [i + 1, column])
		check_equal(row["recognised"], planned["gesture"], "recognised")
		check_equal(row["reference"], "truth", "reference")
		check(row["onset_s"].to_float() > row["shown_s"].to_float(), "onset after the target")
		check(row["end_s"].to_float() > row["onset_s"].to_float(), "end after the onset")
		if planned["position"] == "stable":
			check(row["r2_synthesised"].to_float() > 0.98, "stable: R2 above 0.98")
			check_near(row["t_diff_synthesised"].to_float(), 0.0, 0.15, "stable: ends in time")
			var share: float = row["end_value_m"].to_float() / row["amplitude_m"].to_float()
			check_near(share, 1.0, 0.2, "stable: ends at the target")
		_check_motion(session, i + 1, row)
	_check_events(session)
	var answers := _read(session, "answers.csv")
	check_equal(answers.size(), 4 * 3, "three statements after every 4 trials")
	for answer in answers:
		check_equal(answer["origin"], "synthetic", "origin of an answer")
		check(answer["value"].to_int() in range(5), "a value on the scale")


func test_equal_seeds_give_equal_sessions() -> void:
	var first := _simulate("first", "p01")
	var second := _simulate("second", "p01")
	for name: String in ["trials.csv", "answers.csv"]:
		check_equal(_without_dates(second, name), _without_dates(first, name), name)
	for trial: int in [1, 7, 18]:
		var path := first.trial_path(trial, "motion")
		var other := FileAccess.get_file_as_string(second.trial_path(trial, "motion"))
		check(FileAccess.get_file_as_string(path) == other, "motion of trial %d" % trial)


## The figures of trials.csv are those that `evaluate` has for the same tracks.
func test_figures_equal_those_of_evaluate() -> void:
	var session := _simulate("figures", "p02")
	var models: Array[GestureModel] = []
	for gesture: String in ["horizontal_drag", "tap"]:
		models.append(load("res://addons/steadyhand/models/%s.gesture" % gesture))
	var rows := TrialRows.read(session.folder)
	for number: int in [2, 6, 11, 15]:
		var trial := _as_trial(session, number)
		var run := TrialRun.new(trial, root)
		run.sensor_latency_s = ClassDB.class_get_property_default_value(
			&"GestureHMM", &"sensor_latency"
		)
		run.run(
			session.trial_path(number, "frames"),
			session.trial_path(number, "reference"),
			models,
			GestureHMM.MODE_PHASE,
			true
		)
		check_equal(run.error, "", "trial %d can be evaluated" % number)
		for condition: String in ["measured", "average", "synthesised"]:
			var figures := run.figures[condition]
			for figure: String in ["r2", "lag"]:
				check_near(
					rows[number - 1]["%s_%s" % [figure, condition]].to_float(),
					figures[figure],
					0.002,
					"trial %d: %s of %s" % [number, figure, condition]
				)


func test_a_session_that_stops_goes_on_with_the_next_trial() -> void:
	var whole := _simulate("whole_again", "p03")
	var session := StudySession.new()
	session.start(_root.path_join("stops"), "p03", _protocol(), "synthetic")
	_make_steps(session, 9)
	var resumed := StudySession.new()
	check_equal(resumed.resume(_root.path_join("stops"), "p03"), OK, "it is unfinished")
	_make_steps(resumed, 1000)
	var rows := TrialRows.read(resumed.folder)
	check_equal(rows.size(), whole.trials.size(), "every trial once")
	var expected := TrialRows.read(whole.folder)
	for i in rows.size():
		check_equal(rows[i]["trial"], str(i + 1), "in order")
		check_near(
			rows[i]["r2_measured"].to_float(),
			expected[i]["r2_measured"].to_float(),
			1e-5,
			"the same trial as without a stop"
		)
	check_equal(rows[-1]["run"], "2", "by the second run")


func test_reference_span_is_found_in_its_curve() -> void:
	var curve := PackedFloat64Array()
	for i in 2001:
		var p := clampf((i - 500) / 800.0, 0.0, 1.0)
		curve.append(p * p * p * (10.0 - 15.0 * p + 6.0 * p * p))
	var span := StudyTrialLog.span_of(curve, 10.0)
	# A minimum-jerk motion is at 5 % after 0.189 of its time, at 99 % after 0.893.
	check_near(span["start_s"], 10.5 + 0.189 * 0.8, 0.002, "onset")
	check_near(span["end_s"], 10.5 + 0.893 * 0.8, 0.003, "end")


func test_a_person_is_led_through_a_session() -> void:
	var protocol := _protocol()
	protocol.gestures = ["horizontal_drag"]
	protocol.positions = ["stable"]
	protocol.practice_trials = 0
	protocol.rest_after_trials = 2
	protocol.rest_s = 0.05
	var session := StudySession.new()
	session.start(_root.path_join("person"), "ann", protocol, "person")
	var runner := StudyRunner.new()
	root.add_child(runner)
	runner.vibration_bus = &""
	runner.session = session
	var view := StudyView.new()
	root.add_child(view)
	view.follow(runner)
	var panel := DesktopPanel.new()
	var hand := StudyHand.new(ScriptSource.new())
	hand.tracker.update_mode = HandTracker.UPDATE_MANUAL
	check_equal(runner.begin(session, hand, panel), OK, "begun")
	var time_s := 1e-6 * Time.get_ticks_usec()
	var shown := PackedStringArray()
	var began_ms := Time.get_ticks_msec()
	while runner.state != StudyRunner.State.COMPLETE and Time.get_ticks_msec() - began_ms < 20000:
		if runner.state == StudyRunner.State.MAKING:
			time_s = _drag(runner, maxf(time_s, 1e-6 * Time.get_ticks_usec()))
		elif runner.state == StudyRunner.State.ASKING:
			panel.choose(1)
			panel.choose(3)
			panel.confirm()
			panel.skip_item()
			panel.choose(9)
			panel.confirm()
			panel.choose(0)
			panel.confirm()
		await process_frame
		shown.append_array(view.get_texts())
	check_equal(runner.state, StudyRunner.State.COMPLETE, "the session is complete")
	var text := " ".join(shown)
	check("Trial 4 of 4" in text, "the participant reads the number of the trial")
	for condition in Conditions.NAMES:
		check(not condition in text, "but not '%s'" % condition)
	runner.free()
	view.free()
	var rows := TrialRows.read(session.folder)
	check_equal(rows.size(), 4, "a row for each trial")
	for row in rows:
		check_equal(row["recognised"], "horizontal_drag", "recognised")
		check_equal(row["reference"], "", "no reference")
		check_equal(row["r2_measured"], "", "no figures")
		check_near(row["end_value_m"].to_float(), 0.2, 0.03, "where it ended")
	var answers := _read(session, "answers.csv")
	var values := answers.map(func(row: Dictionary) -> String: return row["value"])
	check_equal(values, ["3", "", "0"], "two answers and a skipped item")
	check_equal(answers[0]["changes"], "1", "changes of the first answer")
	check_equal(answers[1]["skipped"], "1", "skipped")


func test_a_persons_trial_is_compared_with_a_reference_sensor() -> void:
	var session := StudySession.new()
	session.start(_root.path_join("sensor"), "ann", _protocol(), "person")
	var runner := StudyRunner.new()
	root.add_child(runner)
	runner.vibration_bus = &""
	var hand := StudyHand.new(ScriptSource.new(), ScriptSource.new())
	hand.tracker.update_mode = HandTracker.UPDATE_MANUAL
	hand.reference.update_mode = HandTracker.UPDATE_MANUAL
	runner.begin(session, hand, DesktopPanel.new())
	# The reference sees the hand 30 ms earlier than the tracker, whose frames are held for 10 ms.
	_drag(runner, 1e-6 * Time.get_ticks_usec(), 0.03)
	var began_ms := Time.get_ticks_msec()
	while session.count_finished() == 0 and Time.get_ticks_msec() - began_ms < 20000:
		await process_frame
	runner.free()
	var row := TrialRows.read(session.folder)[0]
	check_equal(row["reference"], "sensor", "reference")
	check_near(row["lag_measured"].to_float(), 0.035, 0.003, "lag of the measured motion")
	check_near(row["t_diff_measured"].to_float(), -0.03, 0.006, "it ends later")
	check(row["r2_measured"].to_float() > 0.99, "R2 of the measured motion")


func test_a_trial_without_a_gesture_ends_at_its_limit() -> void:
	var protocol := _protocol()
	protocol.trial_limit_s = 0.1
	var session := StudySession.new()
	session.start(_root.path_join("limit"), "ann", protocol, "person")
	var runner := StudyRunner.new()
	root.add_child(runner)
	runner.vibration_bus = &""
	runner.begin(session, StudyHand.new(ScriptSource.new()), DesktopPanel.new())
	var began_ms := Time.get_ticks_msec()
	while session.count_finished() == 0 and Time.get_ticks_msec() - began_ms < 20000:
		await process_frame
	runner.free()
	var row := TrialRows.read(session.folder)[0]
	for column: String in ["recognised", "onset_s", "end_s", "end_value_m"]:
		check_equal(row[column], "", "no %s" % column)


func test_amplitudes_and_widths_reach_the_task() -> void:
	var protocol := _protocol()
	protocol.gestures = ["horizontal_drag", "vertical_drag", "tap", "zoom"]
	protocol.positions = ["stable"]
	protocol.conditions = ["synthesised"]
	protocol.practice_trials = 0
	protocol.amplitudes_m = [0.04, 0.06]
	protocol.widths_m = [0.005, 0.02]
	var session := StudySession.new()
	session.start(_root.path_join("widths"), "p01", protocol, "synthetic")
	_make_steps(session, 1000)
	var rows := TrialRows.read(session.folder)
	check_equal(rows.size(), 4 * 4 * 2, "a row for each trial")
	for i in rows.size():
		for column: String in ["amplitude_m", "width_m"]:
			var planned: float = session.trials[i][column]
			check_near(rows[i][column].to_float(), planned, 1e-5, "trial %d: %s" % [i + 1, column])


func test_the_study_scene_runs_a_session_with_the_mouse() -> void:
	# expects one error: Participant 'a b': an id must be
	var scene := (load("res://study/study_scene.tscn") as PackedScene).instantiate() as StudyScene
	scene.study_folder = _root.path_join("scene")
	root.add_child(scene)
	check(scene.run_session("a b") != OK, "a bad id is refused")
	check_equal(scene.run_session("p01"), OK, "a session starts")
	check_equal(scene.runner.state, StudyRunner.State.MAKING, "with a trial")
	check_equal(scene.session.origin, "mouse", "made with the mouse")
	var folder := scene.session.folder
	for key: Key in [KEY_P, KEY_P]:
		var event := InputEventKey.new()
		event.pressed = true
		event.keycode = key
		root.push_input(event)
		await process_frame
	check_equal(scene.runner.state, StudyRunner.State.MAKING, "P pauses and continues")
	scene.free()
	var again := StudySession.new()
	check_equal(again.resume(folder.get_base_dir().get_base_dir(), "p01"), OK, "it can be resumed")


func test_the_command_refuses_what_it_cannot_use() -> void:
	var out := _root.path_join("refused")
	var mistakes: Dictionary[String, PackedStringArray] = {
		"--out is missing": [],
		"--participants is '0'; it must be a number of participants": ["--participants", "0"],
		"--seed is 'x'; it must be a whole number": ["--seed", "x"],
		"this is no StudyProtocol": ["--protocol", out.path_join("none.tres")],
	}
	for said in mistakes:
		var arguments := mistakes[said].duplicate()
		if said != "--out is missing":
			arguments.append_array(["--out", out])
		var tool := ToolRun.new("study", arguments)
		check_equal(tool.exit_code, 2, "exit code with %s" % [mistakes[said]])
		check_equal(tool.not_said([said]), "", "the message")
	check(not DirAccess.dir_exists_absolute(out), "nothing is written")


func test_the_command_leaves_complete_sessions_alone() -> void:
	var protocol := _protocol()
	protocol.gestures = ["tap"]
	var path := _root.path_join("protocol.tres")
	check_equal(ResourceSaver.save(protocol, path), OK, "a protocol is saved")
	var out := _root.path_join("command")
	var arguments := ["--out", out, "--protocol", path, "--participants", "2", "--seed", "5"]
	var first := ToolRun.new("study", PackedStringArray(arguments))
	check_equal(first.exit_code, 0, "exit code")
	var table := FileAccess.get_file_as_string(out.path_join("sub-p02/ses-01/trials.csv"))
	check_equal(table.count("\n"), 10, "a header, 8 trials and a practice trial")
	arguments.append("--resume")
	var second := ToolRun.new("study", PackedStringArray(arguments))
	check_equal(second.exit_code, 0, "exit code with --resume")
	check_equal(second.not_said(["sub-p02/ses-01: complete"]), "", "it says so")
	var again := FileAccess.get_file_as_string(out.path_join("sub-p02/ses-01/trials.csv"))
	check_equal(again, table, "and changes nothing")
	check(not DirAccess.dir_exists_absolute(out.path_join("sub-p02/ses-02")), "no new session")


func test_a_pause_drops_the_trial_under_way() -> void:
	var session := StudySession.new()
	session.start(_root.path_join("pause"), "ann", _protocol(), "person")
	var runner := StudyRunner.new()
	root.add_child(runner)
	runner.vibration_bus = &""
	var hand := StudyHand.new(ScriptSource.new())
	hand.tracker.update_mode = HandTracker.UPDATE_MANUAL
	runner.begin(session, hand, DesktopPanel.new())
	check_equal(runner.state, StudyRunner.State.MAKING, "a trial is under way")
	runner.pause()
	check_equal(session.count_finished(), 0, "it does not count")
	runner.continue_run()
	check_equal(runner.trial["trial"], 1, "it is made again")
	runner.free()
	var events := _read(session, "events.csv").map(
		func(row: Dictionary) -> String: return row["event"]
	)
	check_equal(
		events,
		["run_started", "target_shown", "paused", "continued", "target_shown", "run_ended"],
		"events"
	)


func _simulate(study: String, id: String) -> StudySession:
	var session := StudySession.new()
	session.start(_root.path_join(study), id, _protocol(), "synthetic")
	_make_steps(session, 1000)
	return session


func _make_steps(session: StudySession, most: int) -> void:
	var runner := StudyRunner.new()
	runner.vibration_bus = &""
	root.add_child(runner)
	var panel := SyntheticPanel.new()
	panel.participant = session.participant
	runner.trial_ended.connect(
		func(_trial: Dictionary, figures: Dictionary) -> void: panel.remember(figures)
	)
	var hand := SyntheticHand.new()
	hand.subject = session.participant.to_int()
	runner.begin(session, hand, panel)
	for i in most:
		if not runner.step():
			break
	runner.free()


func _protocol() -> StudyProtocol:
	var protocol := StudyProtocol.paper()
	protocol.gestures = ["horizontal_drag", "tap"]
	protocol.conditions = ["measured", "synthesised"]
	protocol.trials_per_cell = 2
	protocol.block_size = 2
	protocol.practice_trials = 1
	protocol.rest_after_trials = 8
	protocol.rest_s = 10.0
	protocol.questionnaires[0] = protocol.questionnaires[0].duplicate()
	protocol.questionnaires[0].after_trials = 4
	protocol.order = StudyProtocol.Order.FIXED
	return protocol


## Pushes a drag along the task, and a rest; the time of its last frame.
## `ahead_s`: how much earlier the reference sees it, where there is one.
func _drag(runner: StudyRunner, from_s: float, ahead_s: float = 0.0) -> float:
	var task := runner.task_scene.task
	var time_s := from_s
	for frame in 330:
		time_s += 0.01
		var seen := {HandTracker.JOINT_INDEX: _place(task, time_s - from_s, time_s)}
		var before := {HandTracker.JOINT_INDEX: _place(task, time_s - from_s + ahead_s, time_s)}
		if runner.hand.reference != null:
			runner.hand.reference.push_frame(time_s, before)
		runner.hand.tracker.push_frame(time_s, seen)
	return time_s


func _place(task: GestureTask, passed_s: float, time_s: float) -> Vector3:
	var p := clampf((passed_s - 1.0) / 0.8, 0.0, 1.0)
	var way := task.amplitude * p * p * p * (10.0 - 15.0 * p + 6.0 * p * p)
	var tremor := 1e-4 * Vector3(sin(55.0 * time_s), sin(62.0 * time_s), sin(71.0 * time_s))
	return task.get_start() + task.get_axis() * way + tremor


func _check_motion(session: StudySession, trial: int, row: Dictionary) -> void:
	var path := session.trial_path(trial, "motion")
	var lines := FileAccess.get_file_as_string(path).split("\n", false)
	check_equal(lines[0], StudyTrialLog.HEADER, "trial %d: columns of motion.csv" % trial)
	var first := lines[1].split(",")
	var last := lines[-1].split(",")
	check_equal(first.size(), MOTION_COLUMNS, "cells")
	check_near(first[0].to_float(), row["shown_s"].to_float(), 0.02, "from the target on")
	check(last[0].to_float() > row["end_s"].to_float(), "to after the end")
	var passed_ms := roundi(1000.0 * (last[0].to_float() - first[0].to_float()))
	check_equal(lines.size() - 2, passed_ms, "a row each millisecond")
	var farthest := 0.0
	for line in lines.slice(1):
		farthest = maxf(farthest, line.get_slice(",", 6).to_float())
	check(farthest >= 0.8 * row["amplitude_m"].to_float(), "the reference gets near the target")
	for kind: String in ["frames", "reference"]:
		var track := FileAccess.get_file_as_string(session.trial_path(trial, kind))
		check(track.count("\n") > 100, "%s of it" % kind)


func _check_events(session: StudySession) -> void:
	var counts := {}
	for row in _read(session, "events.csv"):
		counts[row["event"]] = counts.get(row["event"], 0) + 1
	check_equal(counts["run_started"], 1, "event run_started")
	check_equal(counts["run_ended"], 1, "event run_ended")
	check_equal(counts["target_shown"], 18, "event target_shown")
	check_equal(counts["end"], 18, "event end")
	check_equal(counts["rest_started"], 1, "event rest_started")
	check_equal(counts["questionnaire_shown"], 4, "event questionnaire_shown")
	check_equal(counts["answered"], 12, "event answered")


## The trial as a row of a trial set. Its span is found anew from the plan's simulated person.
func _as_trial(session: StudySession, number: int) -> Dictionary:
	var hand := SyntheticHand.new()
	hand.subject = session.participant.to_int()
	root.add_child(hand)
	hand.open(session.participant)
	var task := GestureTask.new()
	root.add_child(task)
	var span := hand.prepare(session.trials[number - 1], task)
	var reference := RecordedSource.new()
	reference.track = session.trial_path(number, "reference")
	var tracker := HandTracker.new()
	tracker.source = reference
	tracker.start()
	# Spans of a fresh hand differ from the session's by a whole number of seconds.
	var offset := roundf(tracker.get_start_time() - hand.now_s())
	var trial := {
		trial = "study_%d" % number,
		gesture = String(task.gesture),
		position = session.trials[number - 1]["position"],
		subject = session.participant,
		start_s = span["start_s"] + offset,
		end_s = span["end_s"] + offset,
		start = task.get_start(),
		axis = task.get_axis(),
		amplitude_m = task.amplitude,
	}
	for node: Node in [tracker, task, hand]:
		node.free()
	return trial


func _read(session: StudySession, name: String) -> Array[Dictionary]:
	var file := FileAccess.open(session.folder.path_join(name), FileAccess.READ)
	var header := file.get_csv_line()
	var rows: Array[Dictionary] = []
	while file.get_position() < file.get_length():
		var cells := file.get_csv_line()
		var row := {}
		for i in header.size():
			row[header[i]] = cells[i]
		rows.append(row)
	return rows


func _without_dates(session: StudySession, name: String) -> Array[Dictionary]:
	var rows := _read(session, name)
	for row in rows:
		row.erase("finished")
	return rows
