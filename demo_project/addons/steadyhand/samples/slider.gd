extends Node3D
## A slider whose knob follows the fingertip, and stays where the finger stops or leaves it.

signal value_changed(value: float)

## Farther from the rail the fingertip does not move the knob.
const REACH_M := 0.05

var value := 0.0

@onready var _hmm: GestureHMM = $GestureHMM
@onready var _task: GestureTask = $Rail/GestureTask
@onready var _hand: HandTracker = $Hand


func _process(_delta: float) -> void:
	if not _is_touched():
		return
	# Of a task, GestureHMM.value is the hand's at all times, with or without a whole gesture.
	var new_value := clampf(_hmm.value / _task.amplitude, 0.0, 1.0)
	if new_value != value:
		value = new_value
		_show_value()
		value_changed.emit(value)


func _is_touched() -> bool:
	var tip := _hand.get_joint_position(HandTracker.JOINT_INDEX)
	var from := _task.get_start()
	var to := from + _task.amplitude * _task.get_axis()
	var nearest := Geometry3D.get_closest_point_to_segment(tip, from, to)
	return _hand.is_hand_tracked() and tip.distance_to(nearest) < REACH_M


func _show_value() -> void:
	var way := value * _task.amplitude
	($Rail/Knob as Node3D).position.x = _task.position.x + way
	($Rail/Fill as Node3D).position.x = _task.position.x + 0.5 * way
	($Rail/Fill as Node3D).scale.x = maxf(way, 1e-3)
	($Rail/Value as Label3D).text = "%.2f" % value
