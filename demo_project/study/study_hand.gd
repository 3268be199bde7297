extends Node
## The hand of a study. This class is a person with any HandSource; others extend it.

## A simulated hand has made its last frame.
signal frames_over

const Origin := preload("res://scripts/origin.gd")
const Participant := preload("res://scripts/participant.gd")
const TrialTask := preload("res://scripts/trial_task.gd")

## As in session.json.
var origin := ""
var tracker := HandTracker.new()
## Null without one.
var reference: HandTracker = null

var _source: HandSource = null
var _participant: Participant = null
## Of the frames' clock from the engine's, s, by the newest frame. NAN: no frame has come.
var _clock_offset_s := NAN


## `source`: of the hand. `reference_source`: of a sensor to compare with; null: none.
func _init(source: HandSource = null, reference_source: HandSource = null) -> void:
	_source = source
	origin = Origin.of(source)
	tracker.autostart = false
	tracker.frame_received.connect(
		func(frame: HandFrame) -> void: _clock_offset_s = frame.time - _engine_s()
	)
	add_child(tracker)
	if reference_source != null:
		reference = HandTracker.new()
		reference.autostart = false
		reference.source = reference_source
		add_child(reference)


## Before the first trial.
func open(participant_id: String) -> Error:
	_participant = Participant.new(participant_id)
	tracker.source = _source
	if reference != null:
		reference.start()
	return tracker.start()


## Its settings for session.json.
func get_settings() -> Dictionary:
	var settings := _node_settings()
	settings["source"] = _describe(_source)
	settings["reference"] = "" if reference == null else "sensor"
	return settings


## Whether play() makes a whole trial at once.
func is_simulated() -> bool:
	return false


## Places the task of a trial. Returns the {start_s, end_s} of a simulated motion; empty: not known.
func prepare(trial: Dictionary, task: GestureTask) -> Dictionary:
	if trial["amplitude_m"] != null:
		task.amplitude = trial["amplitude_m"]
	if _participant.has_positions(trial["gesture"]):
		var middle := _participant.get_position(trial["gesture"], trial["position"])
		TrialTask.place_middle(task, middle)
	return {}


## Makes the trial that was prepared, if it is simulated.
func play() -> void:
	pass


## Whether the run's clock is known: the first frame sets it.
func has_clock() -> bool:
	return not is_nan(_clock_offset_s)


## The run's clock: the clock of the tracker's frames, also while none comes.
func now_s() -> float:
	return _engine_s() + _clock_offset_s


## Lets simulated time pass.
func wait(_seconds: float) -> void:
	pass


static func _engine_s() -> float:
	return 1e-6 * Time.get_ticks_usec()


## The task scenes keep these as they are.
static func _node_settings() -> Dictionary:
	var settings := {sensor_latency_s = _default(&"sensor_latency")}
	settings["mode"] = "phase" if _default(&"mode") == GestureHMM.MODE_PHASE else "paper"
	settings["quality"] = ["fast", "balanced", "accurate"][_default(&"quality")]
	return settings


static func _default(property: StringName) -> Variant:
	return ClassDB.class_get_property_default_value(&"GestureHMM", property)


static func _describe(source: HandSource) -> String:
	if source == null:
		return ""
	var script := source.get_script() as Script
	return source.get_class() if script == null else script.resource_path.get_file()
