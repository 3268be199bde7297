extends RefCounted
## The files of an evaluation. Each trial gives TRIAL.curves.csv and a row of results.csv.part. At
## the end this file becomes results.csv, and summary.json is written. Files of an earlier
## evaluation are removed first.

const Conditions := preload("res://scripts/conditions.gd")
const Stored := preload("res://scripts/stored.gd")
const TrialRun := preload("trial_run.gd")

const RESULTS := "results.csv"
const PART := "results.csv.part"
const SUMMARY := "summary.json"
const CURVES := "%s.curves.csv"
const FIGURES: Array[String] = ["r2", "r2_zero", "lag", "t_diff", "sparc"]
## The statistics of each figure in summary.json.
const STATISTICS: Dictionary[String, PackedStringArray] = {
	"r2": ["mean", "median", "p5"],
	"r2_zero": ["mean", "median", "p5"],
	"lag": ["median"],
	"t_diff": ["median", "p2_5", "p97_5"],
	"sparc": ["mean", "median"],
}

## The error of the folder. Empty: none.
var error := ""
## One per gesture and position, in the order in which they came first; filled by finish().
var groups: Array[Dictionary] = []
## In trials without a gesture: {trial, gesture, time_s}; and the length of these trials.
var false_alarms: Array[Dictionary] = []
var none_s := 0.0

var _folder := ""
var _results: FileAccess = null
## Rows of results.csv by "gesture/position".
var _rows: Dictionary[String, Array] = {}
## Gesture of each trial, for the confusion table.
var _done: PackedStringArray = []
var _recognised: PackedStringArray = []
var _none_begun := 0
var _none_under_way_s := 0.0


func _init(folder: String) -> void:
	_folder = folder
	DirAccess.make_dir_recursive_absolute(folder)
	var header := PackedStringArray(["trial", "gesture", "position", "subject", "recognised"])
	for condition in Conditions.NAMES:
		for figure in FIGURES:
			header.append("%s_%s" % [figure, condition])
	_remove_earlier(header)
	_results = _open(PART)
	if _results != null:
		_results.store_csv_line(header)


## `trial`: a row of TrialSet.get_trial().
func add(trial: Dictionary, run: TrialRun) -> void:
	_write_curves(trial["trial"], run)
	var row := PackedStringArray(
		[trial["trial"], trial["gesture"], trial["position"], trial["subject"], run.recognised]
	)
	for condition in Conditions.NAMES:
		for figure in FIGURES:
			row.append(_cell(run.figures, condition, figure))
	_results.store_csv_line(row)
	_check(_results)

	var key := "%s/%s" % [trial["gesture"], trial["position"]]
	_rows.get_or_add(key, []).append(
		{trial = trial["trial"], recognised = run.recognised, figures = run.figures}
	)
	_done.append(trial["gesture"])
	_recognised.append(run.recognised)
	if trial["gesture"] == TrialRun.NO_GESTURE:
		for end in run.ends:
			false_alarms.append({trial = trial["trial"]}.merged(end))
		none_s += run.count / TrialRun.RATE_HZ
		_none_begun += run.begun
		_none_under_way_s += run.under_way / TrialRun.RATE_HZ


## `settings`: of the evaluation, written into summary.json.
func finish(settings: Dictionary) -> void:
	for key: String in _rows:
		var rows := _rows[key]
		var names := key.rsplit("/", true, 1)
		var group := {
			gesture = names[0],
			position = names[1],
			trials = rows.size(),
			recognised = rows.filter(_was_recognised.bind(names[0])).size(),
			conditions = {},
		}
		var judged := rows.filter(_has_figures)
		for condition in Conditions.NAMES:
			if not judged.is_empty():
				group["conditions"][condition] = _summarise(judged, condition)
		groups.append(group)
	var summary := _open(SUMMARY)
	if summary != null:
		var content := {
			settings = settings,
			confusion = MotionMetrics.confusion(_done, _recognised),
			false_alarms = false_alarms,
			none_minutes = none_s / 60.0,
			false_alarms_per_minute = null,
			begun_per_minute = null,
			under_way_share = null,
			groups = groups,
		}
		if none_s > 0.0:
			var rate := MotionMetrics.false_alarms_per_minute
			content["false_alarms_per_minute"] = rate.call(false_alarms.size(), none_s)
			content["begun_per_minute"] = rate.call(_none_begun, none_s)
			content["under_way_share"] = _none_under_way_s / none_s
		summary.store_line(JSON.stringify(content, "\t", false, true))
		_check(summary)
	_results.close()
	if not error.is_empty():
		DirAccess.remove_absolute(_folder.path_join(SUMMARY))
		return
	var renamed := DirAccess.rename_absolute(_folder.path_join(PART), _folder.path_join(RESULTS))
	if renamed != OK:
		error = "cannot write %s: %s" % [_folder.path_join(RESULTS), error_string(renamed)]


## Names the written files in one line.
func get_result() -> String:
	var curves := "1 curve" if _done.size() == 1 else "%d curves" % _done.size()
	return "wrote %s, %s and %s" % [_folder.path_join(RESULTS), SUMMARY, curves]


## Name of the trial whose measured curve has the median zero-lag R2. Empty: no such trials.
func typical_trial(gesture: String, position: String) -> String:
	var rows: Array = _rows.get("%s/%s" % [gesture, position], []).filter(_has_figures)
	rows.sort_custom(
		func(a: Dictionary, b: Dictionary) -> bool:
			return a["figures"]["measured"]["r2_zero"] < b["figures"]["measured"]["r2_zero"]
	)
	return "" if rows.is_empty() else rows[rows.size() / 2]["trial"]


static func _has_figures(row: Dictionary) -> bool:
	return not row["figures"].is_empty()


static func _was_recognised(row: Dictionary, gesture: String) -> bool:
	return row["recognised"] == gesture


## `rows`: with figures. A missed end counts in t_diff as the end of the record.
static func _summarise(rows: Array, condition: String) -> Dictionary:
	var summary := {n = rows.size()}
	for figure: String in STATISTICS:
		var values := PackedFloat64Array()
		for row: Dictionary in rows:
			values.append(row["figures"][condition][figure])
		summary[figure] = _pick(values, STATISTICS[figure])
	var missed: Array[String] = []
	for row: Dictionary in rows:
		if row["figures"][condition]["missed"]:
			missed.append(row["trial"])
	summary.merge({missed = missed.size(), missed_trials = missed})
	return summary


## Nulls if there are no values.
static func _pick(values: PackedFloat64Array, names: PackedStringArray) -> Dictionary:
	var statistics := {} if values.is_empty() else MotionMetrics.summarise(values)
	var picked := {}
	for name in names:
		picked[name] = statistics.get(name)
	return picked


## Empty: there is no task, or no model.
static func _cell(figures: Dictionary, condition: String, figure: String) -> String:
	if condition not in figures:
		return ""
	return "%.6f" % figures[condition][figure]


## Removes an earlier evaluation, complete or not, so that no files of two evaluations mix. Its
## tables name its curves.
func _remove_earlier(header: PackedStringArray) -> void:
	for table: String in [RESULTS, PART]:
		var path := _folder.path_join(table)
		var rows := FileAccess.open(path, FileAccess.READ)
		if rows == null or rows.get_csv_line() != header:
			continue
		DirAccess.remove_absolute(_folder.path_join(SUMMARY))
		while not rows.eof_reached():
			var trial := rows.get_csv_line()[0]
			if trial == trial.get_file() and not trial.is_empty():
				DirAccess.remove_absolute(_folder.path_join(CURVES % trial))
		rows.close()
		DirAccess.remove_absolute(path)


func _write_curves(name: String, run: TrialRun) -> void:
	var file := _open(CURVES % name)
	if file == null:
		return
	file.store_line("t,reference,%s" % ",".join(Conditions.NAMES))
	var columns: Array[PackedFloat64Array] = []
	for condition in Conditions.NAMES:
		columns.append(run.curves[condition])
	var has_reference := TrialRun.REFERENCE in run.curves
	var reference := run.curves.get(TrialRun.REFERENCE, columns[0]) as PackedFloat64Array
	var numbers := ",%.9f".repeat(columns.size())
	var cells: Array = []
	cells.resize(columns.size())
	for i in run.count:
		for c in columns.size():
			cells[c] = columns[c][i]
		var first := "%.3f," % ((run.first_ms + i) / TrialRun.RATE_HZ)
		if has_reference:
			first += "%.9f" % reference[i]
		file.store_line(first + numbers % cells)
	_check(file)


func _check(file: FileAccess) -> void:
	if not Stored.is_written(file) and error.is_empty():
		error = "cannot write %s: is the disk full?" % file.get_path()


func _open(name: String) -> FileAccess:
	var path := _folder.path_join(name)
	var file := FileAccess.open(path, FileAccess.WRITE)
	if file == null and error.is_empty():
		error = "cannot write %s: %s" % [path, error_string(FileAccess.get_open_error())]
	return file
