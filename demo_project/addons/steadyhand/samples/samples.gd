extends Node3D
## Lists the samples: tap one, with a finger or by a click.

const Key := preload("key.tscn")
const SAMPLES: Dictionary[String, String] = {
	"Key panel": "key_panel.tscn",
	"Drawer": "drawer.tscn",
	"Slider": "slider.tscn",
	"Pinch and drag": "pinch_drag.tscn",
	"Zoom a map": "zoom_map.tscn",
}
const PITCH_M := 0.06
## In widths of a key.
const WIDTH := 4.0

@onready var _hmm: GestureHMM = $GestureHMM


func _ready() -> void:
	var tasks: Array[GestureTask] = []
	for title in SAMPLES:
		var key := Key.instantiate() as Node3D
		key.position.y = PITCH_M * (0.5 * (SAMPLES.size() - 1) - tasks.size())
		(key.get_node(^"Cap") as Node3D).scale.x = WIDTH
		(key.get_node(^"Cap/Label") as Label3D).scale.x = 1.0 / WIDTH
		(key.get_node(^"Cap/Label") as Label3D).text = title
		$Panel.add_child(key)
		tasks.append(key.get_node(^"GestureTask"))
	_hmm.tasks = tasks
	_hmm.gesture_ended.connect(_on_gesture_ended)


func _on_gesture_ended(_gesture: StringName, _time: float, task: GestureTask, _f: float) -> void:
	var file: String = SAMPLES.values()[_hmm.tasks.find(task)]
	get_tree().change_scene_to_file("res://addons/steadyhand/samples".path_join(file))
