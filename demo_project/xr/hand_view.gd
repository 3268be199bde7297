extends Node3D
## Shows the hand of a HandTracker as a hand: capsules along its bones. Joints that the source does
## not have are inferred. Without wrist and palm only the fingertips are shown.

## First joint of each finger, of XRHandTracker.HandJoint; it ends before the next one.
const FINGERS: Array[int] = [2, 6, 11, 16, 21, 26]
## Bones that make the palm: wrist to first joints, and across the knuckles.
const PALM: Array[Vector2i] = [
	Vector2i(1, 2),
	Vector2i(1, 6),
	Vector2i(1, 11),
	Vector2i(1, 16),
	Vector2i(1, 21),
	Vector2i(3, 7),
	Vector2i(7, 12),
	Vector2i(12, 17),
	Vector2i(17, 22),
	Vector2i(6, 11),
	Vector2i(11, 16),
	Vector2i(16, 21),
	Vector2i(2, 6),
]
## Radius at the knuckles and at the tip, m.
const THICKEST := 0.0095
const THINNEST := 0.0068
const TIP := 0.009

@export var tracker: HandTracker
@export var material: Material

var _bones: Array[Vector2i] = []
var _shapes: Array[MeshInstance3D] = []
var _tips: Array[MeshInstance3D] = []
var _joints: Dictionary[int, Vector3] = {}


func _ready() -> void:
	_bones = PALM.duplicate()
	for finger in FINGERS.size() - 1:
		for joint in range(FINGERS[finger], FINGERS[finger + 1] - 1):
			_bones.append(Vector2i(joint, joint + 1))
	for bone in _bones:
		_shapes.append(_add(CapsuleMesh.new()))
	for finger in FINGERS.size() - 1:
		var ball := SphereMesh.new()
		ball.radius = TIP
		ball.height = 2.0 * TIP
		_tips.append(_add(ball))
	if tracker.publish_name == &"":
		tracker.publish_name = &"/steadyhand/%d" % get_instance_id()


func _process(_delta: float) -> void:
	_read_joints()
	for i in _bones.size():
		_show_bone(_shapes[i], _bones[i])
	for i in _tips.size():
		var tip := FINGERS[i + 1] - 1
		_tips[i].visible = _joints.has(tip)
		_tips[i].global_position = _joints.get(tip, Vector3.ZERO)


## World positions (m) of the available joints.
func _read_joints() -> void:
	_joints.clear()
	var hand := XRServer.get_tracker(tracker.publish_name) as XRHandTracker
	if hand == null or not hand.has_tracking_data:
		return
	var to_world := XRServer.world_origin * XRServer.get_reference_frame()
	to_world = to_world.scaled_local(XRServer.world_scale * Vector3.ONE)
	for joint in XRHandTracker.HAND_JOINT_MAX:
		if hand.get_hand_joint_flags(joint) & XRHandTracker.HAND_JOINT_FLAG_POSITION_VALID:
			_joints[joint] = to_world * hand.get_hand_joint_transform(joint).origin


func _show_bone(shape: MeshInstance3D, bone: Vector2i) -> void:
	shape.visible = _joints.has(bone.x) and _joints.has(bone.y)
	if not shape.visible:
		return
	var from := _joints[bone.x]
	var way := _joints[bone.y] - from
	var capsule := shape.mesh as CapsuleMesh
	capsule.radius = THICKEST if bone in PALM else THINNEST
	capsule.height = way.length() + 2.0 * capsule.radius
	var up := way.normalized() if way.length() > 1e-6 else Vector3.UP
	shape.global_transform = Transform3D(Basis(Quaternion(Vector3.UP, up)), from + 0.5 * way)


func _add(mesh: Mesh) -> MeshInstance3D:
	var shape := MeshInstance3D.new()
	shape.mesh = mesh
	shape.material_override = material
	shape.visible = false
	add_child(shape)
	return shape
