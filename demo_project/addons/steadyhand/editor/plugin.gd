@tool
extends EditorPlugin
## What the add-on adds to the editor. The nodes work without it.

const EffectInspector := preload("effect_inspector.gd")

var _inspector := EffectInspector.new()


func _enter_tree() -> void:
	add_inspector_plugin(_inspector)


func _exit_tree() -> void:
	remove_inspector_plugin(_inspector)
