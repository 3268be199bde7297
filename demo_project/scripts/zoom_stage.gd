extends "stage.gd"
## A sphere that is zoomed to three times its size, in any number of strokes. It keeps its size
## while the hand closes again.

## Size of the sphere relative to the start.
const TARGET_SIZE := 3.0

var _amplitude := 1.0
var _size := 1.0
var _size_before := 1.0
var _is_begun := false
var _awaits_hand := false

@onready var _sphere: MeshInstance3D = $Sphere
@onready var _target: MeshInstance3D = $Target


func _init() -> void:
	strokes_add_up = true


func place(task: GestureTask, position_name: String) -> void:
	super(task, position_name)
	_amplitude = task.amplitude
	_size = 1.0
	_size_before = 1.0
	_is_begun = false
	_sphere.scale = Vector3.ONE
	_paint(_target, IDLE)
	# A trial gives the radius of the hand's circle, but not its place. The mouse is at the task.
	global_position = task.get_start()
	_awaits_hand = not position_name.is_empty()


func mark_started() -> void:
	_paint(_target, STARTED)


func mark_arrived() -> void:
	_paint(_target, ARRIVED)


func begin_stroke() -> void:
	_is_begun = true
	_size_before = _size


## Width of the target ring: how much the radius of the hand's circle grows while the sphere grows
## from the ring's inner to its outer edge, m.
func target_width() -> float:
	var ring := _target.mesh as TorusMesh
	var growth := (TARGET_SIZE - 1.0) * (_sphere.mesh as SphereMesh).radius
	return _amplitude * _ring_width(ring) / growth


func set_target_width(width_m: float) -> void:
	var ring := _target.mesh as TorusMesh
	ring.outer_radius += (width_m - target_width()) / target_width() * _ring_width(ring)


## The sphere stops at its target; the hand does not.
func end_value(value: float) -> float:
	return _amplitude * (_size_before - 1.0) / (TARGET_SIZE - 1.0) + value


## A whole stroke reaches from the start to the target.
func show_motion(value: float) -> float:
	var gain := TARGET_SIZE - 1.0
	if _is_begun:
		var size := _size_before + gain * value / _amplitude
		_size = clampf(size, _size, TARGET_SIZE)
	_sphere.scale = Vector3.ONE * _size
	return (_size - 1.0) / gain


func show_hand(tracker: HandTracker) -> void:
	super(tracker)
	if _awaits_hand and _is_hand_tracked(tracker):
		_awaits_hand = false
		var middle := Vector3.ZERO
		for joint in joints:
			middle += tracker.get_joint_position(joint) / joints.size()
		global_position = middle


static func _ring_width(ring: TorusMesh) -> float:
	return ring.outer_radius - ring.inner_radius
