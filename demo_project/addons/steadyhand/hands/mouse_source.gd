@icon("../icons/hand_source.svg")
class_name MouseSource
extends HandSource
## The mouse in place of a hand, to try a scene at a desk. The pointer covers the tip of the index
## finger, on a plane through the start of a task, seen by the viewport's camera. The left button
## brings thumb and index together. At a task for a tap, the button taps at the pointer. At a task
## for a zoom, the wheel opens and closes three fingertips.

const HandPose := preload("hand_pose.gd")
const MinimumJerk := preload("minimum_jerk.gd")

const STRIKE_S := 0.25
const PINCH_S := 0.15
const OPENING_S := 0.4
## Share of the task's amplitude for a notch of the wheel.
const NOTCH := 0.5

## The GestureTask, as seen from the HandTracker; not needed after place_at().
@export_node_path("GestureTask") var task_path: NodePath

var _is_placed := false
var _start_place := Vector3.ZERO
var _axis := Vector3.RIGHT
var _amplitude := 0.0
var _start_radius := 0.0
var _is_tap := false

var _pointer: Pointer = null
## Shares: of a pinch or a tap, and of the amplitude of a zoom.
var _press := MinimumJerk.new(0.0)
var _opening := MinimumJerk.new(0.0)


## Takes the present place, direction and gesture of `task`.
func place_at(task: GestureTask) -> void:
	_is_placed = true
	_start_place = task.get_start()
	_axis = task.get_axis()
	_amplitude = task.amplitude
	_start_radius = task.start_radius
	_is_tap = task.gesture == &"tap"


func _start(tracker: HandTracker) -> String:
	var task := tracker.get_node_or_null(task_path) as GestureTask
	if task != null:
		place_at(task)
	elif not _is_placed:
		return 'set "task_path" of the MouseSource to a GestureTask, or call place_at()'
	_pointer = Pointer.new()
	tracker.add_child(_pointer, false, Node.INTERNAL_MODE_BACK)
	return ""


func _stop(_tracker: HandTracker) -> void:
	_pointer.queue_free()


func _poll(tracker: HandTracker, time_s: float) -> void:
	var place: Variant = _place_of(tracker.get_viewport().get_camera_3d())
	if place == null:
		tracker.push_frame(time_s, {})
		return
	var pressed := 1.0 if _pointer.is_pressed else 0.0
	if pressed != _press.target:
		_press.go(pressed, time_s, STRIKE_S if _is_tap else PINCH_S)
	if _pointer.opening != _opening.target:
		_opening.go(_pointer.opening, time_s, OPENING_S)
	tracker.push_frame(time_s, _joints(place as Vector3 + HandPose.tremor(time_s), time_s))


func _joints(place: Vector3, time_s: float) -> Dictionary:
	if _start_radius > 0.0:
		var opening: float = _opening.at(time_s)
		return HandPose.circle(place, _start_radius + opening * _amplitude)
	var press: float = _press.at(time_s)
	if _is_tap:
		return HandPose.pointing(place - (1.0 - press) * _amplitude * _axis, HandPose.OPEN_M)
	return HandPose.pointing(place, lerpf(HandPose.OPEN_M, HandPose.PINCHED_M, press))


## Where the pointer is on the task's plane, m. Null: it is not on the plane, or there is no camera.
## The plane of a tap is the tapped surface.
func _place_of(camera: Camera3D) -> Variant:
	if camera == null:
		return null
	if _is_tap:
		var surface := Plane(_axis, _start_place + _amplitude * _axis)
		return hit(camera, _pointer.position, surface)
	return hit(camera, _pointer.position, plane_along(_axis, _start_place, camera))


## Contains `axis` and `place`, m, and faces the camera as far as possible.
static func plane_along(axis: Vector3, place: Vector3, camera: Camera3D) -> Plane:
	var view := camera.global_basis.z
	return Plane((view - axis * view.dot(axis)).normalized(), place)


## Where `pointer`, a point of the viewport, covers `plane`, m. Null: it does not.
static func hit(camera: Camera3D, pointer: Vector2, plane: Plane) -> Variant:
	return plane.intersects_ray(
		camera.project_ray_origin(pointer), camera.project_ray_normal(pointer)
	)


## Collects the mouse's input, because a resource gets none.
class Pointer:
	extends Node
	var position := Vector2.ZERO
	var is_pressed := false
	## Share of a zoom, 0..1.
	var opening := 0.0

	func _input(event: InputEvent) -> void:
		var mouse := event as InputEventMouse
		if mouse == null:
			return
		position = mouse.position
		var button := mouse as InputEventMouseButton
		if button == null:
			return
		if button.button_index == MOUSE_BUTTON_LEFT:
			is_pressed = button.pressed
		elif button.pressed and button.button_index == MOUSE_BUTTON_WHEEL_UP:
			opening = minf(opening + NOTCH, 1.0)
		elif button.pressed and button.button_index == MOUSE_BUTTON_WHEEL_DOWN:
			opening = maxf(opening - NOTCH, 0.0)
