extends Node3D
## A slider whose knob follows the fingertip, and stays where the finger stops or leaves it.

## A fingertip farther from the rail does not move the knob.
const REACH_M := 0.05

## 0..1.
var value := 0.0

@onready var _hmm: GestureHMM = $GestureHMM
@onready var _task: GestureTask = $Rail/GestureTask
@onready var _hand: HandTracker = $Hand
@onready var _knob: Node3D = $Rail/Knob
@onready var _fill: Node3D = $Rail/Fill


func _process(_delta: float) -> void:
	if not _is_touched():
		return
	# At a task, GestureHMM.value follows the hand at all times, also before a gesture ends.
	value = clampf(_hmm.value / _task.amplitude, 0.0, 1.0)
	var way := value * _task.amplitude
	_knob.position.x = _task.position.x + way
	_fill.position.x = _task.position.x + 0.5 * way
	_fill.scale.x = maxf(way, 1e-3)
	($Rail/Value as Label3D).text = "%.2f" % value


func _is_touched() -> bool:
	var tip := _hand.get_joint_position(HandTracker.JOINT_INDEX)
	var from := _task.get_start()
	var to := from + _task.amplitude * _task.get_axis()
	var nearest := Geometry3D.get_closest_point_to_segment(tip, from, to)
	return _hand.is_hand_tracked() and tip.distance_to(nearest) < REACH_M
