extends "support/scene_test.gd"
## The menu: each button opens its task, Escape returns.

const Tasks := preload("res://scripts/tasks.gd")
const TaskScene := preload("res://scripts/task_scene.gd")


func test_each_button_opens_its_task() -> void:
	for place in Tasks.SCENES.size():
		change_scene_to_file(ProjectSettings.get_setting("application/run/main_scene"))
		await _wait()
		var buttons := current_scene.get_node("%Buttons").get_children()
		check_equal(
			buttons.size(),
			Tasks.SCENES.size() + Tasks.MORE_SCENES.size(),
			"one button for each scene"
		)
		(buttons[place] as Button).pressed.emit()
		await _wait()
		var scene := current_scene as TaskScene
		var gesture: String = Tasks.SCENES.keys()[place]
		check_equal(String(scene.task.gesture), gesture, "%s opens" % gesture)
		check(scene.tracker.is_running(), "and plays")
		var logs := scene.session_folder
		var press := InputEventKey.new()
		press.pressed = true
		press.keycode = KEY_ESCAPE
		root.push_input(press)
		await _wait()
		_remove(logs)
		check_equal(current_scene.scene_file_path, Tasks.MENU, "Escape: the menu")
	current_scene.free()


## A change of scene takes effect at the end of a frame.
func _wait() -> void:
	for frame in 3:
		await process_frame


func _remove(folder: String) -> void:
	for file in DirAccess.get_files_at(folder):
		DirAccess.remove_absolute(folder.path_join(file))
	DirAccess.remove_absolute(folder)
