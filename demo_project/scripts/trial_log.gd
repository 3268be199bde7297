extends RefCounted
## Logs of a trial, written during the trial: TRIAL.log.csv has a row per instant, trials.csv a row
## per trial. A crash loses a second at most.

const Conditions := preload("conditions.gd")
const Stored := preload("stored.gd")
const TrialCourse := preload("trial_course.gd")

## New columns are added at the end only, so that older programs still work.
const TRIALS_HEADER := (
	"trial,gesture,position,condition,start_s,end_s,duration_s"
	+ ",participant,amplitude_m,width_m,end_value_m,gesture_end_s,origin"
)
const FLUSH_INTERVAL_S := 1.0

var _folder := ""
var _trial: Dictionary = {}
var _samples: FileAccess = null
var _flushed_s := -INF
var _complained := false


## `trial`: {trial, gesture, position ("stable", "unstable" or empty), participant (empty: not
## named), amplitude_m, width_m (NAN: none), origin ("person", "mouse", "synthetic", "replay")}.
func _init(folder: String, trial: Dictionary) -> void:
	_folder = folder
	_trial = trial
	DirAccess.make_dir_recursive_absolute(folder)
	var path := folder.path_join("%s.log.csv" % trial["trial"])
	_samples = FileAccess.open(path, FileAccess.WRITE)
	if _samples == null:
		var reason := error_string(FileAccess.get_open_error())
		push_error("%s: the trial is not logged: %s" % [path, reason])
		return
	for key: String in ["trial", "gesture", "position", "participant", "origin"]:
		_samples.store_line("# %s: %s" % [key, trial[key]])
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
		_check(_samples)
		_flushed_s = time_s


## `condition`: the last one of the trial.
func close(condition: String, course: TrialCourse) -> void:
	if _samples != null:
		_check(_samples)
		_samples = null
	var path := _folder.path_join("trials.csv")
	var is_new := not FileAccess.file_exists(path)
	var trials := FileAccess.open(path, FileAccess.WRITE if is_new else FileAccess.READ_WRITE)
	if trials == null:
		push_error("%s: %s" % [path, error_string(FileAccess.get_open_error())])
		return
	trials.seek_end()
	if is_new:
		trials.store_line(TRIALS_HEADER)
	var row := PackedStringArray(
		[_trial["trial"], _trial["gesture"], _trial["position"], condition]
	)
	for time_s: float in [course.start_s, course.end_s, course.end_s - course.start_s]:
		row.append(_number(time_s))
	row.append(_trial["participant"])
	for number: float in [_trial["amplitude_m"], _trial["width_m"]]:
		row.append(_number(number))
	for number: float in [course.end_value_m, course.gesture_end_s]:
		row.append(_number(number))
	row.append(_trial["origin"])
	trials.store_csv_line(row)
	_check(trials)


## Reported once a trial.
func _check(file: FileAccess) -> void:
	if not Stored.is_written(file) and not _complained:
		_complained = true
		push_error("%s: rows are being lost; is the disk full?" % file.get_path())


static func _number(number: float) -> String:
	return "" if is_nan(number) else "%.6f" % number
