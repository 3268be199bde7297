extends RefCounted
## A practice run: the participant moves the hand through all the space within reach. The quality of
## tracking there gives the task's two positions.

## `proposal`: of TrackingSurvey.propose().
signal ended(proposal: Dictionary)

const DURATION_S := 120.0

var _tracker: HandTracker = null
var _joint := HandTracker.JOINT_INDEX
var _survey := TrackingSurvey.new()


func _init(tracker: HandTracker, joint: HandTracker.Joint) -> void:
	_tracker = tracker
	_joint = joint
	_tracker.frame_received.connect(_on_frame_received)


## Ends the run before DURATION_S are over.
func end() -> void:
	if _tracker.frame_received.is_connected(_on_frame_received):
		_tracker.frame_received.disconnect(_on_frame_received)
		ended.emit(_survey.propose())


## Text for the participant during the run.
func get_instruction() -> String:
	var left_s := maxf(DURATION_S - _survey.get_duration(), 0.0)
	return "practice: move your hand through all the space within reach, %.0f s" % left_s


## The result, for the operator of the study.
static func describe(proposal: Dictionary) -> String:
	var error: String = proposal["error"]
	if not error.is_empty():
		return error
	if not proposal["distinct"]:
		return "tracking is equally good everywhere: the positions stay the same"
	var parts := PackedStringArray()
	for position: String in ["stable", "unstable"]:
		var found: Dictionary = proposal[position]
		var figures := [
			position, found["position"], 100 * found["lost_share"], 1e3 * found["noise"]
		]
		parts.append("%s at %.2v m: lost %.0f %% of the time, noise %.1f mm" % figures)
	return "; ".join(parts)


func _on_frame_received(frame: HandFrame) -> void:
	if _tracker.is_joint_tracked(_joint):
		_survey.push(frame.time, _tracker.get_joint_position(_joint))
	if _survey.get_duration() >= DURATION_S:
		end()
