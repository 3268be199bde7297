extends Node3D
## What a task shows. The stage stands where the task is and keeps its own orientation, so that
## camera and ground stay upright whatever the task's direction.


## Puts everything where the task starts. `position_name`: "stable", "unstable" or empty.
func place(_task: GestureTask, _position_name: String) -> void:
	pass


func mark_started() -> void:
	pass


func mark_arrived() -> void:
	pass


## `value`: of the motion element, m.
func show_motion(_value: float) -> void:
	pass


func show_hand(_tracker: HandTracker) -> void:
	pass
