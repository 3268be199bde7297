@tool
extends RefCounted
## The takes of one gesture: a trial set in the project. A recording is on the disk at once, and no
## file is deleted: removing a take only removes its row of trials.csv.

signal changed

const Movements := preload("movements.gd")
const TrackCurves := preload("track_curves.gd")

## One folder a gesture. `.gdignore` in it keeps the editor from importing the tracks.
const ROOT := "res://gesture_takes"
const IGNORE := ".gdignore"
const TABLE := "trials.csv"
const MEASURED := ".measured.csv"
const REFERENCE := ".reference.csv"
const KEPT := ".bak"
## A recording that has not been split into takes yet.
const UNFINISHED := ".part.csv"
const RECORDING := "recording_"
const COLUMNS := (
	"trial,gesture,position,subject,start_s,end_s,"
	+ "start_x,start_y,start_z,axis_x,axis_y,axis_z,amplitude_m"
)
## A take holds this much before and after its movement, s, so that the trim can be widened.
const MARGIN_S := 1.0

var gesture := ""
var folder := ""
## With the keys of TrialSet.get_trial().
var rows: Array[Dictionary] = []
## Why the last operation failed, and what to do. Empty: it did not fail.
var error := ""
## The editor's. Null: nothing can be undone.
var undo_redo: EditorUndoRedoManager = null

var _curves: Dictionary[String, TrackCurves] = {}


func _init(of_gesture: String, root: String = ROOT) -> void:
	gesture = of_gesture
	folder = root.path_join(gesture)
	if not FileAccess.file_exists(folder.path_join(TABLE)):
		return
	var trials := TrialSet.load_folder(folder)
	if trials == null or trials.get_left_out_count() > 0:
		_keep_table()
	if trials != null:
		for i in trials.get_count():
			rows.append(trials.get_trial(i))


## Names of the gestures that have takes.
static func list(root: String = ROOT) -> PackedStringArray:
	return DirAccess.get_directories_at(root) if DirAccess.dir_exists_absolute(root) else []


## Why `name` cannot be a gesture's name, and what to do. Empty: it can.
static func name_fault(name: String) -> String:
	if name.is_empty():
		return "Name the gesture first, for example knock."
	if name == "none":
		return "'none' stands for no gesture: choose another name."
	if not name.is_valid_ascii_identifier():
		return "A gesture's name is letters, digits and _, for example knock_twice."
	return ""


## Makes the folder, and returns the path of a new recording. Empty, with `error`, if it fails.
func begin_recording() -> String:
	error = ""
	var made := DirAccess.make_dir_recursive_absolute(folder)
	var ignore := folder.get_base_dir().path_join(IGNORE)
	if made == OK and not FileAccess.file_exists(ignore):
		var file := FileAccess.open(ignore, FileAccess.WRITE)
		made = OK if file != null else FileAccess.get_open_error()
	if made != OK:
		error = "%s cannot be made: %s" % [folder, error_string(made)]
		return ""
	var number := 1
	for file in DirAccess.get_files_at(folder):
		if file.begins_with(RECORDING):
			number = maxi(number, file.trim_prefix(RECORDING).to_int() + 1)
	return folder.path_join("%s%03d%s" % [RECORDING, number, UNFINISHED])


## Splits a recording into takes and returns their rows: set_rows() adds them. With
## Shape.AUTOMATIC they get the shape of the existing takes.
func finish_recording(path: String, shape: Movements.Shape) -> Array[Dictionary]:
	error = ""
	var curves := TrackCurves.read(path)
	if shape == Movements.Shape.AUTOMATIC and not rows.is_empty():
		shape = Movements.shape_of(curves_of(0), rows[0])
	var others: Array[int] = []
	var found := Movements.find(curves, shape, others)
	var whole := path.trim_suffix(UNFINISHED)
	for i in found.size():
		found[i]["gesture"] = gesture
		found[i]["trial"] = "%s_%d" % [whole.get_file().trim_prefix(RECORDING), i + 1]
		if not _write_take(path, found[i]):
			return []
	DirAccess.rename_absolute(path, whole + ".csv")
	if curves.frames == 0:
		error = "The tracker sent no frame. Is the device connected, and its service running?"
	elif curves.count() == 0:
		error = "No frame held the index finger. Hold the hand where the tracker sees it."
	elif found.is_empty() and others[0] > 0:
		error = "The movement has the wrong direction. Open the fingers, or circle counterclockwise."
	elif found.is_empty():
		error = "No movement was found. Rest for half a second before and after the gesture."
	return found


## Rows of the recordings that were cut off when the editor closed.
func recover(shape: Movements.Shape) -> Array[Dictionary]:
	var found: Array[Dictionary] = []
	if DirAccess.dir_exists_absolute(folder):
		for file in DirAccess.get_files_at(folder):
			if file.ends_with(UNFINISHED):
				found.append_array(finish_recording(folder.path_join(file), shape))
	return found


## As set_rows(), but can be undone.
func change(title: String, new_rows: Array[Dictionary]) -> void:
	if undo_redo == null:
		set_rows(new_rows)
		return
	undo_redo.create_action(title, UndoRedo.MERGE_DISABLE, self)
	undo_redo.add_do_method(self, &"set_rows", new_rows)
	undo_redo.add_undo_method(self, &"set_rows", rows)
	undo_redo.commit_action()


## Replaces the takes, and writes the table.
func set_rows(new_rows: Array[Dictionary]) -> void:
	rows = new_rows
	error = (
		""
		if _write_table()
		else "%s cannot be written. Is the disk full?" % folder.path_join(TABLE)
	)
	changed.emit()


## The rows after the trim of one take. Empty, with `error`, if that leaves no gesture.
func trimmed(take: int, start_s: float, end_s: float) -> Array[Dictionary]:
	error = ""
	var curves := curves_of(take)
	var row := Movements.describe(curves, Movements.shape_of(curves, rows[take]), start_s, end_s)
	if not row["amplitude_m"] > 0.0:
		error = "No movement is left between these times. Drag the edges farther apart."
		return []
	for key: String in ["trial", "gesture", "subject", "position"]:
		row[key] = rows[take][key]
	var changed_rows := rows.duplicate()
	changed_rows[take] = row
	return changed_rows


## The detected start and end of the movement: start_s and end_s.
func proposed_trim(take: int) -> PackedFloat64Array:
	var curves := curves_of(take)
	var row := rows[take]
	var middle_s: float = 0.5 * (row["start_s"] + row["end_s"])
	var best := PackedFloat64Array([row["start_s"], row["end_s"]])
	for found in Movements.find_all(curves, Movements.shape_of(curves, row)):
		if found["start_s"] <= middle_s and found["end_s"] >= middle_s:
			best = PackedFloat64Array([found["start_s"], found["end_s"]])
	return best


func curves_of(take: int) -> TrackCurves:
	var path := measured_path(take)
	if path not in _curves:
		_curves[path] = TrackCurves.read(path)
	return _curves[path]


func measured_path(take: int) -> String:
	return folder.path_join(rows[take]["trial"] + MEASURED)


func feature_of(take: int) -> String:
	return Movements.FEATURES[Movements.shape_of(curves_of(take), rows[take])]


## Copies the recording's lines around the movement: as measured and as reference track.
func _write_take(recording: String, row: Dictionary) -> bool:
	var kept := PackedStringArray()
	var is_header := true
	for line in FileAccess.get_file_as_string(recording).split("\n", false):
		var time_s := line.get_slice(",", 0).to_float()
		var is_near: bool = (
			time_s >= row["start_s"] - MARGIN_S and time_s <= row["end_s"] + MARGIN_S
		)
		if is_header or is_near:
			kept.append(line)
		is_header = is_header and not line.begins_with("t,")
	var path := folder.path_join(row["trial"])
	for ending: String in [MEASURED, REFERENCE]:
		if not _write(path + ending, "\n".join(kept) + "\n"):
			error = "%s cannot be written. The recording is kept: %s" % [path + ending, recording]
			return false
	return true


## Writes the table without unreadable rows, and keeps a copy of the old one.
func _keep_table() -> void:
	var table := folder.path_join(TABLE)
	DirAccess.copy_absolute(table, table + KEPT)
	error = "Rows of %s cannot be read: see the Output panel. A copy is kept as %s." % [table, KEPT]


func _write_table() -> bool:
	var lines := PackedStringArray([COLUMNS])
	for row in rows:
		var cells: Array = [row["trial"], row["gesture"], row["position"], row["subject"]]
		cells += [row["start_s"], row["end_s"]]
		var start: Vector3 = row["start"]
		var axis: Vector3 = row["axis"]
		if axis.is_zero_approx():
			cells += [start.x, "", "", "", "", ""]
		else:
			cells += [start.x, start.y, start.z, axis.x, axis.y, axis.z]
		cells.append(row["amplitude_m"])
		lines.append(",".join(cells.map(str)))
	return _write(folder.path_join(TABLE), "\n".join(lines) + "\n")


## The old file stays whole until the new one is complete.
static func _write(path: String, text: String) -> bool:
	var file := FileAccess.open(path + ".new", FileAccess.WRITE)
	if file == null:
		return false
	var is_written := file.store_string(text)
	file.close()
	return is_written and DirAccess.rename_absolute(path + ".new", path) == OK
