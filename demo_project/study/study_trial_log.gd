extends RefCounted
## Records one trial: curves of every condition at 1 kHz, frames of the tracker and the reference,
## and how well the curves follow the reference. While the hand moves only frames are written.

const Conditions := preload("res://scripts/conditions.gd")

const RATE_HZ := 1000.0
const HEADER := "t,measured,average,one_euro,kalman,synthesised,reference,state,progress,vibration"
## A sensor's reference starts at this share of the way from its lowest to its farthest value.
const ONSET_LEVEL := 0.05
## A sensor's reference ends at this share of its farthest value.
const END_LEVEL := 0.99

## Of MotionMetrics.compare(), by condition. Empty without a reference or its span.
var figures: Dictionary[String, Dictionary] = {}
## "sensor", "truth" or empty, as in trials.csv.
var reference_kind := ""

var _session: StudySession = null
var _trial := 0
var _tracker: HandTracker = null
var _reference: HandTracker = null
var _times := PackedFloat64Array()
## Row by row: the conditions' motions (m), progress, vibration.
var _values := PackedFloat64Array()
var _states := PackedInt32Array()


## `reference`: null without one.
func _init(session: StudySession, trial: int, tracker: HandTracker, reference: HandTracker) -> void:
	_session = session
	_trial = trial
	_tracker = tracker
	_reference = reference
	_start_recording(tracker, "frames")
	if reference != null:
		_start_recording(reference, "reference")


## The motion at a control instant.
func add(time_s: float, hmm: GestureHMM, vibration: float) -> void:
	_times.append(time_s)
	for motion in Conditions.MOTIONS:
		_values.append(hmm.get_motion_value(motion))
	_values.append(hmm.progress)
	_values.append(vibration)
	_states.append(hmm.state)


## Ends the recording and hands motion.csv to the session. `feature`: of the gesture's model.
## `truth`: {start_s, end_s} of a simulated hand; empty for a sensor's reference, whose span comes
## from its own curve and from `onset_s`, when the gesture was recognised (NAN: never). Gives the
## columns of trials.csv that compare with the reference.
func finish(task: GestureTask, feature: String, truth: Dictionary, onset_s: float) -> Dictionary:
	stop()
	var row := {}
	var reference := _reference_curve(task, feature, truth)
	if not reference.is_empty():
		row["reference"] = reference_kind
		var span := truth
		if truth.is_empty() and not is_nan(onset_s):
			span = span_of(reference, _times[0], onset_s)
		if not span.is_empty():
			row.merge(_compare(reference, task.amplitude, span))
	_session.add_file(
		_session.trial_path(_trial, "motion"), _motion_text(reference, task.amplitude)
	)
	return row


## Ends the recording of an aborted trial.
func stop() -> void:
	_tracker.stop_recording()
	if _reference != null:
		_reference.stop_recording()


## {start_s, end_s} of a reference's motion, whose gesture was recognised at `onset_s`. The record
## begins while the hand is still at the end of the trial before. So the motion starts at the last
## instant at the start's level.
static func span_of(reference: PackedFloat64Array, t0_s: float, onset_s: float) -> Dictionary:
	var values := Array(reference)
	# The reference of a hand at the start is not 0 if the two trackers are not aligned exactly.
	var lowest: float = maxf(values.min(), 0.0)
	var level: float = lowest + ONSET_LEVEL * (values.max() - lowest)
	var onset := clampi(roundi((onset_s - t0_s) * RATE_HZ), 0, reference.size() - 1)
	# The reference may be ahead of the tracker: near its end when the gesture is recognised.
	var end := _last_at_most(level, reference, onset)
	var farthest: float = values.slice(end).max()
	while end < reference.size() - 1 and reference[end] < END_LEVEL * farthest:
		end += 1
	var start := _last_at_most(level, reference, end)
	return {start_s = t0_s + start / RATE_HZ, end_s = t0_s + end / RATE_HZ}


## The last index up to `from` at which a curve is at or below a level; 0 if there is none.
static func _last_at_most(level: float, curve: PackedFloat64Array, from: int) -> int:
	var index := from
	while index > 0 and curve[index] > level:
		index -= 1
	return index


func _start_recording(recorded: HandTracker, kind: String) -> void:
	var path := _session.trial_path(_trial, kind)
	var error := recorded.start_recording(path)
	if error != OK:
		push_error("%s: frames are not recorded: %s" % [path, error_string(error)])


## In units of the amplitude, one value for each row. Empty without a reference or frames of it.
func _reference_curve(task: GestureTask, feature: String, truth: Dictionary) -> PackedFloat64Array:
	if _reference == null or _times.is_empty():
		return PackedFloat64Array()
	var path := _session.trial_path(_trial, "reference")
	if not _has_frames(path):
		return PackedFloat64Array()
	reference_kind = "sensor" if truth.is_empty() else "truth"
	var is_radius := task.start_radius > 0.0
	var asked := {
		trial = str(_trial),
		gesture = String(task.gesture),
		position = "stable",
		subject = "",
		start = Vector3(task.start_radius, 0, 0) if is_radius else task.get_start(),
		axis = Vector3.ZERO if is_radius else task.get_axis(),
		amplitude_m = task.amplitude,
		start_s = truth.get("start_s", _times[0]),
		end_s = truth.get("end_s", _times[-1]),
	}
	return MotionMetrics.feature_curve(
		RecordedTrack.load_file(path), feature, asked, _times[0], RATE_HZ, _times.size()
	)


## Columns of trials.csv.
func _compare(reference: PackedFloat64Array, amplitude_m: float, span: Dictionary) -> Dictionary:
	var width := Conditions.NAMES.size() + 2
	for c in Conditions.NAMES.size():
		var curve := PackedFloat64Array()
		curve.resize(_times.size())
		for i in _times.size():
			curve[i] = _values[i * width + c] / amplitude_m
		figures[Conditions.NAMES[c]] = MotionMetrics.compare(
			reference, curve, RATE_HZ, _times[0], span["start_s"], span["end_s"]
		)
	var row := {}
	for motion in Conditions.COMPARED:
		var condition := Conditions.NAMES[Conditions.MOTIONS.find(motion)]
		for figure: String in ["r2", "r2_zero", "lag", "t_diff"]:
			row["%s_%s" % [figure, condition]] = figures[condition][figure]
	return row


func _motion_text(reference: PackedFloat64Array, amplitude_m: float) -> String:
	var lines := PackedStringArray([HEADER])
	var width := Conditions.NAMES.size() + 2
	for i in _times.size():
		var v := i * width
		var shown := "" if reference.is_empty() else "%.6f" % (amplitude_m * reference[i])
		lines.append(
			(
				"%.6f,%.6f,%.6f,%.6f,%.6f,%.6f,%s,%d,%.4f,%.4f"
				% [
					_times[i],
					_values[v],
					_values[v + 1],
					_values[v + 2],
					_values[v + 3],
					_values[v + 4],
					shown,
					_states[i],
					_values[v + 5],
					_values[v + 6]
				]
			)
		)
	lines.append("")
	return "\n".join(lines)


## Whether there is a row below the header. Without one there is no reference.
static func _has_frames(path: String) -> bool:
	var file := FileAccess.open(path, FileAccess.READ)
	if file == null:
		return false
	while not file.eof_reached():
		var line := file.get_line()
		if not line.is_empty() and line[0].is_valid_int():
			return true
	return false
