extends RefCounted
## Tracker, GestureHMM and task on a recorded trial, stepped by the test.

const TrialTask := preload("res://scripts/trial_task.gd")

const STEP_S := 1e-3
const MODEL := "res://addons/steadyhand/models/%s.gesture"
const TIPS: Array[HandTracker.Joint] = [
	HandTracker.JOINT_THUMB, HandTracker.JOINT_INDEX, HandTracker.JOINT_MIDDLE
]
const MOTIONS: Array[GestureHMM.Motion] = [
	GestureHMM.MOTION_MEASURED,
	GestureHMM.MOTION_AVERAGE,
	GestureHMM.MOTION_ONE_EURO,
	GestureHMM.MOTION_KALMAN,
	GestureHMM.MOTION_SYNTHESISED,
]

var tracker := HandTracker.new()
var task := GestureTask.new()
var gesture_hmm := GestureHMM.new()


## `trial`: a row of TrialSet.get_trial(). `parent`: a node in the tree.
func _init(trial: Dictionary, track_path: String, parent: Node) -> void:
	var source := RecordedSource.new()
	source.track = track_path
	tracker.source = source
	tracker.update_mode = HandTracker.UPDATE_MANUAL
	tracker.autostart = false
	gesture_hmm.models = [load(MODEL % trial["gesture"]) as GestureModel]
	gesture_hmm.tracker = tracker
	gesture_hmm.task = task
	for node: Node in [tracker, task, gesture_hmm]:
		parent.add_child(node)
	TrialTask.apply(trial, task)


func free_nodes() -> void:
	for node: Node in [gesture_hmm, task, tracker]:
		node.free()


## Values of all conditions, one after the other at each instant from `first_step` to `last_step`
## (in steps of STEP_S), read at every `stride`th of them; the tracker is stepped as often.
func record(first_step: int, last_step: int, stride: int = 1) -> PackedFloat64Array:
	var values := PackedFloat64Array()
	tracker.start()
	for step in range(first_step, last_step + 1, stride):
		tracker.advance_to(step * STEP_S)
		for motion in MOTIONS:
			values.append(gesture_hmm.get_motion_value(motion))
	return values


## Synthetic trials of `gesture` in `folder`, one for each position and person.
static func write_trials(
	folder: String, subjects: int = 1, gesture: String = "horizontal_drag"
) -> TrialSet:
	var options := {
		population = "tune",
		gestures = [gesture],
		subjects = subjects,
		trials_per_subject = 1,
	}
	TrialSet.write_synthetic(folder, options)
	return TrialSet.load_folder(folder)
