extends SceneTree
## xvfb-run -a godot --editor --rendering-method gl_compatibility --rendering-driver opengl3
##     --audio-driver Dummy --path demo_project --script res://tools/editor_pictures.gd --
##     --out DIR
##
## Pictures of the add-on in the editor: DIR/editor_dock.png, the panel with simulated
## takes of a circle; DIR/editor_recording.png, while it records, after a comparison;
## DIR/editor_gizmos.png, a task and the range of a tracker.

const EditedScene := preload("res://tools/edited_scene.gd")
const GestureDock := preload("res://addons/steadyhand/editor/gestures/gesture_dock.gd")

const SIZE := Vector2i(1920, 1080)
const GESTURE := &"circle"
const TAKES := 8
const LONGEST_TAKE_S := 30.0
const RECORDED_S := 7.0
const ZOOM_STEPS := 18
## The editor shows its zoom level for this time.
const ZOOM_BAR_S := 2.0
const SETTLING_FRAMES := 30

var _is_begun := false
var _out := ""


func _process(_delta: float) -> bool:
	if not _is_begun:
		_is_begun = true
		_draw_all()
	return false


func _draw_all() -> void:
	var arguments := OS.get_cmdline_user_args()
	_out = arguments[arguments.find("--out") + 1]
	while EditorInterface.get_resource_filesystem().is_scanning():
		await process_frame
	await _settle()
	root.size = SIZE
	var dock := EditorInterface.get_base_control().find_child("Gestures", true, false)
	await _draw_dock(dock as GestureDock)
	await _draw_gizmos()
	quit()


func _draw_dock(dock: GestureDock) -> void:
	var folder := DirAccess.create_temp("steadyhand_pictures")
	var tracker := HandTracker.new()
	tracker.name = "HandTracker"
	var source := SyntheticSource.new()
	source.gesture = GESTURE
	tracker.source = source
	var edited: Node = await _open_scene("res://circle.tscn", [tracker])
	EditorPlugin.new().make_bottom_panel_item_visible(dock)
	dock.root_folder = folder.get_current_dir()
	dock.set_scene(edited)
	dock.open_gesture(GESTURE)
	for take in TAKES:
		dock.start_recording()
		dock.get_recorder().get_tracker().advance(LONGEST_TAKE_S)
		await process_frame
	dock.train()
	await dock.training_finished
	await _settle()
	_save("editor_dock.png", dock.get_global_rect())
	dock.compare()
	await dock.comparison_finished
	((edited.get_child(0) as HandTracker).source as SyntheticSource).loop = true
	dock.start_recording()
	dock.get_recorder().get_tracker().advance(RECORDED_S)
	await _settle()
	_save("editor_recording.png", dock.get_global_rect())
	dock.stop_recording()


## A task in front of a Leap device, as seen when the whole scene is selected.
func _draw_gizmos() -> void:
	var tracker := HandTracker.new()
	tracker.name = "HandTracker"
	tracker.source = LeapSource.new()
	var task := GestureTask.new()
	task.name = "Pull"
	task.gesture = &"horizontal_drag"
	task.position = Vector3(-0.1, 0.25, 0.0)
	var root_node: Node = await _open_scene("res://drawer.tscn", [tracker, task])
	EditorInterface.set_main_screen_editor("3D")
	await _settle()
	EditorInterface.get_selection().add_node(root_node.get_node("Pull"))
	await _settle()
	_press_view_item("Focus Selection")
	_press_view_item("View Transform Gizmo")
	_zoom_in()
	await create_timer(ZOOM_BAR_S).timeout
	var view := EditorInterface.get_editor_viewport_3d(0).get_parent() as Control
	_save("editor_gizmos.png", view.get_global_rect())


## An item of the 3D view's menu.
func _press_view_item(text: String) -> void:
	var view := EditorInterface.get_editor_viewport_3d(0).get_parent().get_parent()
	for button: MenuButton in view.find_children("*", "MenuButton", true, false):
		var menu := button.get_popup()
		for index in menu.item_count:
			if menu.get_item_text(index) == text:
				menu.id_pressed.emit(menu.get_item_id(index))


func _zoom_in() -> void:
	var wheel := InputEventMouseButton.new()
	wheel.button_index = MOUSE_BUTTON_WHEEL_UP
	wheel.pressed = true
	var view := EditorInterface.get_editor_viewport_3d(0).get_parent().get_parent()
	for control: Control in view.find_children("*", "Control", true, false):
		for step in ZOOM_STEPS if control.get_signal_connection_list("gui_input").size() > 0 else 0:
			control.gui_input.emit(wheel)


func _open_scene(path: String, nodes: Array[Node]) -> Node:
	EditedScene.save(nodes, path)
	EditorInterface.open_scene_from_path(path)
	await _settle()
	return EditorInterface.get_edited_scene_root()


func _settle() -> void:
	for frame in SETTLING_FRAMES:
		await process_frame


func _save(name: String, region: Rect2) -> void:
	var image := root.get_texture().get_image()
	var saved := image.get_region(Rect2i(region)).save_png(_out.path_join(name))
	print("wrote %s" % name if saved == OK else "cannot write %s" % name)
