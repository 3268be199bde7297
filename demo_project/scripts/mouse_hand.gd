extends Node
## The mouse in place of a hand. The pointer covers a point of the task's plane, which contains the
## task's axis and faces the camera. This point is the index tip. If the task is a radius, it is a
## point on the circle of the tips around the task's place.

const HandPose := preload("res://addons/steadyhand/hands/hand_pose.gd")

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
	var plane := MouseSource.plane_along(task.get_axis(), task.get_start(), camera)
	var hit: Variant = MouseSource.hit(camera, _pointer, plane)
	if hit is Vector3:
		var time_s := 1e-6 * Time.get_ticks_usec()
		tracker.push_frame(time_s, _joints(hit + HandPose.tremor(time_s)))


func _joints(place: Vector3) -> Dictionary:
	var start := task.get_start()
	if task.start_radius > 0.0:
		return HandPose.circle(start, place.distance_to(start))
	return {HandTracker.JOINT_INDEX: place}
