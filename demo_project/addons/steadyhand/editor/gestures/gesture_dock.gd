@tool
extends "gesture_panels.gd"
## The "Gestures" panel of the editor: records takes of a gesture, trims them, trains a model and
## saves it. Everything that a button does is a public function.

signal training_finished
signal comparison_finished

const GameLink := preload("game_link.gd")
const HandRecorder := preload("hand_recorder.gd")
const ModelComparison := preload("model_comparison.gd")
const ModelTraining := preload("model_training.gd")
const NextStep := preload("next_step.gd")
const TakeSet := preload("take_set.gd")

## Null while no gesture is open.
var takes: TakeSet = null
var model: GestureModel = null
## The editor's. Null: nothing can be undone.
var undo_redo: EditorUndoRedoManager = null
## Where takes are kept.
var root_folder := TakeSet.ROOT

var _recorder := HandRecorder.new()
var _training := ModelTraining.new()
var _comparison := ModelComparison.new()
var _scene_root: Node = null
var _saved_to := ""


func _init() -> void:
	super()
	for node: Node in [_recorder, _training, _comparison]:
		add_child(node)
	_recorder.finished.connect(stop_recording)
	_recorder.failed.connect(_on_recorder_failed)
	_training.progressed.connect(_model_panel.show_progress)
	_training.finished.connect(_on_trained)
	_comparison.progressed.connect(_model_panel.show_progress)
	_comparison.finished.connect(_on_compared)
	_record_panel.gesture_chosen.connect(_on_gesture_chosen)
	_record_panel.record_pressed.connect(toggle_recording)
	_take_panel.trim_changed.connect(trim_take)
	_take_panel.trim_proposed.connect(propose_trim)
	_take_panel.delete_pressed.connect(delete_takes)
	_model_panel.train_pressed.connect(train)
	_model_panel.cancel_pressed.connect(cancel_training)
	_model_panel.compare_pressed.connect(compare)
	_model_panel.save_chosen.connect(save)


func _ready() -> void:
	_record_panel.list_gestures(TakeSet.list(root_folder))
	_take_panel.show_takes(null)
	_update()


## A game that runs from this editor may be recorded from, too.
func set_game_link(link: GameLink) -> void:
	_recorder.set_game_link(link)
	link.game_started.connect(_on_game_changed)
	link.game_ended.connect(_on_game_changed.bind(""))


## The HandTrackers of `scene_root` may be recorded from; null: there is no scene.
func set_scene(scene_root: Node) -> void:
	_scene_root = scene_root
	if not _recorder.is_recording():
		_record_panel.list_trackers(scene_root)
		_update()


## Loads its takes, and those of a recording that was cut off when the editor closed.
func open_gesture(gesture: String) -> void:
	stop_recording()
	cancel_training()
	model = null
	takes = null
	_saved_to = ""
	var fault := TakeSet.name_fault(gesture)
	_show_message("" if gesture.is_empty() else fault)
	if fault.is_empty():
		takes = TakeSet.new(gesture, root_folder)
		takes.undo_redo = undo_redo
		takes.changed.connect(_on_takes_changed)
		_show_message(takes.error)
		var recovered := takes.recover(_record_panel.shape)
		if not recovered.is_empty():
			takes.set_rows(takes.rows + recovered)
			_show_message("%d takes of a recording that was cut off are back." % recovered.size())
	_record_panel.show_gesture(gesture)
	_model_panel.view.show_model(null, [])
	_take_panel.show_takes(takes)
	_update()


func toggle_recording() -> void:
	if _recorder.is_recording():
		stop_recording()
	else:
		start_recording()


## Whether it records. If not, the panel says why.
func start_recording() -> bool:
	if takes == null:
		_show_message(TakeSet.name_fault(_record_panel.gesture()))
		return false
	var error := _advice()
	if error.is_empty():
		var path := takes.begin_recording()
		error = takes.error
		if error.is_empty():
			error = _recorder.begin(_record_panel.tracker(), path, takes.rows.size())
	_show_message(error)
	_update()
	return error.is_empty()


## Splits what was recorded into takes.
func stop_recording() -> void:
	if not _recorder.is_recording():
		return
	_recorder.end()
	var found := takes.finish_recording(_recorder.path, _record_panel.shape)
	_show_message(takes.error)
	_record_panel.list_gestures(TakeSet.list(root_folder))
	if not found.is_empty():
		takes.change("Record %d Takes of %s" % [found.size(), takes.gesture], takes.rows + found)
		_take_panel.select(takes.rows.size() - 1)
	else:
		_take_panel.show_takes(takes)
	_update()


func trim_take(take: int, start_s: float, end_s: float) -> void:
	var rows := takes.trimmed(take, start_s, end_s)
	_show_message(takes.error)
	if rows.is_empty():
		_take_panel.show_takes(takes)
	else:
		takes.change("Trim Take %s" % takes.rows[take]["trial"], rows)


## Where the movement itself begins and ends.
func propose_trim(take: int) -> void:
	var trim := takes.proposed_trim(take)
	trim_take(take, trim[0], trim[1])


func delete_takes(which: PackedInt32Array) -> void:
	var rows: Array[Dictionary] = []
	for i in takes.rows.size():
		if i not in which:
			rows.append(takes.rows[i])
	takes.change("Delete %d Takes of %s" % [which.size(), takes.gesture], rows)


## Emits `training_finished`.
func train() -> void:
	if takes == null or takes.rows.is_empty():
		_show_model_message("Record some takes first.")
		training_finished.emit.call_deferred()
		return
	_show_message("")
	_model_panel.show_progress(0.0)
	_training.begin(takes.folder, takes.gesture, takes.feature_of(0))
	_update()


func cancel_training() -> void:
	_training.cancel()


## Emits `comparison_finished`.
func compare() -> void:
	_show_message("")
	_model_panel.show_progress(0.0)
	_comparison.begin(model, root_folder)
	_update()


func save(path: String) -> Error:
	DirAccess.make_dir_recursive_absolute(path.get_base_dir())
	var saved := ResourceSaver.save(model, path)
	if saved == OK:
		_saved_to = path
		model.take_over_path(path)
		_show_message("")
		EditorInterface.get_resource_filesystem().scan()
	else:
		_show_model_message("%s cannot be written: %s." % [path, error_string(saved)])
	_update()
	return saved


## What to do next.
func hint() -> String:
	if _recorder.is_recording():
		return NextStep.while_recording(_recorder.count_movements(_record_panel.shape))
	return NextStep.of(_advice(), _record_panel.gesture(), takes, model, _saved_to)


func get_recorder() -> HandRecorder:
	return _recorder


func _process(_delta: float) -> void:
	if not _recorder.is_recording():
		return
	_show_state()
	_take_panel.view.show_trace(_recorder.trace_times, _recorder.trace_points)


## Why nothing can be recorded, and what to do. Empty: recording is possible.
func _advice() -> String:
	if _record_panel.is_game_chosen():
		return ""
	return HandRecorder.advice_for(_record_panel.tracker())


func _on_game_changed(tracker_name: String) -> void:
	stop_recording()
	if not is_instance_valid(_scene_root):
		_scene_root = null
	_record_panel.show_game(tracker_name, _scene_root)
	_update()


func _on_gesture_chosen(gesture: String) -> void:
	if takes == null or takes.gesture != gesture:
		open_gesture(gesture)


func _on_takes_changed() -> void:
	_take_panel.show_takes(takes)
	_show_message(takes.error)
	_update()


func _on_recorder_failed(reason: String) -> void:
	stop_recording.call_deferred()
	_show_message.call_deferred(reason)


func _on_trained(trained: GestureModel) -> void:
	if trained != null:
		model = trained
		_saved_to = ""
		_model_panel.file_name = model.gesture
		_model_panel.view.show_model(model, _training.recordings)
		_model_panel.show_tab(_model_panel.view)
	_show_model_message(_training.error)
	_take_panel.mark(_training.recordings)
	_update()
	training_finished.emit()


func _on_compared(table: Dictionary) -> void:
	_model_panel.confusion.show_table(table, _comparison.left_out)
	_model_panel.show_tab(_model_panel.confusion)
	_update()
	comparison_finished.emit()


func _update() -> void:
	var has_takes := takes != null and not takes.rows.is_empty()
	_model_panel.show_state(
		has_takes, model != null, _training.is_training(), _comparison.is_comparing()
	)
	_show_state()


func _show_state() -> void:
	var state := _recorder.describe(_record_panel.tracker())
	if _record_panel.is_game_chosen() and not _recorder.is_recording():
		state = "The game runs"
	_record_panel.show_state(state, hint(), _recorder.is_recording())
