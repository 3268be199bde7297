extends "support/scene_test.gd"
## A person's session: trials, questions, pauses, a reference sensor, the scene.

const Conditions := preload("res://scripts/conditions.gd")
const DesktopPanel := preload("res://study/desktop_questionnaire_panel.gd")
const StudyHand := preload("res://study/study_hand.gd")
const StudyScene := preload("res://study/study_scene.gd")
const StudySupport := preload("support/study_support.gd")
const StudyView := preload("res://study/study_view.gd")
const TrialRows := preload("support/trial_rows.gd")

const STUDY_SCENE := "res://study/study_scene.tscn"

var _folder := DirAccess.create_temp("steadyhand_study_person")
var _root := _folder.get_current_dir()


func test_a_person_is_led_through_a_session() -> void:
	var protocol := StudySupport.protocol()
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
	var answers := StudySupport.read(session, "answers.csv")
	var values := answers.map(func(row: Dictionary) -> String: return row["value"])
	check_equal(values, ["3", "", "0"], "two answers and a skipped item")
	check_equal(answers[0]["changes"], "1", "changes of the first answer")
	check_equal(answers[1]["skipped"], "1", "skipped")


func test_a_persons_trial_is_compared_with_a_reference_sensor() -> void:
	var session := StudySession.new()
	session.start(_root.path_join("sensor"), "ann", StudySupport.protocol(), "person")
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


func test_the_return_before_a_trial_does_not_count_in_its_figures() -> void:
	var protocol := StudySupport.protocol()
	protocol.gestures = ["horizontal_drag"]
	protocol.practice_trials = 0
	protocol.questionnaires = []
	var session := StudySession.new()
	session.start(_root.path_join("return"), "ann", protocol, "person")
	var runner := StudyRunner.new()
	root.add_child(runner)
	runner.vibration_bus = &""
	var hand := StudyHand.new(ScriptSource.new(), ScriptSource.new())
	hand.tracker.update_mode = HandTracker.UPDATE_MANUAL
	hand.reference.update_mode = HandTracker.UPDATE_MANUAL
	runner.begin(session, hand, DesktopPanel.new())
	var time_s := 1e-6 * Time.get_ticks_usec()
	for trial in 2:
		# The hand is still at the target of the trial before.
		time_s = _drag(runner, maxf(time_s, 1e-6 * Time.get_ticks_usec()), 0.03, trial > 0)
		var began_ms := Time.get_ticks_msec()
		while session.count_finished() == trial and Time.get_ticks_msec() - began_ms < 20000:
			await process_frame
	runner.free()
	for row in TrialRows.read(session.folder):
		check_near(row["lag_measured"].to_float(), 0.035, 0.003, "trial %s: lag" % row["trial"])
		check_near(row["t_diff_measured"].to_float(), -0.03, 0.006, "it ends later")
		check(row["r2_measured"].to_float() > 0.99, "R2 of the measured motion")
		check(row["r2_zero_measured"].to_float() > 0.97, "zero-lag R2")


func test_a_trial_without_a_gesture_ends_at_its_limit() -> void:
	var protocol := StudySupport.protocol()
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
	check_equal(again.resume(folder.get_base_dir().get_base_dir(), "p01"), OK, "it can be resumed")


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
	var session := StudySession.new()
	session.start(_root.path_join("pause"), "ann", StudySupport.protocol(), "person")
	var runner := StudyRunner.new()
	root.add_child(runner)
	runner.vibration_bus = &""
	var hand := StudyHand.new(ScriptSource.new())
	hand.tracker.update_mode = HandTracker.UPDATE_MANUAL
	runner.begin(session, hand, DesktopPanel.new())
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


## Pushes a drag along the task, and a rest; the time of its last frame.
## `ahead_s`: how much earlier the reference sees it, where there is one.
## `returns`: the hand first returns from the target.
func _drag(
	runner: StudyRunner, from_s: float, ahead_s: float = 0.0, returns: bool = false
) -> float:
	var task := runner.task_scene.task
	var time_s := from_s
	var begin_s := -1.6 if returns else 0.0
	for frame in roundi((3.3 - begin_s) / 0.01):
		time_s += 0.01
		var passed_s := begin_s + time_s - from_s
		if runner.hand.reference != null:
			var before := {HandTracker.JOINT_INDEX: _place(task, passed_s + ahead_s, time_s)}
			runner.hand.reference.push_frame(time_s, before)
		var seen := {HandTracker.JOINT_INDEX: _place(task, passed_s, time_s)}
		runner.hand.tracker.push_frame(time_s, seen)
	return time_s


## Before 0 s the hand is at the target, or returns from it.
func _place(task: GestureTask, passed_s: float, time_s: float) -> Vector3:
	var share := _moved(passed_s, 1.0, 0.8)
	if passed_s < 0.0:
		share = 1.0 - _moved(passed_s, -1.1, 0.6)
	var tremor := 1e-4 * Vector3(sin(55.0 * time_s), sin(62.0 * time_s), sin(71.0 * time_s))
	return task.get_start() + task.get_axis() * task.amplitude * share + tremor


## Share of a minimum-jerk motion.
func _moved(passed_s: float, onset_s: float, duration_s: float) -> float:
	var p := clampf((passed_s - onset_s) / duration_s, 0.0, 1.0)
	return p * p * p * (10.0 - 15.0 * p + 6.0 * p * p)
