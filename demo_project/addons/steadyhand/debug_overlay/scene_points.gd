extends Control
## Draws two points over the scene: the measured fingertip, and the output motion along the task.

const MotionStrip := preload("motion_strip.gd")

const RADIUS := 9.0
const WIDTH := 2.0

var _measured := Vector3.INF
var _output := Vector3.INF
## Start and end of the task.
var _way: PackedVector3Array = []


func show_motion(hmm: GestureHMM) -> void:
	var tracker := hmm.tracker
	var is_tracked := (
		is_instance_valid(tracker) and tracker.is_joint_tracked(HandTracker.JOINT_INDEX)
	)
	_measured = tracker.get_joint_position(HandTracker.JOINT_INDEX) if is_tracked else Vector3.INF
	var task := hmm.current_task if hmm.current_task != null else hmm.task
	_output = Vector3.INF
	_way = []
	if is_instance_valid(task) and task.is_inside_tree() and _is_straight(hmm, task):
		_way = [task.get_start(), task.get_start() + task.amplitude * task.get_axis()]
		_output = task.get_start() + hmm.value * task.get_axis()
	queue_redraw()


func _is_straight(hmm: GestureHMM, task: GestureTask) -> bool:
	for model in hmm.models:
		if model != null and (task.gesture.is_empty() or model.gesture == task.gesture):
			return model.feature == "index_along_axis"
	return false


func _draw() -> void:
	var camera := get_viewport().get_camera_3d()
	if camera == null:
		return
	if _way.size() == 2 and _is_seen(camera, _way[0]) and _is_seen(camera, _way[1]):
		var from := camera.unproject_position(_way[0])
		draw_line(from, camera.unproject_position(_way[1]), Color(MotionStrip.OUTPUT, 0.4), WIDTH)
	if _is_seen(camera, _measured):
		var at := camera.unproject_position(_measured)
		draw_arc(at, RADIUS, 0.0, TAU, 32, MotionStrip.MEASURED, WIDTH, true)
	if _is_seen(camera, _output):
		var at := camera.unproject_position(_output)
		draw_circle(at, 0.6 * RADIUS, MotionStrip.OUTPUT)


func _is_seen(camera: Camera3D, place: Vector3) -> bool:
	return place.is_finite() and not camera.is_position_behind(place)
