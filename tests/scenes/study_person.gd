extends "support/scene_test.gd"
## A person's session: trials, questions, pauses, a reference sensor, the scene.

const Conditions := preload("res://scripts/conditions.gd")
const DesktopPanel := preload("res://study/desktop_questionnaire_panel.gd")
const PushedHand := preload("support/pushed_hand.gd")
const StudyHand := preload("res://study/study_hand.gd")
const StudyScene := preload("res://study/study_scene.gd")
const StudySupport := preload("support/study_support.gd")
const StudyView := preload("res://study/study_view.gd")
const TrialRows := preload("support/trial_rows.gd")

const STUDY_SCENE := "res://study/study_scene.tscn"
## A device's clock: seconds since 1970.
const DEVICE_S := 1.7e9

var _folder := DirAccess.create_temp("steadyhand_study_person")
var _root := _folder.get_current_dir()


func test_a_person_is_led_through_a_session() -> void:
	var protocol := StudySupport.protocol()
	protocol.gestures = ["horizontal_drag"]
	protocol.positions = ["stable"]
	protocol.practice_trials = 0
	protocol.rest_after_trials = 2
	protocol.rest_s = 0.05
	var panel := DesktopPanel.new()
	var runner := await _begin("person", protocol, StudyHand.new(ScriptSource.new()), panel)
	var session := runner.session
	var view := StudyView.new()
	root.add_child(view)
	view.follow(runner)
	var shown := PackedStringArray()
	var began_ms := Time.get_ticks_msec()
	while runner.state != StudyRunner.State.COMPLETE and Time.get_ticks_msec() - began_ms < 20000:
		if runner.state == StudyRunner.State.MAKING:
			_drag(runner)
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
	var answers := StudySupport.read(session, "answers.csv")
	var values := answers.map(func(row: Dictionary) -> String: return row["value"])
	check_equal(values, ["3", "", "0"], "two answers and a skipped item")
	check_equal(answers[0]["changes"], "1", "changes of the first answer")
	check_equal(answers[1]["skipped"], "1", "skipped")


func test_a_persons_trial_is_compared_with_a_reference_sensor() -> void:
	var hand := StudyHand.new(ScriptSource.new(), ScriptSource.new())
	var runner := await _begin("sensor", StudySupport.protocol(), hand)
	var session := runner.session
	# The reference sees the hand 30 ms earlier than the tracker, whose frames are held for 10 ms.
	_drag(runner, 0.03)
	await _wait_for_trial(session, 1)
	runner.free()
	var row := TrialRows.read(session.folder)[0]
	check_equal(row["reference"], "sensor", "reference")
	check_near(row["lag_measured"].to_float(), 0.035, 0.003, "lag of the measured motion")
	check_near(row["t_diff_measured"].to_float(), -0.03, 0.006, "it ends later")
	check(row["r2_measured"].to_float() > 0.99, "R2 of the measured motion")


func test_the_return_before_a_trial_does_not_count_in_its_figures() -> void:
	var protocol := StudySupport.protocol()
	protocol.gestures = ["horizontal_drag"]
	protocol.practice_trials = 0
	protocol.questionnaires = []
	var hand := StudyHand.new(ScriptSource.new(), ScriptSource.new())
	var runner := await _begin("return", protocol, hand)
	var session := runner.session
	for trial: int in [1, 2]:
		# The hand is still at the target of the trial before.
		_drag(runner, 0.03, trial > 1)
		await _wait_for_trial(session, trial)
	runner.free()
	for row in TrialRows.read(session.folder):
		check_near(row["lag_measured"].to_float(), 0.035, 0.003, "trial %s: lag" % row["trial"])
		check_near(row["t_diff_measured"].to_float(), -0.03, 0.006, "it ends later")
		check(row["r2_measured"].to_float() > 0.99, "R2 of the measured motion")
		check(row["r2_zero_measured"].to_float() > 0.97, "zero-lag R2")


func test_a_session_waits_for_the_first_frame() -> void:
	var session := StudySession.new()
	session.start(_root.path_join("waits"), "ann", StudySupport.protocol(), "person")
	var runner := StudyRunner.new()
	root.add_child(runner)
	runner.vibration_bus = &""
	var view := StudyView.new()
	root.add_child(view)
	runner.session = session
	view.follow(runner)
	runner.begin(session, StudyHand.new(ScriptSource.new()), DesktopPanel.new())
	runner.pause()
	await process_frame
	check_equal(runner.state, StudyRunner.State.WAITING, "no trial before the first frame")
	check("first frame" in view.get_texts()[1], "the participant reads why")
	runner.free()
	view.free()
	check_equal(StudySupport.read(session, "events.csv"), [], "no event without a clock")


func test_times_of_a_run_are_on_the_clock_of_its_frames() -> void:
	var hand := StudyHand.new(ScriptSource.new())
	var runner := await _begin("clock", StudySupport.protocol(), hand)
	var session := runner.session
	var begin_s := hand.now_s()
	for frame in 330:
		var passed_s := 0.01 * frame
		var time_s := maxf(begin_s + passed_s, hand.tracker.get_time())
		var joints := {HandTracker.JOINT_INDEX: _place(runner.task_scene.task, passed_s, time_s)}
		hand.tracker.push_frame(time_s, joints)
		if runner.state == StudyRunner.State.ENDING:
			await process_frame
		if session.count_finished() > 0:
			break
	runner.free()
	var row := TrialRows.read(session.folder)[0]
	var shown_s: float = row["shown_s"].to_float()
	check(shown_s > DEVICE_S and shown_s < begin_s, "the target is shown")
	check_near(row["onset_s"].to_float() - begin_s, 1.15, 0.15, "the onset comes after it")
	check_near(row["end_s"].to_float() - begin_s, 1.75, 0.15, "the end")
	var motion := FileAccess.get_file_as_string(session.trial_path(1, "motion"))
	var recorded_s: float = motion.split("\n", false)[-1].to_float() - row["end_s"].to_float()
	check_near(recorded_s, StudyRunner.AFTER_S, 0.03, "recording continues after the end")
	var events := StudySupport.read(session, "events.csv")
	for i in range(1, events.size()):
		var step_s: float = events[i]["t_s"].to_float() - events[i - 1]["t_s"].to_float()
		check(step_s >= 0.0 and step_s < 3.0, "%s comes in time" % events[i]["event"])


func test_a_trial_ends_though_its_tracker_falls_silent() -> void:
	var runner := await _begin("silent", StudySupport.protocol(), StudyHand.new(ScriptSource.new()))
	var session := runner.session
	_drag(runner, 0.0, false, StudyRunner.State.ENDING)
	check_equal(runner.state, StudyRunner.State.ENDING, "the gesture has ended")
	await _wait_for_trial(session, 1)
	runner.free()
	check_equal(session.count_finished(), 1, "the trial too")


func test_a_trial_without_a_gesture_ends_at_its_limit() -> void:
	var protocol := StudySupport.protocol()
	protocol.trial_limit_s = 0.1
	var runner := await _begin("limit", protocol, StudyHand.new(ScriptSource.new()))
	var session := runner.session
	await _wait_for_trial(session, 1)
	runner.free()
	var row := TrialRows.read(session.folder)[0]
	for column: String in ["recognised", "onset_s", "end_s", "end_value_m"]:
		check_equal(row[column], "", "no %s" % column)


func test_the_study_scene_runs_a_session_with_the_mouse() -> void:
	# expects one error: Participant 'a b': an id must be
	var scene := (load(STUDY_SCENE) as PackedScene).instantiate() as StudyScene
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
	check_equal(
		again.resume(folder.get_base_dir().get_base_dir(), "p01", "mouse"), OK, "it can be resumed"
	)


func test_the_origin_of_a_session_is_that_of_its_source() -> void:
	var degraded := DegradedSource.new()
	degraded.source = SyntheticSource.new()
	var origins: Dictionary[HandSource, String] = {
		XRSource.new(): "person",
		SyntheticSource.new(): "synthetic",
		degraded: "synthetic",
		RecordedSource.new(): "replay",
		MouseSource.new(): "mouse",
	}
	for source in origins:
		var hand := StudyHand.new(source)
		check_equal(hand.origin, origins[source], "origin with a %s" % source.get_class())
		hand.free()
	var scene := (load(STUDY_SCENE) as PackedScene).instantiate() as StudyScene
	scene.study_folder = _root.path_join("origin")
	scene.source = degraded
	root.add_child(scene)
	check_equal(scene.run_session("p01"), OK, "a session starts")
	var file := FileAccess.get_file_as_string(scene.session.folder.path_join("session.json"))
	check_equal(JSON.parse_string(file)["origin"], "synthetic", "origin in session.json")
	scene.free()


func test_a_study_name_in_other_case_is_refused() -> void:
	# expects one error: Study 'Pilot': there is 'pilot' already. Choose another 'study_name'
	var scene := (load(STUDY_SCENE) as PackedScene).instantiate() as StudyScene
	scene.study_folder = _root.path_join("names")
	scene.protocol = StudySupport.protocol()
	scene.protocol.study_name = "Pilot"
	DirAccess.make_dir_recursive_absolute(scene.study_folder.path_join("pilot"))
	root.add_child(scene)
	check(scene.run_session("p01") != OK, "Pilot beside pilot")
	check_equal(DirAccess.get_directories_at(scene.study_folder).size(), 1, "nothing is written")
	scene.free()


func test_a_pause_drops_the_current_trial() -> void:
	var runner := await _begin("pause", StudySupport.protocol(), StudyHand.new(ScriptSource.new()))
	var session := runner.session
	check_equal(runner.state, StudyRunner.State.MAKING, "a trial is running")
	runner.pause()
	check_equal(session.count_finished(), 0, "it does not count")
	runner.continue_run()
	check_equal(runner.trial["trial"], 1, "it is made again")
	runner.free()
	var events := StudySupport.read(session, "events.csv").map(
		func(row: Dictionary) -> String: return row["event"]
	)
	check_equal(
		events,
		["run_started", "target_shown", "paused", "continued", "target_shown", "run_ended"],
		"events"
	)


func test_a_rest_continues_after_a_pause() -> void:
	var protocol := StudySupport.protocol()
	protocol.practice_trials = 0
	protocol.trial_limit_s = 0.1
	protocol.rest_after_trials = 1
	protocol.questionnaires = []
	var runner := await _begin("rest", protocol, StudyHand.new(ScriptSource.new()))
	var session := runner.session
	await _wait_for_trial(session, 1)
	check_equal(runner.state, StudyRunner.State.RESTING, "a rest comes after the trial")
	await create_timer(0.1).timeout
	var left_s := runner.get_rest_left()
	check(left_s < protocol.rest_s and left_s > 0.0, "a part of it has passed")
	runner.pause()
	await create_timer(0.1).timeout
	runner.continue_run()
	check_equal(runner.state, StudyRunner.State.RESTING, "the rest continues")
	check_equal(runner.get_rest_left(), left_s, "the pause does not count")
	runner.skip()
	await process_frame
	await process_frame
	check_equal(runner.trial["trial"], 2, "the next trial comes after it")
	runner.free()
	var events := StudySupport.read(session, "events.csv").map(
		func(row: Dictionary) -> String: return row["event"]
	)
	check_equal(
		events.slice(2, 7),
		["rest_started", "paused", "continued", "rest_ended", "target_shown"],
		"events"
	)


## A session whose hand has sent its first frame.
func _begin(
	study: String,
	protocol: StudyProtocol,
	hand: StudyHand,
	panel: QuestionnairePanel = DesktopPanel.new()
) -> StudyRunner:
	var session := StudySession.new()
	session.start(_root.path_join(study), "ann", protocol, "person")
	var runner := StudyRunner.new()
	root.add_child(runner)
	runner.vibration_bus = &""
	check_equal(runner.begin(session, hand, panel), OK, "begun")
	hand.tracker.push_frame(DEVICE_S, {})
	await process_frame
	return runner


func _wait_for_trial(session: StudySession, trial: int) -> void:
	var began_ms := Time.get_ticks_msec()
	while session.count_finished() < trial and Time.get_ticks_msec() - began_ms < 20000:
		await process_frame


## Pushes a drag along the task, and a rest, all at once.
## `ahead_s`: how much earlier the reference sees it, where there is one.
## `returns`: the hand first returns from the target.
## `last_state`: no frame comes after the runner has entered it.
func _drag(
	runner: StudyRunner,
	ahead_s: float = 0.0,
	returns: bool = false,
	last_state: StudyRunner.State = StudyRunner.State.IDLE
) -> void:
	var task := runner.task_scene.task
	var from_s := runner.hand.now_s()
	var begin_s := -1.6 if returns else 0.0
	for frame in roundi((3.3 - begin_s) / 0.01):
		if runner.state == last_state:
			return
		var passed_s := begin_s + 0.01 * frame
		var time_s := from_s + 0.01 * frame
		if runner.hand.reference != null:
			var before := {HandTracker.JOINT_INDEX: _place(task, passed_s + ahead_s, time_s)}
			runner.hand.reference.push_frame(time_s, before)
		var seen := {HandTracker.JOINT_INDEX: _place(task, passed_s, time_s)}
		runner.hand.tracker.push_frame(time_s, seen)


## Before 0 s the hand is at the target, or returns from it.
func _place(task: GestureTask, passed_s: float, time_s: float) -> Vector3:
	var share := PushedHand.share((passed_s - 1.0) / 0.8)
	if passed_s < 0.0:
		share = 1.0 - PushedHand.share((passed_s + 1.1) / 0.6)
	var tremor := 1e-4 * Vector3(sin(55.0 * time_s), sin(62.0 * time_s), sin(71.0 * time_s))
	return task.get_start() + task.get_axis() * task.amplitude * share + tremor
