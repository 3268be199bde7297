extends RefCounted
## An XRHandTracker that a test moves, as an XR interface would.

const RIGHT := &"/user/hand_tracker/right"
const LEFT := &"/user/hand_tracker/left"
const INDEX_TIP := XRHandTracker.HAND_JOINT_INDEX_FINGER_TIP
const PALM := XRHandTracker.HAND_JOINT_PALM
const TRACKED := (
	XRHandTracker.HAND_JOINT_FLAG_POSITION_VALID | XRHandTracker.HAND_JOINT_FLAG_POSITION_TRACKED
)
const INFERRED := XRHandTracker.HAND_JOINT_FLAG_POSITION_VALID
## From the index tip.
const PALM_OFFSET := Vector3(0.0, -0.02, 0.1)

var tracker := XRHandTracker.new()


func _init(name: StringName = RIGHT) -> void:
	tracker.name = name
	tracker.has_tracking_data = true
	# The engine leaves them uninitialised.
	for joint in XRHandTracker.HAND_JOINT_MAX:
		tracker.set_hand_joint_flags(joint, 0)


func register() -> void:
	XRServer.add_tracker(tracker)


func remove() -> void:
	XRServer.remove_tracker(tracker)


## The index tip and the palm, in the tracking space.
func place(tip: Vector3, flags: int = TRACKED) -> void:
	for joint: int in [INDEX_TIP, PALM]:
		var offset := PALM_OFFSET if joint == PALM else Vector3.ZERO
		tracker.set_hand_joint_transform(joint, Transform3D(Basis(), tip + offset))
		tracker.set_hand_joint_flags(joint, flags)
