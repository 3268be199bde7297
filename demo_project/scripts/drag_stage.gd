extends "stage.gd"
## A box that is dragged from one marker box to another.

const IDLE := Color(0.5, 0.53, 0.56)
const STARTED := Color(0.0, 0.35, 0.85)
const ARRIVED := Color(0.85, 0.1, 0.1)
const TRACKED := Color(1.0, 0.82, 0.62)
const LOST := Color(0.35, 0.35, 0.35)
const PLACES: Dictionary[String, Color] = {
	"stable": Color(0.0, 0.62, 0.45, 0.45),
	"unstable": Color(0.9, 0.6, 0.0, 0.45),
	"": Color(0.34, 0.71, 0.91, 0.45),
}

## From the path of the fingertip to the box's centre and to the markers', m.
@export var box_offset := Vector3(0, -0.035, 0)
@export var marker_offset := Vector3(0, -0.08, 0)

var _start := Vector3.ZERO
var _axis := Vector3.RIGHT

@onready var _box: MeshInstance3D = $Box
@onready var _start_marker: MeshInstance3D = $StartMarker
@onready var _stop_marker: MeshInstance3D = $StopMarker
@onready var _fingertip: MeshInstance3D = $Fingertip
@onready var _hand_place: MeshInstance3D = $HandPlace


func place(task: GestureTask, position_name: String) -> void:
	_start = task.get_start()
	_axis = task.get_axis()
	var way := _axis * task.amplitude
	global_position = _start + 0.5 * way
	_start_marker.global_position = _start + marker_offset
	_stop_marker.global_position = _start + way + marker_offset
	_paint(_start_marker, IDLE)
	_paint(_stop_marker, IDLE)
	_paint(_hand_place, PLACES[position_name])
	show_motion(0.0)


func mark_started() -> void:
	_paint(_start_marker, STARTED)


func mark_arrived() -> void:
	_paint(_stop_marker, ARRIVED)


func show_motion(value: float) -> void:
	_box.global_position = _start + _axis * value + box_offset


func show_hand(tracker: HandTracker) -> void:
	var is_tracked := tracker.is_joint_tracked(HandTracker.JOINT_INDEX)
	_paint(_fingertip, TRACKED if is_tracked else LOST)
	if is_tracked:
		_fingertip.global_position = tracker.get_joint_position(HandTracker.JOINT_INDEX)


static func _paint(body: MeshInstance3D, colour: Color) -> void:
	(body.material_override as StandardMaterial3D).albedo_color = colour
