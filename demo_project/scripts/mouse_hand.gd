extends Node
## The mouse in place of a hand: pushes the point of the task's plane that the pointer covers, as
## the index tip. The plane holds the task's axis and faces the camera.

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
		tracker.push_frame(1e-6 * Time.get_ticks_usec(), {HandTracker.JOINT_INDEX: hit})
