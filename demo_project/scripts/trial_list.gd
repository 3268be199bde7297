extends RefCounted
## The trials of one gesture in a trial set, repeated in a loop.

## As TrialSet.get_trial().
var trial: Dictionary = {}
var measured_path := ""

var _set: TrialSet = null
var _indices: Array[int] = []
var _next := 0


func _init(folder: String, gesture: String) -> void:
	_set = TrialSet.load_folder(folder)
	if _set == null:
		return
	for index in _set.get_count():
		if _set.get_trial(index)["gesture"] == gesture:
			_indices.append(index)
	if _indices.is_empty():
		push_error("%s: no trial of gesture '%s'" % [folder, gesture])


func get_count() -> int:
	return _indices.size()


func advance() -> void:
	var index := _indices[_next]
	_next = (_next + 1) % _indices.size()
	trial = _set.get_trial(index)
	measured_path = _set.get_measured_path(index)
