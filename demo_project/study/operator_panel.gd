extends PanelContainer
## For the operator of the study: session, trial, condition, live values, tracker, buttons. The
## participant must not see it.

signal pause_pressed
signal recentre_pressed
signal skip_pressed

const Conditions := preload("res://scripts/conditions.gd")
const PANEL_STYLE := preload("panel_style.tres")

const THEME := preload("theme.tres")

const DRIVING := Color(1.0, 0.83, 0.3)
const OTHER := Color(0.85, 0.88, 0.9)
const STATES: Dictionary[StudyRunner.State, String] = {
	StudyRunner.State.IDLE: "idle",
	StudyRunner.State.WAITING: "waiting for the tracker",
	StudyRunner.State.RESTING: "rest",
	StudyRunner.State.ASKING: "questionnaire",
	StudyRunner.State.MAKING: "trial",
	StudyRunner.State.ENDING: "trial is ending",
	StudyRunner.State.PAUSED: "paused",
	StudyRunner.State.COMPLETE: "complete",
}

var _runner: StudyRunner = null
var _rows: Dictionary[String, Label] = {}
var _titles: Dictionary[String, Label] = {}
var _table := GridContainer.new()
var _pause: Button = null


func _init() -> void:
	theme = THEME
	add_theme_stylebox_override("panel", PANEL_STYLE)
	var rows := VBoxContainer.new()
	rows.add_theme_constant_override("separation", 16)
	add_child(rows)
	var title := Label.new()
	title.text = "Operator"
	title.add_theme_font_size_override("font_size", 22)
	rows.add_child(title)
	_table.columns = 2
	_table.add_theme_constant_override("h_separation", 24)
	rows.add_child(_table)
	for row: String in [
		"session", "protocol", "trial", "gesture", "position", "condition", "study", "state"
	]:
		_add_row(row)
	for condition in Conditions.NAMES:
		_add_row(condition)
	for row: String in ["frames", "faults", "latency", "hand"]:
		_add_row(row)
	var buttons := HBoxContainer.new()
	buttons.add_theme_constant_override("separation", 10)
	rows.add_child(buttons)
	_pause = _add_button(buttons, "Pause (P)", pause_pressed)
	_add_button(buttons, "Recentre (Space)", recentre_pressed)
	_add_button(buttons, "Skip (N)", skip_pressed)


## Follows a runner whose session is open.
func follow(runner: StudyRunner) -> void:
	_runner = runner


func get_text(row: String) -> String:
	return _rows[row].text


func _process(_delta: float) -> void:
	if is_instance_valid(_runner) and _runner.session != null:
		_show_session()
		_show_tracker()


func _show_session() -> void:
	var session := _runner.session
	var trial := _runner.trial
	_write("session", "%s / %02d, %s" % [session.participant, session.number, session.origin])
	var changed := ", ".join(session.changed)
	_write("protocol", "unchanged" if changed.is_empty() else "changed: %s" % changed)
	_write("study", STATES[_runner.state])
	_pause.text = "Continue (P)" if _runner.state == StudyRunner.State.PAUSED else "Pause (P)"
	if trial.is_empty() or _runner.task_scene == null:
		return
	_write("trial", "%d of %d" % [trial["trial"], session.trials.size()])
	_write("gesture", "%s%s" % [trial["gesture"], " (practice)" if trial["practice"] else ""])
	_write("position", trial["position"])
	_write("condition", trial["condition"])
	var hmm := _runner.task_scene.gesture_hmm
	var is_idle := hmm.gesture.is_empty()
	_write("state", "idle" if is_idle else "%d, %.0f %%" % [hmm.state, 100.0 * hmm.progress])
	for i in Conditions.NAMES.size():
		var condition := Conditions.NAMES[i]
		_write(condition, "%.1f mm" % (1000.0 * hmm.get_motion_value(Conditions.MOTIONS[i])))
		var colour := DRIVING if condition == trial["condition"] else OTHER
		_rows[condition].modulate = colour
		_titles[condition].modulate = colour


func _show_tracker() -> void:
	var tracker := _runner.hand.tracker
	_write(
		"frames", "%.0f Hz, jitter %.1f ms" % [tracker.frame_rate, 1000.0 * tracker.frame_jitter]
	)
	var faults := [tracker.dropout_count, tracker.freeze_count, tracker.jump_count]
	_write("faults", "%d dropouts, %d freezes, %d jumps" % faults)
	var latency := tracker.latency
	_write("latency", "unknown" if is_nan(latency) else "%.0f ms" % (1000.0 * latency))
	_write("hand", "tracked" if tracker.is_hand_tracked() else "not tracked")


func _write(row: String, text: String) -> void:
	_rows[row].text = text


func _add_row(row: String) -> void:
	var title := Label.new()
	title.text = row
	title.modulate = OTHER
	var value := Label.new()
	value.text = "-"
	value.custom_minimum_size.x = 260
	_titles[row] = title
	_rows[row] = value
	_table.add_child(title)
	_table.add_child(value)


func _add_button(to: Container, text: String, pressed: Signal) -> Button:
	var button := Button.new()
	button.text = text
	button.focus_mode = Control.FOCUS_NONE
	button.custom_minimum_size = Vector2(0, 44)
	button.pressed.connect(pressed.emit)
	to.add_child(button)
	return button
