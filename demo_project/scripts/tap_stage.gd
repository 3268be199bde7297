extends "stage.gd"
## A surface that is tapped. A ring around the fingertip follows the motion.

var _start := Vector3.ZERO
var _axis := Vector3.FORWARD
var _amplitude := 1.0

@onready var _surface: MeshInstance3D = $Surface
@onready var _way: MeshInstance3D = $Way
@onready var _pointer: MeshInstance3D = $Pointer


func place(task: GestureTask, position_name: String) -> void:
	super(task, position_name)
	_start = task.get_start()
	_axis = task.get_axis()
	_amplitude = task.amplitude
	global_position = _start + 0.5 * _axis * _amplitude
	var facing := Basis(Quaternion(Vector3.UP, _axis))
	var thickness := (_surface.mesh as BoxMesh).size.y
	_surface.global_transform = Transform3D(facing, _start + _axis * (_amplitude + 0.5 * thickness))
	_way.global_transform = Transform3D(
		facing.scaled_local(Vector3(1, _amplitude, 1)), global_position
	)
	_pointer.global_basis = facing
	_paint(_surface, IDLE)
	show_motion(0.0)


func mark_arrived() -> void:
	_paint(_surface, ARRIVED)


## Thickness of the plate, from the tapped face to the other one.
func target_width() -> float:
	return (_surface.mesh as BoxMesh).size.y


func set_target_width(width_m: float) -> void:
	(_surface.mesh as BoxMesh).size.y = width_m
	var middle := _start + _axis * (_amplitude + 0.5 * width_m)
	_surface.global_position = middle


func show_motion(value: float) -> float:
	_pointer.global_position = _start + _axis * value
	return value / _amplitude
