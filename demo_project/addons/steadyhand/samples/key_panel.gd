extends Node3D
## Keys of 5 cm that a fingertip taps. Each has a GestureTask: a tap presses the key of the task at
## which it ends.

signal key_pressed(key: String)

const Key := preload("res://addons/steadyhand/samples/key.tscn")
const KEYS := "123456789*0#"
const PITCH_M := 0.06
## A tap starts 4 cm above a key, and ends where the key is pressed down.
const LIFT_M := 0.04

@onready var _hmm: GestureHMM = $GestureHMM
@onready var _display: Label3D = $Panel/Display


func _ready() -> void:
	var tasks: Array[GestureTask] = []
	for i in KEYS.length():
		var key := Key.instantiate() as Node3D
		key.position = PITCH_M * Vector3(i % 3 - 1, 1 - floorf(i / 3.0), 0)
		(key.get_node(^"Cap/Label") as Label3D).text = KEYS[i]
		$Panel.add_child(key)
		tasks.append(key.get_node(^"GestureTask"))
	_hmm.tasks = tasks
	_hmm.gesture_ended.connect(_on_gesture_ended)


func _process(_delta: float) -> void:
	for task in _hmm.tasks:
		var depth := _hmm.value - LIFT_M if task == _hmm.current_task else 0.0
		var cap := task.get_node(^"../Cap") as Node3D
		cap.position.z = -0.01 - clampf(depth, 0.0, task.amplitude - LIFT_M)


func _on_gesture_ended(_gesture: StringName, _time: float, task: GestureTask, _f: float) -> void:
	var key := KEYS[_hmm.tasks.find(task)]
	_display.text = (_display.text + key).right(9)
	key_pressed.emit(key)
