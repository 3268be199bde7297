extends RefCounted
## Logs of a trial, written as it goes: TRIAL.log.csv has a row an instant, trials.csv a row a
## trial. A crash loses a second at most.

const Conditions := preload("conditions.gd")

const TRIALS_HEADER := "trial,gesture,position,condition,start_s,end_s,duration_s"
const FLUSH_INTERVAL_S := 1.0

var _folder := ""
var _trial := ""
var _gesture := ""
var _position := ""
var _samples: FileAccess = null
var _flushed_s := -INF


## `position`: "stable", "unstable" or empty.
func _init(folder: String, trial: String, gesture: String, position: String) -> void:
	_folder = folder
	_trial = trial
	_gesture = gesture
	_position = position
	DirAccess.make_dir_recursive_absolute(folder)
	var path := folder.path_join("%s.log.csv" % trial)
	_samples = FileAccess.open(path, FileAccess.WRITE)
	if _samples == null:
		var reason := error_string(FileAccess.get_open_error())
		push_error("%s: the trial is not logged: %s" % [path, reason])
		return
	_samples.store_line("# trial: %s" % trial)
	_samples.store_line("# gesture: %s" % gesture)
	_samples.store_line("# position: %s" % position)
	_samples.store_line(
		"t,condition,value,%s,progress,state,vibration" % ",".join(Conditions.NAMES)
	)


## The motion at `time_s` (s): values in m, `vibration` 0..1.
func add(time_s: float, condition: String, motion: GestureHMM, vibration: float) -> void:
	if _samples == null:
		return
	var row := "%.6f,%s,%.6f" % [time_s, condition, motion.value]
	for source in Conditions.MOTIONS:
		row += ",%.6f" % motion.get_motion_value(source)
	_samples.store_line(row + ",%.4f,%d,%.4f" % [motion.progress, motion.state, vibration])
	if time_s - _flushed_s >= FLUSH_INTERVAL_S:
		_samples.flush()
		_flushed_s = time_s


## `condition`: the last one of the trial; `start_s`, `end_s`: NAN where they never came.
func close(condition: String, start_s: float, end_s: float) -> void:
	_samples = null
	var path := _folder.path_join("trials.csv")
	var is_new := not FileAccess.file_exists(path)
	var trials := FileAccess.open(path, FileAccess.WRITE if is_new else FileAccess.READ_WRITE)
	if trials == null:
		return
	trials.seek_end()
	if is_new:
		trials.store_line(TRIALS_HEADER)
	var cells := [_trial, _gesture, _position, condition]
	cells.append_array([_seconds(start_s), _seconds(end_s), _seconds(end_s - start_s)])
	trials.store_csv_line(PackedStringArray(cells))


static func _seconds(time_s: float) -> String:
	return "" if is_nan(time_s) else "%.6f" % time_s
