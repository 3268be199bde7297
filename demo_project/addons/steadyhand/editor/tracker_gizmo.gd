@tool
extends EditorNode3DGizmoPlugin
## Shows in the 3D view the range of a HandTracker's device, if its maker states one.

const TrackerShape := preload("tracker_shape.gd")


func _init() -> void:
	create_material("range", Color(0.45, 0.95, 0.75))


func _get_gizmo_name() -> String:
	return "HandTracker"


func _has_gizmo(node: Node3D) -> bool:
	return node is HandTracker


func _redraw(gizmo: EditorNode3DGizmo) -> void:
	gizmo.clear()
	var lines := TrackerShape.lines(gizmo.get_node_3d() as HandTracker)
	if not lines.is_empty():
		gizmo.add_lines(lines, get_material("range", gizmo))
		gizmo.add_collision_segments(lines)
