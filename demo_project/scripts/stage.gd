extends Node3D
## Shows a task: the fingertips that make the gesture, and a cylinder that marks the hand's
## place. The stage stands where the task is and keeps its own orientation, so that camera and
## ground stay upright whatever the task's direction.

const SensorView := preload("sensor_view.gd")

const IDLE := Color(0.5, 0.53, 0.56)
const STARTED := Color(0.0, 0.35, 0.85)
const ARRIVED := Color(0.85, 0.1, 0.1)
const TRACKED := Color(0.95, 0.55, 0.3)
const LOST := Color(0.35, 0.35, 0.35)
const PLACES: Dictionary[String, Color] = {
	"stable": Color(0.0, 0.62, 0.45, 0.45),
	"unstable": Color(0.9, 0.6, 0.0, 0.45),
	"": Color(0.34, 0.71, 0.91, 0.45),
}

## Joints that make the gesture, of HandTracker.Joint.
@export var joints: PackedInt32Array = [HandTracker.JOINT_INDEX]

## Whether a task may take several gestures.
var strokes_add_up := false

var _sensor: SensorView = null

@onready var _fingertips: Array[Node] = $Fingertips.get_children()
@onready var _hand_place: MeshInstance3D = $HandPlace
@onready var _ground: Node3D = $Ground


func _ready() -> void:
	# Not earlier, because an inherited scene replaces this script.
	_sensor = SensorView.new()
	_sensor.visible = false
	add_child(_sensor)


## Puts everything where the task starts. `position_name`: "stable", "unstable" or empty.
func place(_task: GestureTask, position_name: String) -> void:
	_paint(_hand_place, PLACES[position_name])
	for i in _fingertips.size():
		(_fingertips[i] as Node3D).visible = i < joints.size()


## The first gesture of the task has begun.
func mark_started() -> void:
	pass


func mark_arrived() -> void:
	pass


## A gesture has begun, the first or a further one.
func begin_stroke() -> void:
	pass


## `value`: of the motion element, m. Returns the progress of the task, 0..1.
func show_motion(_value: float) -> float:
	return 0.0


## Width of the target along the motion element, m. NAN: it has no width.
func target_width() -> float:
	return NAN


## Sets the width of the target, m. Call it after place().
func set_target_width(_width_m: float) -> void:
	pass


## Progress of the task, m, if a gesture ends at `value` of its motion element. It is greater than
## the amplitude if the hand overshoots.
func end_value(value: float) -> float:
	return value


func show_hand(tracker: HandTracker) -> void:
	_sensor.visible = SensorView.suits(tracker.source)
	if _sensor.visible:
		_sensor.place(_ground.global_position.y)
	for i in joints.size():
		var tip: MeshInstance3D = _fingertips[i]
		if tracker.is_joint_tracked(joints[i]):
			tip.global_position = tracker.get_joint_position(joints[i])
	_paint(_fingertips[0], TRACKED if _is_hand_tracked(tracker) else LOST)


func _is_hand_tracked(tracker: HandTracker) -> bool:
	for joint in joints:
		if not tracker.is_joint_tracked(joint):
			return false
	return true


## The material may be shared: fingertips change colour together.
static func _paint(body: MeshInstance3D, colour: Color) -> void:
	(body.material_override as StandardMaterial3D).albedo_color = colour
