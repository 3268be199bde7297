@tool
extends EditorPlugin
## What the add-on adds to the editor. The nodes work without it.

const EffectInspector := preload("effect_inspector.gd")
const GameLink := preload("gestures/game_link.gd")
const GestureDock := preload("gestures/gesture_dock.gd")
const TaskGizmo := preload("task_gizmo.gd")
const TrackerGizmo := preload("tracker_gizmo.gd")

## The panel follows the edited scene.
const REFRESH_S := 0.5

var _inspector := EffectInspector.new()
var _task_gizmo := TaskGizmo.new()
var _tracker_gizmo := TrackerGizmo.new()
var _game_link := GameLink.new()
var _dock: GestureDock = null


func _enter_tree() -> void:
	add_inspector_plugin(_inspector)
	add_node_3d_gizmo_plugin(_task_gizmo)
	add_node_3d_gizmo_plugin(_tracker_gizmo)
	_dock = GestureDock.new()
	_dock.undo_redo = get_undo_redo()
	_dock.set_game_link(_game_link)
	add_debugger_plugin(_game_link)
	add_control_to_bottom_panel(_dock, "Gestures")
	_dock.visibility_changed.connect(_show_scene)
	var timer := Timer.new()
	timer.wait_time = REFRESH_S
	timer.autostart = true
	timer.timeout.connect(_show_scene)
	_dock.add_child(timer)
	scene_changed.connect(_dock.set_scene)


func _exit_tree() -> void:
	remove_debugger_plugin(_game_link)
	remove_control_from_bottom_panel(_dock)
	_dock.queue_free()
	remove_node_3d_gizmo_plugin(_tracker_gizmo)
	remove_node_3d_gizmo_plugin(_task_gizmo)
	remove_inspector_plugin(_inspector)


## Trackers and their sources may have changed.
func _show_scene() -> void:
	if _dock.is_visible_in_tree():
		_dock.set_scene(EditorInterface.get_edited_scene_root())
