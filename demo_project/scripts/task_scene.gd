extends Node3D
## A task of the study: plays trials on the HandTracker one after another, or follows a live hand or
## the mouse. The GestureHMM's motion moves the stage, and is logged. Tasks differ in their
## GestureTask and stage, not in this script.

signal trial_started(trial: String)
signal trial_ended(trial: String)
## `found`: the participant's new positions, or why they stay the same.
signal practice_ended(found: String)

const Conditions := preload("conditions.gd")
const MouseHand := preload("mouse_hand.gd")
const Origin := preload("origin.gd")
const Participant := preload("participant.gd")
const Practice := preload("practice.gd")
const Readout := preload("readout.gd")
const Stage := preload("stage.gd")
const StudyOrder := preload("study_order.gd")
const SyntheticTrials := preload("synthetic_trials.gd")
const Tasks := preload("tasks.gd")
const TrialCourse := preload("trial_course.gd")
const TrialList := preload("trial_list.gd")
const TrialLog := preload("trial_log.gd")
const TrialTask := preload("trial_task.gd")

## A trial set to play; empty: synthetic people make the trials.
@export_dir var trial_folder := ""
## Where the logs go; each session makes a folder of its own there.
@export_global_dir var log_folder := "user://logs"
## Play trial after trial from the start.
@export var autoplay := true

## Course of the present trial.
var course: TrialCourse = null
## Folder of this session.
var session_folder := ""

var _synthetic: SyntheticTrials = null
var _trials: TrialList = null
var _log: TrialLog = null
var _trial_name := ""
var _position_name := ""
var _is_live := false
var _live_runs := 0
var _live_trials := 0
var _order := StudyOrder.new()
var _participant := Participant.new()
var _practice: Practice = null
## Share of the amplitude at which a task is done: the arrival level of HapticSynth.
var _arrived: float = ClassDB.class_get_property_default_value(&"HapticSynth", &"arrival_level")

@onready var tracker: HandTracker = $HandTracker
@onready var task: GestureTask = $GestureTask
@onready var gesture_hmm: GestureHMM = $GestureHMM
@onready var haptic_synth: HapticSynth = $HapticSynth
@onready var _stage: Stage = $Stage
@onready var _readout: Readout = $Readout
@onready var _mouse: MouseHand = $MouseHand


func _ready() -> void:
	var stamp := Time.get_datetime_string_from_system().replace(":", "-")
	session_folder = log_folder.path_join(stamp)
	var sessions := 1
	while DirAccess.dir_exists_absolute(session_folder):
		sessions += 1
		session_folder = log_folder.path_join("%s-%d" % [stamp, sessions])
	tracker.finished.connect(_on_tracker_finished)
	gesture_hmm.gesture_started.connect(_on_gesture_started)
	# A hand that stops before its target has finished the trial, too.
	gesture_hmm.completion = 0.5
	gesture_hmm.gesture_ended.connect(_on_gesture_ended)
	gesture_hmm.gesture_aborted.connect(_on_gesture_aborted)
	gesture_hmm.motion_updated.connect(_on_motion_updated)
	course = TrialCourse.new(_stage.strokes_add_up)
	_stage.place(task, "")
	_readout.show_instruction(Tasks.INSTRUCTIONS.get(String(task.gesture), ""))
	_synthetic = SyntheticTrials.new(task)
	if autoplay:
		play_next()


func _process(_delta: float) -> void:
	_readout.show_live(gesture_hmm, not _order.conditions.is_empty())
	if _practice != null:
		_readout.notice = _practice.get_instruction()


func _unhandled_key_input(event: InputEvent) -> void:
	var key := event as InputEventKey
	if not key.pressed or key.echo:
		return
	var condition := key.keycode - KEY_1
	if condition >= 0 and condition < Conditions.MOTIONS.size():
		if not _order.conditions.is_empty():
			compare_conditions(false)
		gesture_hmm.motion = Conditions.MOTIONS[condition]
	elif key.keycode == KEY_R:
		compare_conditions(_order.conditions.is_empty())
	elif key.keycode == KEY_M:
		follow_mouse(not _mouse.active)
	elif key.keycode == KEY_P:
		practise()
	elif key.keycode == KEY_N and not _is_live:
		play_next()
	elif key.keycode == KEY_ESCAPE and get_tree().current_scene == self:
		get_tree().change_scene_to_file(Tasks.MENU)


func _exit_tree() -> void:
	_end_trial()


## Plays a trial of a set. `trial`: a row of TrialSet.get_trial().
func play(trial: Dictionary, measured_path: String) -> Error:
	_stop()
	var source := RecordedSource.new()
	source.track = measured_path
	tracker.source = source
	TrialTask.apply(trial, task)
	var started := tracker.start()
	if started == OK:
		_begin_trial(trial["trial"], trial["position"], trial.get("subject", ""), "replay")
	return started


## Plays the next trial of `trial_folder` whose track can be read, or of a synthetic person.
func play_next() -> void:
	if trial_folder.is_empty():
		_play_synthetic()
		return
	if _trials == null:
		_trials = TrialList.new(trial_folder, task.gesture)
	for i in _trials.get_count():
		_trials.advance()
		if play(_trials.trial, _trials.measured_path) == OK:
			return


## Follows the mouse, or plays trials again.
func follow_mouse(on: bool) -> void:
	_mouse.active = on
	if on:
		follow_live()
	else:
		_is_live = false
		_practice = null
		_order.conditions = []
		_readout.notice = ""
		play_next()


## Follows a live hand: that of `source`, or one whose frames are pushed.
func follow_live(source: HandSource = ScriptSource.new()) -> void:
	_stop()
	_is_live = true
	tracker.source = source
	_record_frames()
	tracker.start()
	_begin_live_trial()


## Begins a practice run with the live hand, or with the mouse if there is none. If a run is active,
## ends it.
func practise() -> void:
	if _practice != null:
		_practice.end()
		return
	if not _is_live:
		follow_mouse(true)
	_end_trial()
	_practice = Practice.new(tracker, _stage.joints[0] as HandTracker.Joint)
	_practice.ended.connect(_on_practice_ended)


## On: the paper's conditions in a random order, block by block, with a live hand or the mouse.
## Off: the present condition, until another is chosen.
func compare_conditions(on: bool) -> void:
	_order.conditions = []
	if on:
		_order.conditions = Conditions.COMPARED.duplicate()
	_readout.notice = "conditions in a random order" if on else "one condition"
	if on and not _is_live:
		_mouse.active = true
	if on and _practice == null:
		_begin_order()


## Name of the condition that drives what is shown.
func condition_name() -> String:
	return Conditions.NAMES[Conditions.MOTIONS.find(gesture_hmm.motion)]


func _play_synthetic() -> void:
	_stop()
	_synthetic.advance(task)
	tracker.source = _synthetic.source
	if tracker.start() == OK:
		var trial := _synthetic.trial
		_begin_trial(trial["trial"], trial["position"], trial["subject"], "synthetic")


## `origin`: who makes the trial, as in session.json.
func _begin_trial(
	trial_name: String, position_name: String, participant: String, origin: String
) -> void:
	_trial_name = trial_name
	_position_name = position_name
	course = TrialCourse.new(_stage.strokes_add_up)
	_stage.place(task, position_name)
	var logged := {
		trial = trial_name,
		gesture = task.gesture,
		position = position_name,
		participant = participant,
		amplitude_m = task.amplitude,
		width_m = _stage.target_width(),
		origin = origin,
	}
	_log = TrialLog.new(session_folder, logged)
	trial_started.emit(trial_name)


## Uses the participant's positions in turn, if a practice run has found them. Uses the condition
## whose turn it is, if conditions are compared.
func _begin_live_trial() -> void:
	var position_name := ""
	if _participant.has_positions(task.gesture):
		position_name = Participant.POSITIONS[_order.position_at(_live_trials, _positions())]
		TrialTask.place_middle(task, _participant.get_position(task.gesture, position_name))
	if not _order.conditions.is_empty():
		gesture_hmm.motion = _order.condition_at(_live_trials, _positions())
	_live_trials += 1
	var trial_name := "%s_%03d" % ["mouse" if _mouse.active else "live", _live_trials]
	var origin := "mouse" if _mouse.active else Origin.of(tracker.source)
	_begin_trial(trial_name, position_name, _participant.name, origin)


## Number of positions of a live hand's trials.
func _positions() -> int:
	return Participant.POSITIONS.size() if _participant.has_positions(task.gesture) else 1


## Starts the first block of a live hand's trials.
func _begin_order() -> void:
	_order.begin(_live_trials, randi())
	follow_live(tracker.source if _is_live else ScriptSource.new())


func _stop() -> void:
	_end_trial()
	tracker.stop()
	tracker.stop_recording()


## Records the frames of a live hand next to the logs.
func _record_frames() -> void:
	_live_runs += 1
	DirAccess.make_dir_recursive_absolute(session_folder)
	tracker.start_recording(session_folder.path_join("frames_%02d.csv" % _live_runs))


func _end_trial() -> void:
	if _log == null:
		return
	_log.close(condition_name(), course)
	_log = null
	trial_ended.emit(_trial_name)


func _on_tracker_finished() -> void:
	_end_trial()
	if autoplay:
		play_next.call_deferred()


func _on_gesture_started(_gesture: StringName, _task: GestureTask) -> void:
	if _practice != null:
		return
	_readout.notice = ""
	# A played trial ends with its track. With a live hand each gesture is one, or each task with
	# several.
	if _is_live and course.is_trial_done():
		_end_trial()
		_begin_live_trial()
	if is_nan(course.start_s):
		course.start_s = gesture_hmm.time
		_stage.mark_started()
	_stage.begin_stroke()


func _on_gesture_ended(
	_gesture: StringName, time_s: float, _task: GestureTask, _fraction: float
) -> void:
	if _practice == null and course.takes_end():
		course.gesture_end_s = time_s
		course.end_value_m = _stage.end_value(gesture_hmm.value)
	# The next position must be shown before the hand goes there.
	if _is_live and _practice == null and course.is_trial_done():
		if _order.changes_at(_live_trials, _positions()):
			_end_trial()
			_begin_live_trial.call_deferred()


## A live hand that turned back makes its trial again.
func _on_gesture_aborted(_gesture: StringName, _task: GestureTask) -> void:
	if _is_live and _log != null and not _stage.strokes_add_up:
		course = TrialCourse.new(_stage.strokes_add_up)
		_stage.place(task, _position_name)


func _on_practice_ended(proposal: Dictionary) -> void:
	_practice = null
	if proposal.get("distinct", false):
		_participant.keep(task.gesture, proposal)
	_readout.notice = Practice.describe(proposal)
	_begin_order()
	practice_ended.emit(_readout.notice)


func _on_motion_updated(time_s: float) -> void:
	var done := _stage.show_motion(gesture_hmm.value)
	if is_nan(course.end_s) and not is_nan(course.start_s) and done >= _arrived:
		course.end_s = time_s
		_stage.mark_arrived()
	_stage.show_hand(tracker)
	if _log != null:
		_log.add(time_s, condition_name(), gesture_hmm, haptic_synth.get_amplitude())
