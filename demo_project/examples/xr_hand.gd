extends HandTracker
## The script of a HandTracker whose frames are a hand's that XRServer tracks, over OpenXR for one.
## To be copied into a project. OpenXR runtimes foretell where the hand will be: set the
## `sensor_latency` of the GestureHMM to 0. Where a game moves the player in _process(), put the
## node after the XROrigin3D in the tree: before it the hand is where the player was a frame ago.

## Joints that gestures are made of, and what Godot calls them.
const JOINTS: Dictionary[int, int] = {
	JOINT_THUMB: XRHandTracker.HAND_JOINT_THUMB_TIP,
	JOINT_INDEX: XRHandTracker.HAND_JOINT_INDEX_FINGER_TIP,
	JOINT_MIDDLE: XRHandTracker.HAND_JOINT_MIDDLE_FINGER_TIP,
}
## A hand that stays within so much for so long makes no gesture.
const REST_M := 0.02
const REST_S := 0.25
## Of a head that looks further up or down it is not clear where it faces.
const STEEPEST := deg_to_rad(70.0)

## The tracker's name in XRServer.
@export_enum("/user/hand_tracker/left", "/user/hand_tracker/right")
var xr_hand := "/user/hand_tracker/right"
## In the space of the world, as the tasks are. Switched off: in metres of the body, in a space that
## goes along with the player, for gestures without a task.
@export var in_world := true
## Where `in_world` is off: the space faces where the player does. Switched off: it is that of the
## XROrigin3D, which does not turn with a player who turns in the room.
@export var turns_with_player := true

var _refused: XRTracker = null
## From the origin's space.
var _to_body := Transform3D.IDENTITY
var _rest_place := Vector3.INF
var _rests_since_s := 0.0


func _init() -> void:
	source = SOURCE_SCRIPT


func _process(_delta: float) -> void:
	var time_s := 1e-6 * Time.get_ticks_usec()
	var joints := _tracked_joints()
	if not in_world and turns_with_player and joints.has(JOINT_INDEX):
		_follow_player(joints[JOINT_INDEX], time_s)
		for joint: int in joints:
			joints[joint] = _to_body * joints[joint]
	push_frame(time_s, joints)


## Empty where the hand is lost.
func _tracked_joints() -> Dictionary[int, Vector3]:
	var hand := _hand()
	var space := XRServer.get_reference_frame().scaled_local(Vector3.ONE * XRServer.world_scale)
	if in_world:
		space = XRServer.world_origin * space
	else:
		# Gestures without a task are as long as the body makes them, whatever the world's scale.
		space = space.scaled(Vector3.ONE / XRServer.world_scale)
	var joints: Dictionary[int, Vector3] = {}
	if hand != null and hand.has_tracking_data:
		for joint: int in JOINTS:
			if (
				hand.get_hand_joint_flags(JOINTS[joint])
				& XRHandTracker.HAND_JOINT_FLAG_POSITION_TRACKED
			):
				joints[joint] = space * hand.get_hand_joint_transform(JOINTS[joint]).origin
	return joints


## While the hand rests its space turns with the head, about the fingertip, so that nothing moves;
## from where it sets out until it rests again the head may look about.
func _follow_player(tip: Vector3, time_s: float) -> void:
	var is_first := not _rest_place.is_finite()
	if is_first or tip.distance_to(_rest_place) > REST_M:
		_rest_place = tip
		_rests_since_s = time_s
	if is_first or time_s - _rests_since_s > REST_S:
		var turned := _head_turned()
		if is_finite(turned):
			var to_body := Basis(Vector3.UP, -turned)
			_to_body = Transform3D(to_body, _to_body * tip - to_body * tip)


## About the vertical, from the origin's -z; NAN where that is not known.
func _head_turned() -> float:
	var head := XRServer.get_tracker(&"head") as XRPositionalTracker
	var pose := head.get_pose(&"default") if head != null else null
	if pose == null or not pose.has_tracking_data:
		return NAN
	var angles := pose.get_adjusted_transform().basis.get_euler()
	return angles.y if absf(angles.x) < STEEPEST else NAN


## Null where there is none yet.
func _hand() -> XRHandTracker:
	var tracker := XRServer.get_tracker(xr_hand)
	if tracker != null and not tracker is XRHandTracker and tracker != _refused:
		_refused = tracker
		push_warning(
			"%s: %s is no XRHandTracker but %s" % [get_path(), xr_hand, tracker.get_class()]
		)
	return tracker as XRHandTracker
