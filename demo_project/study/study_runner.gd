class_name StudyRunner
extends Node
## Runs a session trial by trial: tasks, rests, questionnaires, files. Give it a session, a hand and
## a panel, then call begin(). A person's session goes on by itself; a simulated one by step().

signal trial_started(trial: Dictionary)
## `figures`: of MotionMetrics.compare() for the condition that drove the trial; may be empty.
signal trial_ended(trial: Dictionary, figures: Dictionary)
signal rest_started(seconds: float)
signal questionnaire_started(asked: Questionnaire)
## Every trial is made and every questionnaire answered.
signal completed

enum State {
	IDLE,
	## For the tracker's first frame, which sets the run's clock.
	WAITING,
	RESTING,
	ASKING,
	MAKING,
	ENDING,
	PAUSED,
	COMPLETE,
}

const MouseStudyHand := preload("mouse_study_hand.gd")
const StudyHand := preload("study_hand.gd")
const StudyTask := preload("study_task.gd")
const StudyTrialLog := preload("study_trial_log.gd")

## Recording continues for this time after the end of a gesture, s.
const AFTER_S := 0.5
## The same for a tracker that sends no more frames: its clock stands still.
const LONGEST_AFTER_S := 1.0
## Files are written at least so often between trials, s.
const FLUSH_INTERVAL_S := 1.0

var state := State.IDLE
var session: StudySession = null
var hand: StudyHand = null
var panel: QuestionnairePanel = null
## The current trial, or the last one.
var trial: Dictionary = {}
## Null before the first trial.
var task_scene: StudyTask = null
## Audio bus of the vibration. Empty: it is not played.
var vibration_bus := &"Vibration"

var _truth: Dictionary = {}
var _due: Dictionary = {}
var _unanswered := 0
var _item_shown_s := 0.0
## On the run's clock. INF: no gesture has ended yet.
var _recorded_until_s := INF
## How much of the trial is left at most, s.
var _trial_left_s := 0.0
var _rest_left_s := 0.0
var _rested_before := 0
var _unflushed_s := 0.0


## `given_hand` and `given_panel` are added to the tree.
func begin(
	given_session: StudySession, given_hand: StudyHand, given_panel: QuestionnairePanel
) -> Error:
	session = given_session
	hand = given_hand
	panel = given_panel
	for node: Node in [hand, panel]:
		if node.get_parent() == null:
			add_child(node)
	panel.answered.connect(_on_answered)
	hand.frames_over.connect(func() -> void: task_scene.is_recording = false)
	panel.skipped.connect(func(item: String) -> void: _on_answered(item, null, 0))
	var opened := hand.open(session.participant)
	if opened != OK:
		return opened
	state = State.WAITING
	if hand.has_clock():
		_start_run()
	return OK


## Makes a simulated session's next rest, questionnaire or trial. False once there is nothing left.
func step() -> bool:
	_go_on()
	match state:
		State.RESTING:
			hand.wait(_rest_left_s)
			_end_rest()
		State.MAKING:
			hand.play()
			_end_trial()
	return state != State.COMPLETE


## Writes all data that waits in memory. Also called when the runner leaves the tree.
func end() -> void:
	if session == null:
		return
	_abort_trial()
	add_event("run_ended", Time.get_datetime_string_from_system())
	session.flush()
	session = null
	state = State.IDLE


## Adds an event of now, outside of trials. Without the run's clock it has no time, and is left out.
func add_event(event: String, value: String = "") -> void:
	if hand.has_clock():
		session.add_event(hand.now_s(), event, value)


## A pause drops the current trial: it is made again. A rest continues after the pause.
func pause() -> void:
	if state in [State.IDLE, State.WAITING, State.PAUSED, State.COMPLETE]:
		return
	_abort_trial()
	panel.close()
	state = State.PAUSED
	add_event("paused")
	session.flush()


func continue_run() -> void:
	if state != State.PAUSED:
		return
	add_event("continued")
	if _rest_left_s > 0.0:
		state = State.RESTING
	else:
		_go_on()


## Ends a person's rest, or their trial as it is. A questionnaire's item is skipped by its panel.
func skip() -> void:
	if hand == null or hand.is_simulated():
		return
	if state == State.RESTING:
		_rest_left_s = 0.0
	elif state in [State.MAKING, State.ENDING]:
		session.add_event(hand.now_s(), "skipped", "", trial["trial"])
		_trial_left_s = 0.0


## How much of a rest is left, s.
func get_rest_left() -> float:
	return _rest_left_s if state == State.RESTING else 0.0


func _process(delta: float) -> void:
	if session == null or hand.is_simulated():
		return
	match state:
		State.WAITING:
			if hand.has_clock():
				_start_run()
		State.RESTING:
			_rest_left_s = maxf(_rest_left_s - delta, 0.0)
			if _rest_left_s == 0.0:
				_end_rest()
				_go_on()
		State.MAKING, State.ENDING:
			_trial_left_s -= delta
			if _trial_left_s <= 0.0 or task_scene.gesture_hmm.time >= _recorded_until_s:
				_end_trial()
				_go_on()
	_unflushed_s += delta
	if state in [State.RESTING, State.ASKING] and _unflushed_s > FLUSH_INTERVAL_S:
		_unflushed_s = 0.0
		session.flush()


func _exit_tree() -> void:
	end()


func _start_run() -> void:
	state = State.IDLE
	add_event("run_started", Time.get_datetime_string_from_system())
	session.flush()
	if not hand.is_simulated():
		_go_on()


## Begins what is next: a questionnaire, a rest, a trial, or the end.
func _go_on() -> void:
	_due = session.next_questionnaire()
	if not _due.is_empty():
		_ask()
		return
	var next := session.next_trial()
	if next.is_empty():
		_complete()
	elif next["rest_before_s"] > 0.0 and _rested_before != next["trial"]:
		_rested_before = next["trial"]
		_rest(next["rest_before_s"])
	else:
		_begin_trial(next)


func _rest(seconds: float) -> void:
	state = State.RESTING
	_rest_left_s = seconds
	add_event("rest_started")
	session.flush()
	rest_started.emit(seconds)


func _end_rest() -> void:
	_rest_left_s = 0.0
	add_event("rest_ended")


func _ask() -> void:
	state = State.ASKING
	var asked: Questionnaire = _due["questionnaire"]
	_unanswered = _due["items"].size()
	_item_shown_s = hand.now_s()
	add_event("questionnaire_shown", asked.name)
	questionnaire_started.emit(asked)
	panel.ask(asked, _due["items"], session.trials[_due["after_trial"] - 1])


## `value`: null where the item was skipped.
func _on_answered(item: String, value: Variant, changes: int) -> void:
	var asked: Questionnaire = _due["questionnaire"]
	var time_s := hand.now_s()
	var answer := {
		item = item,
		text = asked.texts[asked.items.find(item)],
		value = value,
		changes = changes,
		shown_s = _item_shown_s,
		answered_s = time_s,
	}
	_item_shown_s = time_s
	session.add_answer(_due["after_trial"], asked, answer)
	session.add_event(time_s, "answered", "%s/%s" % [asked.name, item])
	session.flush()
	_unanswered -= 1
	if _unanswered == 0 and not hand.is_simulated():
		_go_on()


func _begin_trial(next: Dictionary) -> void:
	trial = next
	_use_scene(trial["gesture"])
	_truth = hand.prepare(trial, task_scene.task)
	var log := StudyTrialLog.new(session, trial["trial"], hand.tracker, hand.reference)
	var time_s := hand.now_s()
	state = State.MAKING
	_recorded_until_s = INF
	_trial_left_s = session.protocol["trial_limit_s"]
	task_scene.begin(trial, time_s, log)
	trial_started.emit(trial)


func _end_trial() -> void:
	var row := task_scene.finish(_truth)
	var figures: Dictionary = task_scene.last_figures.get(trial["condition"], {})
	state = State.IDLE
	session.finish_trial(trial["trial"], row)
	trial_ended.emit(trial, figures)


func _abort_trial() -> void:
	if state in [State.MAKING, State.ENDING] and task_scene != null:
		task_scene.abort()
		state = State.IDLE


func _complete() -> void:
	if state == State.COMPLETE:
		return
	state = State.COMPLETE
	session.flush()
	completed.emit()


## One task's scene is in the tree at a time.
func _use_scene(gesture: String) -> void:
	if task_scene != null and task_scene.gesture == gesture:
		return
	if task_scene != null:
		task_scene.free()
	task_scene = StudyTask.make(gesture, hand.tracker)
	task_scene.event_occurred.connect(
		func(time_s: float, event: String, value: String) -> void:
			session.add_event(time_s, event, value, trial["trial"])
	)
	task_scene.done.connect(_on_done)
	add_child(task_scene)
	task_scene.haptic_synth.bus = vibration_bus
	task_scene.mouse.active = hand is MouseStudyHand


func _on_done(time_s: float) -> void:
	if state == State.MAKING and not hand.is_simulated():
		state = State.ENDING
		_recorded_until_s = time_s + AFTER_S
		_trial_left_s = LONGEST_AFTER_S
