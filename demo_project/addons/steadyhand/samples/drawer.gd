extends Node3D
## A drawer that opens as the hand pulls its handle, and closes as the hand pushes it back.

signal opened
signal closed

@onready var _hmm: GestureHMM = $GestureHMM
@onready var _open: GestureTask = $Open
@onready var _box: Node3D = $Box
@onready var _closed_z := _box.position.z


func _ready() -> void:
	_hmm.gesture_ended.connect(_on_gesture_ended)


func _process(_delta: float) -> void:
	if _hmm.current_task == null:
		return
	var way := clampf(_hmm.value, 0.0, _open.amplitude)
	# The hand's way back does not count: a pull never closes the drawer, and a push never opens it.
	if _hmm.current_task == _open:
		_box.position.z = maxf(_box.position.z, _closed_z + way)
	else:
		_box.position.z = minf(_box.position.z, _closed_z + _open.amplitude - way)


## How far it is open, 0..1.
func get_opening() -> float:
	return (_box.position.z - _closed_z) / _open.amplitude


func _on_gesture_ended(_gesture: StringName, _time: float, task: GestureTask, _f: float) -> void:
	var is_open := task == _open
	_box.position.z = _closed_z + (_open.amplitude if is_open else 0.0)
	(opened if is_open else closed).emit()
