extends "scene_test.gd"
## A test inside the editor, started with --editor, with the add-on's plugin as the project has it.

const EditedScene := preload("res://tools/edited_scene.gd")
const GestureDock := preload("res://addons/steadyhand/editor/gestures/gesture_dock.gd")

const LOADING_FRAMES := 20
const PATIENCE_FRAMES := 600

## The panel that the plugin has added.
var dock: GestureDock = null

var _scenes := 0


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


## Opens a new scene with `nodes` in it, as a user does; returns its root.
func open_scene(nodes: Array[Node]) -> Node:
	_scenes += 1
	var path := "res://edited_%d.tscn" % _scenes
	EditedScene.save(nodes, path)
	# Lets the emitter of the awaited signal return first.
	await process_frame
	EditorInterface.open_scene_from_path(path)
	var patience := PATIENCE_FRAMES
	while _edited_path() != path and patience > 0:
		patience -= 1
		await process_frame
	dock.set_scene(EditorInterface.get_edited_scene_root())
	return EditorInterface.get_edited_scene_root()


func _edited_path() -> String:
	var scene := EditorInterface.get_edited_scene_root()
	return "" if scene == null else scene.scene_file_path
