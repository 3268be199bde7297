extends "study_hand.gd"
## A simulated person, faster than real time. The study's tracker gets the frames of a simulated
## tracker, the reference tracker the hand's own motion, both on the run's clock.

## How long the person takes to get ready for the next trial, s.
const BETWEEN_S := 1.0
const STEP_S := 0.01
## The hand is lost for this time after the last frame: an active gesture ends or is aborted.
const AFTER_S := 1.0

## Which person; see SyntheticSource.subject.
var subject := 0
var seed := 0

var _seen: HandTracker = null
var _true: HandTracker = null
var _clock_s := 0.0
var _offset_s := 0.0
var _end_s := 0.0


func _init() -> void:
	super(ScriptSource.new(), ScriptSource.new())
	origin = "synthetic"
	tracker.update_mode = HandTracker.UPDATE_MANUAL
	reference.update_mode = HandTracker.UPDATE_MANUAL
	_seen = _make_inner(tracker)
	_true = _make_inner(reference)


func open(_participant_id: String) -> Error:
	tracker.source = _source
	return OK


func get_settings() -> Dictionary:
	var settings := _node_settings()
	settings["source"] = "SyntheticSource"
	settings["reference"] = "truth"
	settings["subject"] = subject
	return settings


func is_simulated() -> bool:
	return true


func prepare(trial: Dictionary, task: GestureTask) -> Dictionary:
	var source := _make_source(trial)
	var made := source.get_trial()
	if trial["amplitude_m"] != null:
		TrialTask.apply(made, task)
		task.amplitude = trial["amplitude_m"]
		source.place_at(task)
		made = source.get_trial()
	TrialTask.apply(made, task)
	var true_source := source.duplicate() as SyntheticSource
	true_source.true_motion = true
	_seen.source = source
	_true.source = true_source
	for started: HandTracker in [tracker, reference, _seen, _true]:
		started.start()
	# Control instants stay on whole milliseconds.
	_offset_s = ceilf(_clock_s + BETWEEN_S) - floorf(_seen.get_start_time())
	_clock_s = _offset_s + _seen.get_start_time()
	_end_s = _offset_s + maxf(_seen.get_start_time() + _seen.get_duration(), made["end_s"])
	return {start_s = _offset_s + made["start_s"], end_s = _offset_s + made["end_s"]}


func play() -> void:
	while not _seen.is_finished() or not _true.is_finished():
		_clock_s += STEP_S
		_true.advance_to(_clock_s - _offset_s)
		_seen.advance_to(_clock_s - _offset_s)
	frames_over.emit()
	_clock_s = maxf(_clock_s, _end_s + AFTER_S)
	tracker.advance_to(_clock_s)


func has_clock() -> bool:
	return true


func now_s() -> float:
	return _clock_s


func wait(seconds: float) -> void:
	_clock_s += seconds


## Equal people and trials give equal frames, whichever run makes them.
func _make_source(trial: Dictionary) -> SyntheticSource:
	var source := SyntheticSource.new()
	source.gesture = trial["gesture"]
	source.subject = subject
	source.seed = seed * 10000 + int(trial["trial"])
	source.position = (
		SyntheticSource.POSITION_STABLE
		if trial["position"] == "stable"
		else SyntheticSource.POSITION_UNSTABLE
	)
	return source


func _make_inner(outer: HandTracker) -> HandTracker:
	var inner := HandTracker.new()
	inner.autostart = false
	inner.update_mode = HandTracker.UPDATE_MANUAL
	inner.frame_received.connect(
		func(frame: HandFrame) -> void:
			outer.push_frame(_offset_s + frame.time, frame.get_joints(), frame.confidence)
	)
	add_child(inner)
	return inner
