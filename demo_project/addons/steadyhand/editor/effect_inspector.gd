@tool
extends EditorInspectorPlugin
## Shows a preview of a HapticEffect above its properties.

const EffectPreview := preload("effect_preview.gd")


func _can_handle(object: Object) -> bool:
	return object is HapticEffect


func _parse_begin(object: Object) -> void:
	var preview := EffectPreview.new()
	preview.effect = object as HapticEffect
	add_custom_control(preview)
