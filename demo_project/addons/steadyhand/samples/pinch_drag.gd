extends Node3D
## A box that moves only while thumb and index finger hold it.

signal box_placed
signal box_dropped

@onready var _hmm: GestureHMM = $GestureHMM
@onready var _task: GestureTask = $GestureTask
@onready var _box: MeshInstance3D = $Box
@onready var _material: StandardMaterial3D = _box.material_override


func _ready() -> void:
	_hmm.gesture_ended.connect(_on_gesture_ended)
	_hmm.gesture_aborted.connect(_on_gesture_aborted)


func _process(_delta: float) -> void:
	var is_held := _hmm.gesture != &""
	_material.emission_enabled = is_held
	if is_held:
		_box.position.x = _task.position.x + clampf(_hmm.value, 0.0, _task.amplitude)


func _on_gesture_ended(_gesture: StringName, _time: float, _at: GestureTask, _f: float) -> void:
	box_placed.emit()


func _on_gesture_aborted(_gesture: StringName, _at: GestureTask) -> void:
	_box.position.x = _task.position.x
	box_dropped.emit()
