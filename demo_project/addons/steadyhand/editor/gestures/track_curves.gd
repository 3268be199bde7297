@tool
extends RefCounted
## The motion of the fingertips of a recorded track, at an even rate.

const RATE_HZ := 200.0
## A curve needs its joints in at least this share of the frames.
const HELD := 0.5

const _WHOLE_TRACK := {
	trial = "", gesture = "", position = "stable", subject = "", start_s = 0.0, end_s = 1.0
}

var start_s := 0.0
var frames := 0
## Index tip, m. Empty: the track does not have it.
var index := PackedVector3Array()
## Circle through thumb, index and middle tip, m. Empty: the track does not have them.
var radius := PackedFloat64Array()


## No curves if the track has no hand; one error in the log if it cannot be read.
static func read(path: String) -> RefCounted:
	var curves := new()
	curves._read(path)
	return curves


func _read(path: String) -> void:
	if not _has_rows(path):
		return
	var track := RecordedTrack.load_file(path)
	if track == null:
		return
	var tracker := HandTracker.new()
	var source := RecordedSource.new()
	source.recording = track
	tracker.source = source
	tracker.update_mode = HandTracker.UPDATE_MANUAL
	var held := {index = 0, tips = 0}
	tracker.frame_received.connect(
		func(frame: HandFrame) -> void:
			var has_index := frame.has_joint(HandTracker.JOINT_INDEX)
			var has_tips := (
				has_index
				and frame.has_joint(HandTracker.JOINT_THUMB)
				and frame.has_joint(HandTracker.JOINT_MIDDLE)
			)
			held["index"] += int(has_index)
			held["tips"] += int(has_tips)
			frames += 1
	)
	if tracker.start() == OK:
		start_s = tracker.get_start_time()
		var duration_s := tracker.get_duration()
		tracker.advance_to(start_s + duration_s)
		tracker.stop()
		var count := floori(duration_s * RATE_HZ) + 1
		if held["index"] > HELD * frames:
			_read_index(track, count)
		if held["tips"] > HELD * frames:
			radius = _curve(track, "tips_circumradius", Vector3.ZERO, count)
	tracker.free()


func count() -> int:
	return maxi(index.size(), radius.size())


func time_at(i: int) -> float:
	return start_s + i / RATE_HZ


## The nearest instant of the curves.
func index_at(time_s: float) -> int:
	return clampi(roundi((time_s - start_s) * RATE_HZ), 0, maxi(count() - 1, 0))


func end_s() -> float:
	return time_at(maxi(count() - 1, 0))


## A RecordedSource reports a file without rows as an error.
static func _has_rows(path: String) -> bool:
	var lines := FileAccess.get_file_as_string(path).strip_edges().split("\n")
	return lines[-1].get_slice(",", 0).is_valid_float()


func _read_index(track: RecordedTrack, size: int) -> void:
	var axes: Array[PackedFloat64Array] = []
	for axis: Vector3 in [Vector3.RIGHT, Vector3.UP, Vector3.BACK]:
		axes.append(_curve(track, "index_along_axis", axis, size))
	index.resize(axes[0].size())
	for i in index.size():
		index[i] = Vector3(axes[0][i], axes[1][i], axes[2][i])


## In metres, because the amplitude is 1.
func _curve(track: RecordedTrack, feature: String, axis: Vector3, size: int) -> PackedFloat64Array:
	var trial := _WHOLE_TRACK.duplicate()
	trial.merge({start = Vector3.ZERO, axis = axis, amplitude_m = 1.0})
	return MotionMetrics.feature_curve(track, feature, trial, start_s, RATE_HZ, size)
