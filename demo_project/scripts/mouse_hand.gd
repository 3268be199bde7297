extends Node
## The mouse in place of a hand. The pointer covers a point of the task's plane, which holds the
## task's axis and faces the camera: that is the index tip, or, where the task is a radius, a point
## of the circle about the task's place that the tips are on.

## Where tips are on their circle, rad: far enough from a line.
const ANGLES: Dictionary[int, float] = {
	HandTracker.JOINT_THUMB: 3.6,
	HandTracker.JOINT_INDEX: 1.5,
	HandTracker.JOINT_MIDDLE: 0.4,
}
## A mouse at rest repeats itself to the last bit, which of a tracker means that it has lost the
## hand: every hand trembles. Fingertip, arm held out (Growdon et al. 2000).
const TREMOR_M := 1.5e-4
const TREMOR_HZ: Array[float] = [8.7, 9.9, 11.3]

@export var tracker: HandTracker
@export var task: GestureTask

var active := false

var _pointer := Vector2.ZERO


func _input(event: InputEvent) -> void:
	if event is InputEventMouseMotion:
		_pointer = event.position


func _process(_delta: float) -> void:
	var camera := get_viewport().get_camera_3d()
	if not active or camera == null:
		return
	var axis := task.get_axis()
	var view := camera.global_basis.z
	var plane := Plane((view - axis * view.dot(axis)).normalized(), task.get_start())
	var hit: Variant = plane.intersects_ray(
		camera.project_ray_origin(_pointer), camera.project_ray_normal(_pointer)
	)
	if hit is Vector3:
		var time_s := 1e-6 * Time.get_ticks_usec()
		tracker.push_frame(time_s, _joints(hit + _tremor(time_s)))


func _joints(hit: Vector3) -> Dictionary:
	if task.start_radius <= 0.0:
		return {HandTracker.JOINT_INDEX: hit}
	var joints := {}
	var radius := hit.distance_to(task.get_start())
	for joint in ANGLES:
		var outward := Vector3(cos(ANGLES[joint]), sin(ANGLES[joint]), 0)
		joints[joint] = task.get_start() + radius * outward
	return joints


static func _tremor(time_s: float) -> Vector3:
	var tremor := Vector3.ZERO
	for axis in TREMOR_HZ.size():
		tremor[axis] = TREMOR_M * sin(TAU * TREMOR_HZ[axis] * time_s)
	return tremor
