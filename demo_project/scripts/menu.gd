extends Control
## Chooses a task.

const Participant := preload("participant.gd")
const Tasks := preload("tasks.gd")


func _ready() -> void:
	for gesture in Tasks.SCENES:
		var button := Button.new()
		button.text = gesture.capitalize()
		button.custom_minimum_size = Vector2(320, 56)
		button.pressed.connect(get_tree().change_scene_to_file.bind(Tasks.SCENES[gesture]))
		%Buttons.add_child(button)
	(%Buttons.get_child(0) as Button).grab_focus()
	(%Participant as LineEdit).text = Participant.chosen
	(%Participant as LineEdit).text_changed.connect(_choose)


func _choose(name: String) -> void:
	Participant.chosen = name.strip_edges()
