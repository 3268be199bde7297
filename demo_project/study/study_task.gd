extends Node3D
## A task's scene in a study. The scene's own nodes and stage serve; this script takes the place of
## task_scene.gd. Makes one trial after another with the study's tracker.

## An event of events.csv.
signal event_occurred(time_s: float, event: String, value: String)
## The task is done. `time_s`: end of the gesture.
signal done(time_s: float)

const Conditions := preload("res://scripts/conditions.gd")
const MouseHand := preload("res://scripts/mouse_hand.gd")
const Stage := preload("res://scripts/stage.gd")
const StudyTask := preload("study_task.gd")
const StudyTrialLog := preload("study_trial_log.gd")
const Tasks := preload("res://scripts/tasks.gd")
const TrialCourse := preload("res://scripts/trial_course.gd")

var tracker: HandTracker = null
var gesture := ""
## Figures of StudyTrialLog for the last finished trial.
var last_figures: Dictionary[String, Dictionary] = {}
## Null between trials.
var log: StudyTrialLog = null
var course: TrialCourse = null
var recognised := ""
var aborts := 0
var losses := 0
## After a simulated hand's last frame nothing is recorded, but a gesture may still end.
var is_recording := false

var _shown_s := 0.0
var _arrived: float = ClassDB.class_get_property_default_value(&"HapticSynth", &"arrival_level")

@onready var task: GestureTask = $GestureTask
@onready var gesture_hmm: GestureHMM = $GestureHMM
@onready var haptic_synth: HapticSynth = $HapticSynth
@onready var mouse: MouseHand = $MouseHand
@onready var _stage: Stage = $Stage


## Returns a scene outside of the tree. `given_tracker`: of the study; all gestures share it.
static func make(given_gesture: String, given_tracker: HandTracker) -> StudyTask:
	var scene := (load(Tasks.SCENES[given_gesture]) as PackedScene).instantiate()
	scene.set_script(load("res://study/study_task.gd"))
	# The participant must not see the condition.
	for unused: String in ["HandTracker", "Readout"]:
		scene.get_node(unused).free()
	var made := scene as StudyTask
	made.tracker = given_tracker
	made.gesture = given_gesture
	return made


func _ready() -> void:
	gesture_hmm.tracker = tracker
	mouse.tracker = tracker
	gesture_hmm.gesture_started.connect(_on_gesture_started)
	# A hand that stops before its target has finished the trial, too.
	gesture_hmm.completion = 0.5
	gesture_hmm.gesture_ended.connect(_on_gesture_ended)
	gesture_hmm.gesture_aborted.connect(_on_gesture_aborted)
	gesture_hmm.motion_updated.connect(_on_motion_updated)
	tracker.tracking_lost.connect(_on_tracking_lost)
	tracker.tracking_restored.connect(_on_tracking_restored)
	course = TrialCourse.new(_stage.strokes_add_up)


## Call it after placing the task. `trial`: of the plan. `time_s`: now.
func begin(trial: Dictionary, time_s: float, given_log: StudyTrialLog) -> void:
	gesture_hmm.motion = Conditions.MOTIONS[Conditions.NAMES.find(trial["condition"])]
	course = TrialCourse.new(_stage.strokes_add_up)
	recognised = ""
	aborts = 0
	losses = 0
	_shown_s = time_s
	task.force_update_transform()
	_stage.place(task, trial["position"])
	if trial["width_m"] != null:
		_stage.set_target_width(trial["width_m"])
	log = given_log
	is_recording = true
	event_occurred.emit(time_s, "target_shown", trial["gesture"])


## Columns of trials.csv. `truth`: as in StudyTrialLog.finish().
func finish(truth: Dictionary) -> Dictionary:
	var row := log.finish(task, _feature(), truth, course.start_s)
	last_figures = log.figures
	row["shown_s"] = _shown_s
	row["onset_s"] = course.start_s
	row["end_s"] = course.gesture_end_s
	row["recognised"] = recognised
	row["aborts"] = aborts
	row["losses"] = losses
	row["end_value_m"] = course.end_value_m
	row["amplitude_m"] = task.amplitude
	row["width_m"] = _stage.target_width()
	log = null
	return row


## Drops the current trial.
func abort() -> void:
	if log != null:
		log.stop()
		log = null


func _feature() -> String:
	for model in gesture_hmm.models:
		if model.gesture == task.gesture:
			return model.feature
	return gesture_hmm.models[0].feature


func _on_gesture_started(started: StringName, _task: GestureTask) -> void:
	if log == null:
		return
	event_occurred.emit(gesture_hmm.time, "onset", String(started))
	if is_nan(course.start_s):
		course.start_s = gesture_hmm.time
		_stage.mark_started()
	_stage.begin_stroke()


func _on_gesture_ended(
	ended: StringName, time_s: float, _task: GestureTask, _fraction: float
) -> void:
	if log == null or not course.takes_end():
		return
	event_occurred.emit(time_s, "end", String(ended))
	recognised = String(ended)
	course.gesture_end_s = time_s
	course.end_value_m = _stage.end_value(gesture_hmm.value)
	if not _stage.strokes_add_up or not is_nan(course.end_s):
		done.emit(time_s)


## A hand that turned back makes its trial again.
func _on_gesture_aborted(aborted: StringName, _task: GestureTask) -> void:
	if log == null:
		return
	event_occurred.emit(gesture_hmm.time, "abort", String(aborted))
	if is_nan(course.gesture_end_s):
		aborts += 1
		if not _stage.strokes_add_up:
			course = TrialCourse.new(false)


func _on_motion_updated(time_s: float) -> void:
	if log == null:
		return
	var way := _stage.show_motion(gesture_hmm.value)
	if is_nan(course.end_s) and not is_nan(course.start_s) and way >= _arrived:
		course.end_s = time_s
		_stage.mark_arrived()
	if is_recording:
		log.add(time_s, gesture_hmm, haptic_synth.get_amplitude())


func _process(_delta: float) -> void:
	_stage.show_hand(tracker)


func _on_tracking_lost() -> void:
	if log != null and is_recording:
		losses += 1
		event_occurred.emit(tracker.get_time(), "tracking_lost", "")


func _on_tracking_restored() -> void:
	if log != null and is_recording:
		event_occurred.emit(tracker.get_time(), "tracking_restored", "")
