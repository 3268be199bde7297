extends HandTracker
## The script of a HandTracker whose frames are a hand's that XRServer tracks, over OpenXR for one.
## To be copied into a project. OpenXR runtimes foretell where the hand will be: set the
## `sensor_latency` of the GestureHMM to 0.

## Joints that gestures are made of, and what Godot calls them.
const JOINTS: Dictionary[int, int] = {
	JOINT_THUMB: XRHandTracker.HAND_JOINT_THUMB_TIP,
	JOINT_INDEX: XRHandTracker.HAND_JOINT_INDEX_FINGER_TIP,
	JOINT_MIDDLE: XRHandTracker.HAND_JOINT_MIDDLE_FINGER_TIP,
}

## The tracker's name in XRServer.
@export_enum("/user/hand_tracker/left", "/user/hand_tracker/right")
var xr_hand := "/user/hand_tracker/right"
## In the space of the world, as the tasks are. Switched off: in that of the XROrigin3D, for
## gestures without a task in games that move the player, with whom the hand moves in the world.
@export var in_world := true

var _refused: XRTracker = null


func _init() -> void:
	source = SOURCE_SCRIPT
	# After whatever moves the player in its _process(). What shows the motion in the same frame of
	# the game has a higher one.
	process_priority = 1


func _process(_delta: float) -> void:
	push_frame(1e-6 * Time.get_ticks_usec(), _tracked_joints())


## Empty where the hand is lost.
func _tracked_joints() -> Dictionary:
	var hand := _hand()
	var space := XRServer.get_reference_frame().scaled_local(Vector3.ONE * XRServer.world_scale)
	if in_world:
		space = XRServer.world_origin * space
	else:
		# Gestures without a task are as long as the body makes them, whatever the world's scale.
		space = space.scaled(Vector3.ONE / XRServer.world_scale)
	var joints := {}
	if hand != null and hand.has_tracking_data:
		for joint: int in JOINTS:
			if (
				hand.get_hand_joint_flags(JOINTS[joint])
				& XRHandTracker.HAND_JOINT_FLAG_POSITION_TRACKED
			):
				joints[joint] = space * hand.get_hand_joint_transform(JOINTS[joint]).origin
	return joints


## Null where there is none yet.
func _hand() -> XRHandTracker:
	var tracker := XRServer.get_tracker(xr_hand)
	if tracker != null and not tracker is XRHandTracker and tracker != _refused:
		_refused = tracker
		push_warning(
			"%s: %s is no XRHandTracker but %s" % [get_path(), xr_hand, tracker.get_class()]
		)
	return tracker as XRHandTracker
