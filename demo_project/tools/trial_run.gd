extends RefCounted
## Runs one trial through the real nodes. Gives the curves of all conditions and of the reference at
## 1 kHz, and their figures.

const Conditions := preload("res://scripts/conditions.gd")
const RecordedHand := preload("recorded_hand.gd")
const TrialTask := preload("res://scripts/trial_task.gd")

const RATE_HZ := 1000.0
const REFERENCE := "reference"
const NO_GESTURE := "none"
## Time stamps are decimal text: a time this near to a whole ms counts as whole (in ms).
const ROUNDING_MS := 1e-6
## After a record the hand is lost for this time, so that an active gesture ends or is aborted.
const AFTER_S := 1.5
## A damaged time stamp would need more memory than there is.
const LONGEST_RECORD_S := 6.0 * 3600.0
## Smoothness takes quadratic time: 4 s per curve here, and hours for stamps in milliseconds.
const LONGEST_GESTURE_S := 120.0

## The error of the trial or its files. Empty: none.
var error := ""
## The error is in the log already.
var is_reported := false
## A warning about a trial that is evaluated. Empty: none.
var note := ""
## The gesture that was recognised to its end, or NO_GESTURE.
var recognised := NO_GESTURE
## Each gesture that was recognised to its end, right or wrong: {gesture, time_s}.
var ends: Array[Dictionary] = []
## Number of gestures that started, ended or not.
var begun := 0
## Number of instants of the curves with an active gesture.
var under_way := 0
## First instant of the curves, whole milliseconds on the trial's clock.
var first_ms := 0
## Number of instants, 1 ms apart; they span the reference's record.
var count := 0
## Samples by condition (and REFERENCE), in units of the task's amplitude; in metres without a task.
## REFERENCE is missing without a task, or without a model, which names the feature.
var curves: Dictionary[String, PackedFloat64Array] = {}
## Result of MotionMetrics.compare() by condition. Empty: REFERENCE is missing.
var figures: Dictionary[String, Dictionary] = {}

## Row of the trial whose task the scene has. Default: the trial itself. Empty: no task.
var task_trial: Dictionary
## Of GestureHMM.
var sensor_latency_s := 0.0
var min_confidence := 0.0

var _trial: Dictionary
var _parent: Node


## `trial`: a row of TrialSet.get_trial(). `parent`: a node in the tree, for the time of the run.
func _init(trial: Dictionary, parent: Node) -> void:
	_trial = trial
	_parent = parent
	task_trial = {} if trial["gesture"] == NO_GESTURE else trial


## `models`: the available models. `in_scene`: only the model of task_trial's gesture is active, and
## the task's place is given.
func run(
	measured_path: String,
	reference_path: String,
	models: Array[GestureModel],
	mode: GestureHMM.Mode,
	in_scene: bool
) -> void:
	var gesture: String = _trial["gesture"]
	var own := _models_of(gesture, models)
	var has_task := in_scene and not task_trial.is_empty()
	if not _has_amplitude():
		return
	var reference := _load(reference_path)
	if reference == null or not _span(reference):
		return
	if not own.is_empty() and not _measure_reference(reference, own[0].feature):
		return
	var measured := _load(measured_path)
	if measured == null or not _overlaps(measured):
		return
	var tracker := RecordedHand.make_of(measured)
	_parent.add_child(tracker)
	tracker.start()
	var task := _make_task() if has_task else null
	var hmm := GestureHMM.new()
	hmm.mode = mode
	hmm.sensor_latency = sensor_latency_s
	hmm.min_confidence = min_confidence
	hmm.models = _models_of(task_trial["gesture"], models) if has_task else models
	hmm.name = (_trial["trial"] as String).validate_node_name()
	var unseen := _unseen_feature(measured, hmm.models)
	# Avoids a warning at each trial that nothing is recognised.
	hmm.tracker = null if hmm.models.is_empty() or not unseen.is_empty() else tracker
	hmm.task = task
	# A hand that stops before its target has finished the trial, too.
	hmm.completion = 0.5
	hmm.gesture_ended.connect(
		func(ended: StringName, time_s: float, _task: GestureTask, _fraction: float) -> void:
			ends.append({gesture = String(ended), time_s = time_s})
	)
	hmm.gesture_started.connect(func(_gesture: StringName, _task: GestureTask) -> void: begun += 1)
	_parent.add_child(hmm)

	_record(tracker, hmm, 1.0 if gesture == NO_GESTURE else _trial["amplitude_m"])
	if not hmm.recognised.is_empty():
		recognised = hmm.recognised
	if not own.is_empty():
		_compare()
		note = MotionMetrics.recording_oddity(measured, reference, own[0].feature, _trial)
	elif not unseen.is_empty():
		note = "its measured track has no motion of %s" % unseen
	if not note.is_empty():
		note += ": %s" % (reference_path if note.begins_with("its reference") else measured_path)

	for node: Node in [hmm, task, tracker]:
		if node != null:
			node.free()


static func _models_of(gesture: String, models: Array[GestureModel]) -> Array[GestureModel]:
	return models.filter(func(model: GestureModel) -> bool: return model.gesture == gesture)


## A custom gesture may have no amplitude, and its curves then have no unit.
func _has_amplitude() -> bool:
	if _trial["gesture"] == NO_GESTURE or _trial["amplitude_m"] > 0.0:
		return true
	error = "it has no amplitude_m to measure its motion by"
	return false


## Missing parts of the reference would count as a hand at rest.
func _span(reference: RecordedTrack) -> bool:
	var begin_ms := RATE_HZ * reference.get_start_time()
	var end_ms := begin_ms + RATE_HZ * reference.get_duration()
	if end_ms - begin_ms > RATE_HZ * LONGEST_RECORD_S:
		error = (
			"its reference lasts %.0f s; at most %.0f s can be judged: %s"
			% [(end_ms - begin_ms) / RATE_HZ, LONGEST_RECORD_S, reference.get_path()]
		)
		return false
	first_ms = ceili(begin_ms - ROUNDING_MS)
	count = maxi(floori(end_ms + ROUNDING_MS) - first_ms + 1, 0)
	if _trial["gesture"] == NO_GESTURE:
		return true
	var start_s: float = _trial["start_s"]
	var end_s: float = _trial["end_s"]
	if RATE_HZ * start_s < begin_ms - ROUNDING_MS or RATE_HZ * end_s > end_ms + ROUNDING_MS:
		error = (
			"start_s %.6f .. end_s %.6f is not within the reference, %.6f .. %.6f s: %s"
			% [start_s, end_s, begin_ms / RATE_HZ, end_ms / RATE_HZ, reference.get_path()]
		)
	elif end_s - start_s > LONGEST_GESTURE_S:
		error = (
			"its gesture lasts %.0f s; at most %.0f s can be judged (are its times in seconds?)"
			% [end_s - start_s, LONGEST_GESTURE_S]
		)
	return error.is_empty()


## Frames on another clock would count as a hand that is never tracked.
func _overlaps(measured: RecordedTrack) -> bool:
	var begin_s := measured.get_start_time()
	var end_s := begin_s + measured.get_duration()
	var from_s := first_ms / RATE_HZ
	var to_s := from_s + count / RATE_HZ
	if begin_s <= to_s and end_s >= from_s:
		return true
	error = (
		"its measured track, %.6f .. %.6f s, is not on the clock of its reference, %.6f .. %.6f s: %s"
		% [begin_s, end_s, from_s, to_s, measured.get_path()]
	)
	return false


func _measure_reference(reference: RecordedTrack, feature: String) -> bool:
	var curve := _feature_curve(reference, feature)
	if _is_blank(curve):
		error = "the reference holds no motion of %s: %s" % [feature, reference.get_path()]
		return false
	curves[REFERENCE] = curve
	return true


func _feature_curve(
	track: RecordedTrack, feature: String, trial: Dictionary = _trial
) -> PackedFloat64Array:
	return MotionMetrics.feature_curve(track, feature, trial, first_ms / RATE_HZ, RATE_HZ, count)


## The feature of the only expected gesture, if the track has no motion of it.
func _unseen_feature(measured: RecordedTrack, waited_for: Array[GestureModel]) -> String:
	if waited_for.size() != 1 or task_trial.is_empty():
		return ""
	var feature := waited_for[0].feature
	return feature if _is_blank(_feature_curve(measured, feature, task_trial)) else ""


## A curve that is always 0 has no tracked hand: sensors are never that exact.
static func _is_blank(curve: PackedFloat64Array) -> bool:
	return curve.count(0.0) == curve.size()


func _record(tracker: HandTracker, hmm: GestureHMM, unit_m: float) -> void:
	var motions := Conditions.MOTIONS
	var samples := PackedFloat64Array()
	samples.resize(motions.size() * count)
	for i in count:
		tracker.advance_to((first_ms + i) / RATE_HZ)
		under_way += 0 if hmm.gesture.is_empty() else 1
		var place := i
		for motion in motions:
			samples[place] = hmm.get_motion_value(motion) / unit_m
			place += count
	tracker.advance_to((first_ms + count) / RATE_HZ + AFTER_S)
	for c in motions.size():
		curves[Conditions.NAMES[c]] = samples.slice(c * count, (c + 1) * count)


func _compare() -> void:
	var t0_s := first_ms / RATE_HZ
	for condition in Conditions.NAMES:
		figures[condition] = MotionMetrics.compare(
			curves[REFERENCE], curves[condition], RATE_HZ, t0_s, _trial["start_s"], _trial["end_s"]
		)


func _make_task() -> GestureTask:
	var task := GestureTask.new()
	_parent.add_child(task)
	TrialTask.apply(task_trial, task)
	return task


## Null, with `error`: it cannot be read.
func _load(path: String) -> RecordedTrack:
	var track := RecordedTrack.load_file(path)
	if track == null:
		error = "cannot read %s" % path
		is_reported = true
	return track
