@tool
extends Node
## Runs the takes of all gestures through a GestureHMM with all models of the project, without a
## task, some at each frame of the editor.

signal progressed(done: float)
## As MotionMetrics.confusion(). Empty: there was nothing to compare.
signal finished(table: Dictionary)

const TakeSet := preload("take_set.gd")

const NONE := "none"
## Time per frame of the editor, ms.
const BUDGET_MS := 12
const STEP_S := 0.01
## The track goes on for this time after a gesture, because its end is reported later.
const AFTER_S := 1.5

## Gestures that are measured from a task's start, and so are never recognised without one.
var left_out := PackedStringArray()

var _models: Array[GestureModel] = []
var _waiting: Array[Dictionary] = []
var _count := 0
var _done := PackedStringArray()
var _recognised := PackedStringArray()


func _ready() -> void:
	set_process(is_comparing())


## `trained`: replaces the project's model of its gesture; may be null.
func begin(trained: GestureModel, root: String = TakeSet.ROOT) -> void:
	_models = []
	left_out = []
	for model in _with(trained, project_models()):
		if model.feature == "index_along_circle":
			left_out.append(model.gesture)
		else:
			_models.append(model)
	_waiting = []
	_done = []
	_recognised = []
	for gesture in TakeSet.list(root):
		var takes := TakeSet.new(gesture, root)
		for i in takes.rows.size():
			_waiting.append({row = takes.rows[i], track = takes.measured_path(i)})
	_count = _waiting.size()
	if is_inside_tree():
		set_process(true)


func is_comparing() -> bool:
	return not _waiting.is_empty()


func _process(_delta: float) -> void:
	var began_ms := Time.get_ticks_msec()
	while is_comparing() and Time.get_ticks_msec() - began_ms < BUDGET_MS:
		var take: Dictionary = _waiting.pop_back()
		_done.append(take["row"]["gesture"])
		_recognised.append(recognise(take["track"], take["row"], _models))
	progressed.emit(1.0 - float(_waiting.size()) / maxi(_count, 1))
	if not is_comparing():
		set_process(false)
		finished.emit({} if _done.is_empty() else MotionMetrics.confusion(_done, _recognised))


## Name of the gesture that ends during the take's movement, or NONE.
static func recognise(track: String, row: Dictionary, models: Array[GestureModel]) -> String:
	if models.is_empty():
		return NONE
	var source := RecordedSource.new()
	source.track = track
	var tracker := HandTracker.new()
	tracker.source = source
	tracker.update_mode = HandTracker.UPDATE_MANUAL
	var hmm := GestureHMM.new()
	hmm.models = models
	hmm.tracker = tracker
	var ended := [NONE]
	hmm.gesture_ended.connect(
		func(gesture: StringName, time_s: float, _task: GestureTask, _fraction: float) -> void:
			if time_s > row["start_s"]:
				ended[0] = String(gesture)
	)
	if tracker.start() == OK:
		var time_s := tracker.get_start_time()
		while time_s < row["end_s"] + AFTER_S:
			time_s += STEP_S
			tracker.advance_to(time_s)
	hmm.free()
	tracker.free()
	return ended[0]


## Every *.gesture of the project, one for each gesture.
static func project_models(folder: String = "res://") -> Array[GestureModel]:
	var models: Array[GestureModel] = []
	if FileAccess.file_exists(folder.path_join(TakeSet.IGNORE)):
		return models
	for file in DirAccess.get_files_at(folder):
		if file.get_extension() == "gesture":
			models = _with(GestureModel.load_file(folder.path_join(file)), models)
	for child in DirAccess.get_directories_at(folder):
		if not child.begins_with("."):
			for model in project_models(folder.path_join(child)):
				models = _with(model, models)
	return models


static func _with(model: GestureModel, models: Array[GestureModel]) -> Array[GestureModel]:
	if model == null:
		return models
	var others := models.filter(
		func(other: GestureModel) -> bool: return other.gesture != model.gesture
	)
	others.append(model)
	return others
