@tool
extends EditorPlugin
## What the add-on adds to the editor. The nodes work without it.

const EffectInspector := preload("effect_inspector.gd")
const TaskGizmo := preload("task_gizmo.gd")

var _inspector := EffectInspector.new()
var _task_gizmo := TaskGizmo.new()


func _enter_tree() -> void:
	add_inspector_plugin(_inspector)
	add_node_3d_gizmo_plugin(_task_gizmo)


func _exit_tree() -> void:
	remove_node_3d_gizmo_plugin(_task_gizmo)
	remove_inspector_plugin(_inspector)
