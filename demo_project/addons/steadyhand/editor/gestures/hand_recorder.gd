@tool
extends Node
## Records a hand to a track file, from the source of a scene's HandTracker. The scene's own
## tracker stays closed: this node has one of its own, open only while it records.

signal finished
signal failed(reason: String)

const GameLink := preload("game_link.gd")
const Movements := preload("movements.gd")
const TrackCurves := preload("track_curves.gd")

## Length of the live curve, s.
const TRACE_S := 8.0
const COUNT_EVERY_MS := 1000
## Counting the movements takes at most 1 / COUNT_COST of the time.
const COUNT_COST := 20
const RUN_GAME := "Add debug_overlay.tscn to the scene, set its tracker, and run the scene."

## Index tip, m and s. INF: not tracked.
var trace_points := PackedVector3Array()
var trace_times := PackedFloat64Array()
var path := ""

var _tracker := HandTracker.new()
var _game_link: GameLink = null
var _is_game := false
var _count_due_ms := 0
var _movements := 0


func _init() -> void:
	_tracker.name = "GestureRecorder"
	_tracker.autostart = false
	_tracker.frame_received.connect(_on_frame)
	_tracker.failed.connect(func(reason: String) -> void: failed.emit(reason))
	_tracker.finished.connect(func() -> void: finished.emit())
	add_child(_tracker)


func set_game_link(link: GameLink) -> void:
	_game_link = link
	link.frame_received.connect(_on_game_frame)


## Opens the source of `scene_tracker`, or listens to the running game if that is null, and records
## to `to_path`. `take`: a simulated person makes another execution for each. Returns the error and
## what to do; empty if it records.
func begin(scene_tracker: HandTracker, to_path: String, take: int) -> String:
	_is_game = scene_tracker == null
	var source := ScriptSource.new() if _is_game else _own_source(scene_tracker, take)
	var error := _open(source, to_path)
	if error.is_empty() and _is_game:
		_game_link.record(true)
	return error


func end() -> void:
	if _is_game:
		_game_link.record(false)
	_tracker.stop_recording()
	_tracker.stop()


func get_tracker() -> HandTracker:
	return _tracker


func is_recording() -> bool:
	return _tracker.is_running()


## Counts those in the file so far. It counts again only sometimes: a long file takes time.
func count_movements(shape: Movements.Shape) -> int:
	var now_ms := Time.get_ticks_msec()
	if now_ms >= _count_due_ms:
		_movements = Movements.find(TrackCurves.read(path), shape).size()
		var taken_ms := Time.get_ticks_msec() - now_ms
		_count_due_ms = now_ms + maxi(COUNT_EVERY_MS, COUNT_COST * taken_ms)
	return _movements


## Such as "Hand tracked, 90 Hz, noise 0.3 mm". `scene_tracker`: the chosen one, or null.
func describe(scene_tracker: HandTracker) -> String:
	if not is_recording():
		var has_source := scene_tracker != null and scene_tracker.source != null
		return "%s, closed" % scene_tracker.source.get_class() if has_source else "No source"
	if _tracker.frame_rate <= 0.0:
		return "Waiting for the tracker's first frames"
	var text := "Hand tracked" if _tracker.is_hand_tracked() else "No hand in view"
	text += ", %.0f Hz" % _tracker.frame_rate
	if is_finite(_tracker.noise):
		text += ", noise %.2f mm" % (1e3 * _tracker.noise)
	var faults := _tracker.dropout_count + _tracker.freeze_count + _tracker.jump_count
	return text if faults == 0 else text + ", %d faults" % faults


## Why a tracker cannot be recorded, and what to do. Empty: it can.
static func advice_for(scene_tracker: HandTracker) -> String:
	if scene_tracker == null:
		return "Add a HandTracker to the scene and set its source."
	var source := scene_tracker.source
	if source == null:
		return "Set the source of '%s', for example to a LeapSource." % scene_tracker.name
	if source is XRSource:
		return "An XRSource has frames only in a running game. " + RUN_GAME
	var script := source.get_script() as Script
	if script != null and not script.is_tool():
		return "Put @tool at the top of %s: it has to run in the editor." % script.resource_path
	return ""


func _open(source: HandSource, to_path: String) -> String:
	trace_points.clear()
	trace_times.clear()
	_tracker.source = source
	path = to_path
	_movements = 0
	_count_due_ms = Time.get_ticks_msec() + COUNT_EVERY_MS
	var began := _tracker.start_recording(path)
	if began == OK:
		began = _tracker.start()
	if began != OK:
		_tracker.stop_recording()
		return "The source cannot be opened: see the Output panel."
	return ""


func _own_source(scene_tracker: HandTracker, take: int) -> HandSource:
	var simulated := scene_tracker.source as SyntheticSource
	if simulated == null:
		return scene_tracker.source
	var own := simulated.duplicate() as SyntheticSource
	own.seed += take
	if simulated.placement == SyntheticSource.PLACEMENT_TASK:
		var task := scene_tracker.get_node_or_null(simulated.task_path) as GestureTask
		if task != null:
			own.place_at(task)
	return own


func _on_game_frame(time_s: float, joints: Dictionary, confidence: float) -> void:
	if is_recording() and _is_game:
		_tracker.push_frame(time_s, joints, confidence)


func _on_frame(frame: HandFrame) -> void:
	var is_tracked := frame.has_joint(HandTracker.JOINT_INDEX)
	trace_times.append(frame.time)
	trace_points.append(
		frame.get_joint_position(HandTracker.JOINT_INDEX) if is_tracked else Vector3.INF
	)
	# Holds up to twice the time that is shown.
	if frame.time - trace_times[0] > 2.0 * TRACE_S:
		var from := trace_times.bsearch(frame.time - TRACE_S)
		trace_times = trace_times.slice(from)
		trace_points = trace_points.slice(from)
