extends RefCounted
## Why a GestureHMM shows no gesture, and what to do.

const SILENT_S := 0.5
const FROZEN_S := 0.4
## A gesture begins at most this far from the start, as a share of the amplitude: see GestureTask.
const START_REACH := 0.6
## A hand is at the start within this distance, as a share of the amplitude.
const AT_START := 0.25
## Cosine of 60 degrees: a movement at a larger angle to a task's direction is another one.
const SAME_DIRECTION := 0.5
## See GestureHMM.START_DWELL.
const DWELL_M := 0.02

const JOINTS: Dictionary[String, Array] = {
	"index_along_axis": [HandTracker.JOINT_INDEX],
	"index_along_circle": [HandTracker.JOINT_INDEX],
	"tips_circumradius":
	[HandTracker.JOINT_THUMB, HandTracker.JOINT_INDEX, HandTracker.JOINT_MIDDLE],
}
const NAMES: Dictionary[HandTracker.Joint, String] = {
	HandTracker.JOINT_THUMB: "thumb",
	HandTracker.JOINT_INDEX: "index finger",
	HandTracker.JOINT_MIDDLE: "middle finger",
}

## The error of the source; empty while it works.
var failure := ""

var _silent_s := 0.0
## The index tip, at times of the frames.
var _place := Vector3.INF
var _unchanged_since_s := 0.0
var _dwell_place := Vector3.INF
var _dwell_since_s := 0.0
## The task at whose start the hand was last. Null if it has been far from it since.
var _left_task: GestureTask = null


func follow(tracker: HandTracker) -> void:
	failure = ""
	_silent_s = 0.0
	_place = Vector3.INF
	_dwell_place = Vector3.INF
	tracker.failed.connect(_on_failed)
	tracker.source_ready.connect(_on_source_ready)
	tracker.frame_received.connect(_on_frame)


func leave(tracker: HandTracker) -> void:
	tracker.failed.disconnect(_on_failed)
	tracker.source_ready.disconnect(_on_source_ready)
	tracker.frame_received.disconnect(_on_frame)


## Time of the game, because a device that sends no frame sends no time.
func pass_time(seconds: float) -> void:
	_silent_s += seconds


## For a GestureHMM without an active gesture.
func of(hmm: GestureHMM) -> String:
	var tracker := hmm.tracker
	if not is_instance_valid(tracker):
		return 'No tracker: set "tracker" of %s.' % hmm.name
	var reason := _of_tracker(tracker)
	if reason.is_empty():
		reason = _of_models(hmm)
	if reason.is_empty() and tracker.is_finished():
		reason = "The recording has ended: call start() to play it again."
	if reason.is_empty() and _silent_s > SILENT_S:
		var question := "is the device connected?"
		if tracker.source is RecordedSource:
			question = "are the times of the recording in seconds?"
		reason = "No frame for %.1f s: %s" % [_silent_s, question]
	if reason.is_empty() and not tracker.is_hand_tracked():
		reason = "No hand in view."
	if reason.is_empty():
		reason = _of_joints(hmm)
	if reason.is_empty():
		reason = _of_freeze(tracker)
	if reason.is_empty():
		reason = _of_tasks(hmm)
	if reason.is_empty():
		reason = _of_start(hmm)
	return "Ready: waits for a movement." if reason.is_empty() else reason


func _of_tracker(tracker: HandTracker) -> String:
	if tracker.source == null:
		return 'No source: set "source" of %s.' % tracker.name
	if not failure.is_empty():
		return failure
	if not tracker.is_running() and not tracker.is_inside_tree():
		return "The HandTracker is not in the scene: add it by add_child()."
	if not tracker.is_running():
		return "%s is stopped: call start()." % tracker.name
	return ""


func _of_models(hmm: GestureHMM) -> String:
	if hmm.models.is_empty():
		return 'No models: set "models" of %s.' % hmm.name
	var gestures := (
		hmm
		. models
		. filter(func(model: GestureModel) -> bool: return model != null)
		. map(func(model: GestureModel) -> StringName: return model.gesture)
	)
	for task in hmm.tasks:
		var is_known := task == null or task.gesture.is_empty() or task.gesture in gestures
		if not is_known:
			return "No model of '%s': add it to \"models\" of %s." % [task.gesture, hmm.name]
	return ""


## A model may need joints that the tracker does not send.
func _of_joints(hmm: GestureHMM) -> String:
	var missing := ""
	for model in _active(hmm):
		var lacks := PackedStringArray()
		for joint: HandTracker.Joint in JOINTS.get(model.feature, []):
			if not hmm.tracker.is_joint_tracked(joint):
				lacks.append(NAMES[joint])
		if lacks.is_empty():
			return ""
		missing = (
			"'%s' needs joints that are not tracked: %s." % [model.gesture, ", ".join(lacks)]
		)
	return missing


## The models of the tasks' gestures; all models if no task names a gesture.
func _active(hmm: GestureHMM) -> Array[GestureModel]:
	var wanted: Array[StringName] = []
	for task in hmm.tasks:
		if task != null and not task.gesture.is_empty():
			wanted.append(task.gesture)
	return hmm.models.filter(
		func(model: GestureModel) -> bool:
			return model != null and (wanted.is_empty() or model.gesture in wanted)
	)


## Without noise, as with the mouse, a repeated position is a hand at rest.
func _of_freeze(tracker: HandTracker) -> String:
	var unchanged_s := tracker.get_time() - _unchanged_since_s
	if is_finite(tracker.noise) and tracker.noise > 0.0 and unchanged_s > FROZEN_S:
		return "The tracker has repeated one position for %.1f s: it is frozen." % unchanged_s
	return ""


func _of_tasks(hmm: GestureHMM) -> String:
	var nearest: GestureTask = null
	var nearest_m := INF
	for task in hmm.tasks:
		if task == null or task.start_radius > 0.0:
			continue
		var distance_m := task.get_start().distance_to(_place)
		if distance_m - START_REACH * task.amplitude < nearest_m:
			nearest = task
			nearest_m = distance_m - START_REACH * task.amplitude
	if nearest == null:
		return ""
	if nearest_m <= 0.0:
		return _of_direction(hmm, nearest)
	_left_task = null
	return (
		"The hand is %.0f cm from the start of %s: it has to come within %.0f cm."
		% [
			100.0 * nearest.get_start().distance_to(_place),
			nearest.name,
			100.0 * START_REACH * nearest.amplitude
		]
	)


## A hand that comes from elsewhere may be on its way to the start.
func _of_direction(hmm: GestureHMM, task: GestureTask) -> String:
	var moved := _place - task.get_start()
	if moved.length() < AT_START * task.amplitude:
		_left_task = task
		return ""
	if _left_task != task or not _is_straight(hmm, task):
		return ""
	for other in hmm.tasks:  # several tasks may start at one place
		if other != null and cos(moved.angle_to(other.get_axis())) >= SAME_DIRECTION:
			if other.get_start().distance_to(task.get_start()) < AT_START * other.amplitude:
				return ""
	return (
		"The hand moved away from the start of %s at %.0f° to its direction: go back to the start."
		% [task.name, rad_to_deg(moved.angle_to(task.get_axis()))]
	)


func _is_straight(hmm: GestureHMM, task: GestureTask) -> bool:
	return _active(hmm).any(
		func(model: GestureModel) -> bool:
			return model.feature == "index_along_axis" and task.gesture in [&"", model.gesture]
	)


func _of_start(hmm: GestureHMM) -> String:
	match hmm.start_condition:
		GestureHMM.START_DWELL:
			var held_s := hmm.tracker.get_time() - _dwell_since_s
			if held_s < hmm.dwell_time:
				return "Start condition: hold the fingertip still for %.1f s." % hmm.dwell_time
		GestureHMM.START_PINCH:
			var thumb := hmm.tracker.get_joint_position(HandTracker.JOINT_THUMB)
			var apart_m := thumb.distance_to(_place)
			if not hmm.tracker.is_joint_tracked(HandTracker.JOINT_THUMB):
				return "Start condition: a pinch, but the thumb is not tracked."
			if apart_m > hmm.pinch_distance:
				return (
					"Start condition: pinch. Thumb and index finger are %.1f cm apart, not %.1f cm."
					% [100.0 * apart_m, 100.0 * hmm.pinch_distance]
				)
		GestureHMM.START_POINTING_POSE:
			return "Start condition: extend the index finger and curl the others."
	return ""


func _on_failed(reason: String) -> void:
	failure = reason


func _on_source_ready() -> void:
	failure = ""


func _on_frame(frame: HandFrame) -> void:
	_silent_s = 0.0
	if not frame.has_joint(HandTracker.JOINT_INDEX):
		return
	failure = ""
	var place := frame.get_joint_position(HandTracker.JOINT_INDEX)
	if place != _place:
		_place = place
		_unchanged_since_s = frame.time
	if _dwell_place.distance_to(place) > DWELL_M or not _dwell_place.is_finite():
		_dwell_place = place
		_dwell_since_s = frame.time
