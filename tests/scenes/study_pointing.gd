extends "support/scene_test.gd"
## The questionnaire in the scene, answered by a fingertip; the operator's panel.

const OperatorPanel := preload("res://study/operator_panel.gd")
const PointingPanel := preload("res://study/pointing_questionnaire_panel.gd")
const Questions := preload("res://study/questionnaires/three_statements.tres")
const StudyHand := preload("res://study/study_hand.gd")
const DesktopPanel := preload("res://study/desktop_questionnaire_panel.gd")
const StudySupport := preload("support/study_support.gd")
const WorldPanel := preload("res://study/world_panel.gd")

const FRAME_S := 0.01
const FAR_M := 0.05

var _tracker: HandTracker
var _display: WorldPanel
var _panel: PointingPanel
var _time_s := 1.0
var _events: Array = []


func test_touched_buttons_answer_and_count_changes() -> void:
	await _open()
	await _touch("3")
	check_equal(_events, [], "a touch alone is no answer")
	await _touch("4")
	await _touch("Confirm")
	check_equal(_events, [["synchronisation", 4, 1]], "the second answer, changed once")
	await _touch("Confirm")
	check_equal(_events.size(), 1, "nothing is confirmed before an answer")
	await _touch("Skip")
	check_equal(_events.back(), ["smoothness"], "the item is skipped")
	_close()


func test_a_fingertip_held_over_a_button_presses_it_once() -> void:
	await _open()
	_hold("2", 0.5)
	check(not _button("2").button_pressed, "not after 0.5 s")
	check(_panel._cursor.visible, "the cursor is shown")
	_hold("2", 0.5)
	check(_button("2").button_pressed, "after 0.8 s")
	_hold("Confirm", 1.0)
	check_equal(_events, [["synchronisation", 2, 0]], "confirmed, and never changed")
	_push(Vector3(0.0, 0.0, 1.0))
	check(not _panel._cursor.visible, "no cursor for a hand that is far away")
	_close()


func test_keys_answer_on_the_display() -> void:
	await _open()
	for key: Key in [KEY_1, KEY_ENTER]:
		var event := InputEventKey.new()
		event.pressed = true
		event.keycode = key
		root.push_input(event)
		await process_frame
	check_equal(_events, [["synchronisation", 1, 0]], "the operator's answer")
	_close()


func test_a_slider_takes_the_place_of_a_touch() -> void:
	await _open(load("res://study/questionnaires/task_load.tres") as Questionnaire)
	var rect := _panel._slider.get_global_rect()
	var pixel := rect.position + Vector2(0.75, 0.5) * rect.size
	for distance_m: float in [FAR_M, -0.005, FAR_M]:
		_push(_display.from_display(pixel, distance_m))
	await _touch("Confirm")
	check_equal(_events, [["mental", 75, 0]], "three quarters of the scale")
	_close()


func test_the_operator_reads_the_condition_and_skips_a_trial() -> void:
	var folder := DirAccess.create_temp("steadyhand_operator")
	var session := StudySession.new()
	session.start(folder.get_current_dir(), "ann", StudySupport.protocol(), "person")
	var runner := StudyRunner.new()
	root.add_child(runner)
	runner.vibration_bus = &""
	var operator := OperatorPanel.new()
	root.add_child(operator)
	runner.begin(session, StudyHand.new(ScriptSource.new()), DesktopPanel.new())
	operator.follow(runner)
	await process_frame
	check_equal(operator.get_text("study"), "waiting for the tracker", "no frame has come")
	runner.hand.tracker.push_frame(0.0, {})
	await process_frame
	await process_frame
	check_equal(operator.get_text("condition"), runner.trial["condition"], "the condition")
	check(operator.get_text("trial").begins_with("1 of "), "the trial")
	check_equal(operator.get_text("hand"), "not tracked", "the tracker")
	runner.skip()
	await process_frame
	await process_frame
	check_equal(session.count_finished(), 1, "the trial is over")
	runner.free()
	operator.free()


func _open(asked: Questionnaire = Questions) -> void:
	_events.clear()
	_tracker = HandTracker.new()
	_tracker.source = ScriptSource.new()
	_tracker.update_mode = HandTracker.UPDATE_MANUAL
	_display = WorldPanel.new()
	_display.position = Vector3(0.1, 1.2, -0.5)
	_display.rotation.x = -0.1
	_panel = PointingPanel.new(_display, _tracker)
	_display.viewport.add_child(_panel)
	for node: Node in [_tracker, _display]:
		root.add_child(node)
	_tracker.start()
	_panel.answered.connect(
		func(item: String, value: int, changes: int) -> void: _events.append([item, value, changes])
	)
	_panel.skipped.connect(func(item: String) -> void: _events.append([item]))
	_panel.ask(asked, asked.items, {})
	await _settle()


func _close() -> void:
	_display.free()
	_tracker.free()


## Containers lay their children out at the end of a frame.
func _settle() -> void:
	for frame in 3:
		await process_frame


func _touch(text: String) -> void:
	for distance_m: float in [FAR_M, 0.02, -0.005, 0.02, FAR_M]:
		_push(_place(text, distance_m))
	await _settle()


func _hold(text: String, seconds: float) -> void:
	for frame in roundi(seconds / FRAME_S):
		_push(_place(text, FAR_M))


func _push(place: Vector3) -> void:
	_time_s += FRAME_S
	_tracker.push_frame(_time_s, {HandTracker.JOINT_INDEX: place})
	_tracker.advance_to(_time_s)


func _place(text: String, distance_m: float) -> Vector3:
	return _display.from_display(_button(text).get_global_rect().get_center(), distance_m)


func _button(text: String) -> Button:
	var buttons: Array[Button] = [_panel._confirm, _panel._skip]
	buttons.append_array(_panel._buttons)
	for button in buttons:
		if button.text == text:
			return button
	return null
