extends "scene_test.gd"
## A test inside the editor, started with --editor, with the add-on's plugin as the project has it.

const GestureDock := preload("res://addons/steadyhand/editor/gestures/gesture_dock.gd")

const LOADING_FRAMES := 20

## The panel that the plugin has added.
var dock: GestureDock = null


func _run() -> void:
	while EditorInterface.get_resource_filesystem().is_scanning():
		await process_frame
	for frame in LOADING_FRAMES:
		await process_frame
	dock = EditorInterface.get_base_control().find_child("Gestures", true, false) as GestureDock
	if dock == null:
		check(false, "the plugin has added the panel")
		await _finish()
	else:
		await super()
