extends RefCounted
## A participant's stable and unstable position for each task, as found by practice runs. They are
## kept in user://participants/NAME.json.

const Stored := preload("stored.gd")

## In the order of their blocks of trials.
const POSITIONS: Array[String] = ["stable", "unstable"]
const FIGURES: Array[String] = ["seconds", "lost_share", "noise"]

## The participant of this session. Empty: positions are kept as long as the scene.
static var chosen := ""

## Empty: no participant was named.
var name := ""
## The error of the file. Empty: none.
var error := ""

var _path := ""
var _tasks: Dictionary = {}


func _init(given: String = chosen, folder: String = "user://participants") -> void:
	name = given
	if name.is_empty():
		return
	_path = folder.path_join("%s.json" % name.validate_filename())
	var other := _in_other_case()
	if not other.is_empty():
		error = (
			"Participant '%s': there is '%s' already. Choose another name: case is not enough."
			% [name, other]
		)
		push_error("%s Positions are neither read nor kept." % error)
		_path = ""
		return
	if not FileAccess.file_exists(_path):
		return
	var json := JSON.new()
	if json.parse(FileAccess.get_file_as_string(_path)) != OK:
		error = "%s:%d: %s" % [_path, json.get_error_line() + 1, json.get_error_message()]
	elif not json.data is Dictionary:
		error = "%s: must be a JSON object with a key for each task" % _path
	else:
		_tasks = json.data
		for gesture: String in _tasks:
			for position in POSITIONS:
				if error.is_empty() and not _is_place(_tasks[gesture], position):
					error = (
						"%s: %s: '%s' has no position of three numbers" % [_path, gesture, position]
					)
	if not error.is_empty():
		_tasks = {}
		push_error("%s. The file stays as it is: make a practice run to get new positions" % error)


func has_positions(gesture: String) -> bool:
	return _tasks.has(gesture)


## Place for the middle of the task, m. `position`: one of POSITIONS. Only if has_positions().
func get_position(gesture: String, position: String) -> Vector3:
	var place: Array = _tasks[gesture][position]["position"]
	return Vector3(place[0], place[1], place[2])


## Keeps a proposal of TrackingSurvey.propose(), and writes it if a participant is named.
func keep(gesture: String, proposal: Dictionary) -> Error:
	var task := {contrast = proposal["contrast"], date = Time.get_datetime_string_from_system()}
	for position in POSITIONS:
		var place: Vector3 = proposal[position]["position"]
		task[position] = {position = [place.x, place.y, place.z]}
		for figure in FIGURES:
			task[position][figure] = proposal[position][figure]
	_tasks[gesture] = task
	return OK if _path.is_empty() else _write()


## The participant whose name differs only in upper and lower case. Empty: none.
func _in_other_case() -> String:
	var folder := _path.get_base_dir()
	if not DirAccess.dir_exists_absolute(folder):
		return ""
	var files := DirAccess.get_files_at(folder)
	return Stored.same_in_other_case(_path.get_file(), files).trim_suffix(".json")


## Writes a new file, which then replaces the old one. An unreadable old file is renamed and kept.
func _write() -> Error:
	DirAccess.make_dir_recursive_absolute(_path.get_base_dir())
	var part := _path + ".part"
	var file := FileAccess.open(part, FileAccess.WRITE)
	var result := FileAccess.get_open_error()
	if file != null:
		file.store_string(JSON.stringify(_tasks, "\t") + "\n")
		result = OK if Stored.is_written(file) else ERR_FILE_CANT_WRITE
		file.close()
		if result != OK:
			DirAccess.remove_absolute(part)
	if result == OK and not error.is_empty():
		result = DirAccess.rename_absolute(_path, "%s.%d.bad" % [_path, Time.get_ticks_usec()])
	if result == OK:
		result = DirAccess.rename_absolute(part, _path)
	if result == OK:
		error = ""
	else:
		push_error("%s: positions are not kept: %s" % [_path, error_string(result)])
	return result


static func _is_place(task: Variant, position: String) -> bool:
	if not (task is Dictionary and task.get(position) is Dictionary):
		return false
	var place: Variant = task[position].get("position")
	if not (place is Array and place.size() == 3):
		return false
	return place.all(func(number: Variant) -> bool: return number is float and is_finite(number))
