extends Control
## Chooses a task, or the study.

const Participant := preload("participant.gd")
const Tasks := preload("tasks.gd")


func _ready() -> void:
	for gesture in Tasks.SCENES:
		_add_button(gesture.capitalize(), Tasks.SCENES[gesture])
	for title in Tasks.MORE_SCENES:
		_add_button(title, Tasks.MORE_SCENES[title])
	(%Buttons.get_child(0) as Button).grab_focus()
	(%Participant as LineEdit).text = Participant.chosen
	(%Participant as LineEdit).text_changed.connect(_choose)


func _add_button(text: String, scene: String) -> void:
	var button := Button.new()
	button.text = text
	button.custom_minimum_size = Vector2(320, 56)
	button.pressed.connect(get_tree().change_scene_to_file.bind(scene))
	%Buttons.add_child(button)


func _choose(name: String) -> void:
	Participant.chosen = name.strip_edges()
