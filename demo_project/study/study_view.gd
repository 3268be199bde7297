extends CanvasLayer
## Shows the participant the task, the instruction and the progress. Never the condition.

const PANEL_STYLE := preload("panel_style.tres")
const THEME := preload("theme.tres")
const Tasks := preload("res://scripts/tasks.gd")
const TITLE_SIZE := 22
const TEXT_SIZE := 16

var _runner: StudyRunner = null
var _title := Label.new()
var _instruction := Label.new()
var _counter := Label.new()
var _progress := ProgressBar.new()
var _notice := Label.new()
var _panel := PanelContainer.new()
var _rows := VBoxContainer.new()
## Start of this run, for the time left.
var _begun_s := NAN
var _begun_trials := 0


func _init() -> void:
	_panel.theme = THEME
	_panel.add_theme_stylebox_override("panel", PANEL_STYLE)
	_panel.position = Vector2(24, 24)
	add_child(_panel)
	_rows.custom_minimum_size = Vector2(360, 0)
	_rows.add_theme_constant_override("separation", 8)
	_panel.add_child(_rows)
	_title.add_theme_font_size_override("font_size", TITLE_SIZE)
	for label: Label in [_instruction, _notice]:
		label.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	for row: Control in [_title, _instruction, _counter, _progress, _notice]:
		_rows.add_child(row)


## Follows a runner whose session is open.
func follow(runner: StudyRunner) -> void:
	_runner = runner
	_begun_s = 1e-6 * Time.get_ticks_usec()
	_begun_trials = runner.session.count_finished()
	runner.session.trouble.connect(show_notice)
	runner.trial_started.connect(_on_trial_started)


## Larger text on a display of `size` pixels, which the panel fills but for a margin.
func enlarge(factor: float, size: Vector2) -> void:
	_panel.theme = THEME.duplicate()
	_panel.theme.default_font_size = roundi(factor * TEXT_SIZE)
	_title.add_theme_font_size_override("font_size", roundi(factor * TITLE_SIZE))
	_rows.add_theme_constant_override("separation", 20)
	_panel.custom_minimum_size.x = size.x - 2.0 * _panel.position.x


## A notice of the operator. Empty: none.
func show_notice(text: String) -> void:
	_notice.text = text


func get_texts() -> PackedStringArray:
	return [_title.text, _instruction.text, _counter.text, _notice.text]


func _process(_delta: float) -> void:
	if _runner == null or _runner.session == null:
		return
	visible = _runner.state != StudyRunner.State.ASKING
	match _runner.state:
		StudyRunner.State.WAITING:
			_title.text = "Wait"
			_instruction.text = "The study starts with the first frame of the tracker."
		StudyRunner.State.RESTING:
			_title.text = "Rest"
			_instruction.text = "The next trial comes in %.0f s." % _runner.get_rest_left()
		StudyRunner.State.PAUSED:
			_title.text = "Pause"
			_instruction.text = "Press P to continue. A trial that was under way comes again."
		StudyRunner.State.COMPLETE:
			_title.text = "Thank you"
			_instruction.text = "The session is complete."
	_show_progress()


func _on_trial_started(trial: Dictionary) -> void:
	var gesture: String = trial["gesture"]
	_title.text = Tasks.TITLES.get(gesture, gesture.capitalize())
	if trial["practice"]:
		_title.text += " (practice)"
	_instruction.text = Tasks.INSTRUCTIONS.get(gesture, "Make the gesture.")


func _show_progress() -> void:
	var finished := _runner.session.count_finished()
	var count := _runner.session.trials.size()
	_progress.max_value = count
	_progress.value = finished
	_counter.text = "Trial %d of %d" % [mini(finished + 1, count), count]
	var made := finished - _begun_trials
	if made >= 5 and finished < count:
		var passed_s := 1e-6 * Time.get_ticks_usec() - _begun_s
		var left_s := passed_s / made * (count - finished)
		_counter.text += ", about %d min left" % ceili(left_s / 60.0)
