extends "stage.gd"
## A box that is dragged from one marker box to another.

## Offset from the path of the fingertip to the centres of box and markers, m.
@export var box_offset := Vector3(0, -0.035, 0)
@export var marker_offset := Vector3(0, -0.08, 0)

var _start := Vector3.ZERO
var _axis := Vector3.RIGHT
var _amplitude := 1.0

@onready var _box: MeshInstance3D = $Box
@onready var _start_marker: MeshInstance3D = $StartMarker
@onready var _stop_marker: MeshInstance3D = $StopMarker


func place(task: GestureTask, position_name: String) -> void:
	super(task, position_name)
	_start = task.get_start()
	_axis = task.get_axis()
	_amplitude = task.amplitude
	var way := _axis * _amplitude
	global_position = _start + 0.5 * way
	_start_marker.global_position = _start + marker_offset
	_stop_marker.global_position = _start + way + marker_offset
	_paint(_start_marker, IDLE)
	_paint(_stop_marker, IDLE)
	show_motion(0.0)


func mark_started() -> void:
	_paint(_start_marker, STARTED)


func mark_arrived() -> void:
	_paint(_stop_marker, ARRIVED)


## Width of the stop marker along the path of the box, m.
func target_width() -> float:
	var size := (_stop_marker.mesh as BoxMesh).size
	var width := INF
	for i in 3:
		if not is_zero_approx(_axis[i]):
			width = minf(width, size[i] / absf(_axis[i]))
	return width


## The start marker keeps its size. The mesh is copied once: both markers share it.
func set_target_width(width_m: float) -> void:
	if _stop_marker.mesh == _start_marker.mesh:
		_stop_marker.mesh = _stop_marker.mesh.duplicate()
	var narrowest := target_width()
	(_stop_marker.mesh as BoxMesh).size *= width_m / narrowest


func show_motion(value: float) -> float:
	_box.global_position = _start + _axis * value + box_offset
	return value / _amplitude
