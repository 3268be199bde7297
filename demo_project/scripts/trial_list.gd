extends RefCounted
## The trials of one gesture in a trial set, round and round.

const SYNTHETIC_FOLDER := "user://synthetic_trials"

## As of TrialSet.get_trial().
var trial: Dictionary = {}
var measured_path := ""

var _set: TrialSet = null
var _indices: Array[int] = []
var _next := 0


## `folder`: a trial set; empty: one is made of synthetic people.
func _init(folder: String, gesture: String) -> void:
	if folder.is_empty():
		folder = ProjectSettings.globalize_path(SYNTHETIC_FOLDER)
		TrialSet.write_synthetic(
			folder,
			{population = "evaluate", gestures = [gesture], subjects = 3, trials_per_subject = 2}
		)
	_set = TrialSet.load_folder(folder)
	if _set == null:
		return
	for index in _set.get_count():
		if _set.get_trial(index)["gesture"] == gesture:
			_indices.append(index)


func is_empty() -> bool:
	return _indices.is_empty()


func size() -> int:
	return _indices.size()


func advance() -> void:
	var index := _indices[_next]
	_next = (_next + 1) % _indices.size()
	trial = _set.get_trial(index)
	measured_path = _set.get_measured_path(index)
