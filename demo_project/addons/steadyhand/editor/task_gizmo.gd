@tool
extends EditorNode3DGizmoPlugin
## Shows each GestureTask in the 3D view: an arrow from its start to its end, or the two circles of
## a radius; and the cylinder in which a gesture may begin.

const TaskShape := preload("task_shape.gd")


func _init() -> void:
	create_material("way", Color(0.2, 0.75, 1.0))
	create_material("start", Color(0.2, 0.75, 1.0, 0.5))


func _get_gizmo_name() -> String:
	return "GestureTask"


func _has_gizmo(node: Node3D) -> bool:
	return node is GestureTask


func _redraw(gizmo: EditorNode3DGizmo) -> void:
	gizmo.clear()
	var task := gizmo.get_node_3d() as GestureTask
	var start := TaskShape.start_cylinder(task)
	if not start.is_empty():
		gizmo.add_lines(start, get_material("start", gizmo))
	var lines := TaskShape.lines(task)
	if not lines.is_empty():
		gizmo.add_lines(lines, get_material("way", gizmo))
		gizmo.add_collision_segments(lines)
