@tool
extends Node
## Trains a model in a thread of its own.

signal progressed(done: float)
## `model` is null if the training failed or was cancelled.
signal finished(model: GestureModel)

## Why the last training gave no model, and what to do. Empty: it gave one.
var error := ""
## GestureTrainer.get_recordings() of the last training.
var recordings: Array[Dictionary] = []

var _trainer := GestureTrainer.new()
var _thread: Thread = null


func _init() -> void:
	_trainer.progressed.connect(_on_progressed)


func _exit_tree() -> void:
	cancel()
	_join()


func begin(folder: String, gesture: String, feature: String) -> void:
	if is_training():
		return
	_join()
	error = ""
	_trainer.feature = feature
	_thread = Thread.new()
	_thread.start(_train.bind(folder, gesture))


func is_training() -> bool:
	return _thread != null and _thread.is_alive()


func cancel() -> void:
	_trainer.cancel()


func _train(folder: String, gesture: String) -> void:
	var trials := TrialSet.load_folder(folder)
	var model: GestureModel = null
	if trials != null:
		model = _trainer.train(trials, gesture)
	_end.call_deferred(model, trials != null)


func _end(model: GestureModel, has_trials: bool) -> void:
	_join()
	recordings = _trainer.get_recordings()
	if not has_trials:
		error = "The takes cannot be read: see the Output panel."
	elif model == null and not _trainer.is_cancelled():
		error = _trainer.error_message + _advice()
	finished.emit(model)


func _advice() -> String:
	for recording in recordings:
		if not (recording["oddity"] as String).is_empty():
			return "\nDelete the takes that are marked, or trim them, and train again."
	return ""


func _join() -> void:
	if _thread != null:
		_thread.wait_to_finish()
		_thread = null


## Called in the thread.
func _on_progressed(done: float) -> void:
	progressed.emit.call_deferred(done)
