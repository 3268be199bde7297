@tool
extends VBoxContainer
## Which gesture is recorded, from which tracker; the tracker's state, and what to do next.

signal gesture_chosen(gesture: String)
signal record_pressed

const Movements := preload("movements.gd")

const SHAPES: Dictionary[Movements.Shape, String] = {
	Movements.Shape.AUTOMATIC: "As recorded",
	Movements.Shape.STRAIGHT: "Straight",
	Movements.Shape.CIRCLE: "Circle",
	Movements.Shape.OPENING: "Fingers that open",
}

var shape := Movements.Shape.AUTOMATIC

var _name := LineEdit.new()
var _names := MenuButton.new()
var _tracker := OptionButton.new()
var _shape := OptionButton.new()
var _record := Button.new()
var _state := Label.new()
var _hint := Label.new()
var _message := Label.new()
## Null: the running game's.
var _trackers: Array[HandTracker] = []
var _game_tracker := ""


func _init() -> void:
	var fields := GridContainer.new()
	fields.columns = 2
	add_child(fields)
	var name_row := HBoxContainer.new()
	_name.placeholder_text = "knock"
	_name.size_flags_horizontal = SIZE_EXPAND_FILL
	_name.text_submitted.connect(func(text: String) -> void: gesture_chosen.emit(text))
	_name.focus_exited.connect(_on_name_left)
	_names.tooltip_text = "Gestures that have takes"
	_names.flat = false
	_names.get_popup().index_pressed.connect(_on_name_picked)
	name_row.add_child(_name)
	name_row.add_child(_names)
	_tracker.clip_text = true
	_tracker.tooltip_text = "The HandTrackers of the edited scene"
	for of_shape in SHAPES:
		_shape.add_item(SHAPES[of_shape], of_shape)
	_shape.item_selected.connect(
		func(index: int) -> void: shape = _shape.get_item_id(index) as Movements.Shape
	)
	_shape.tooltip_text = (
		"What moves: the index fingertip straight or around a circle, or the tips of thumb, "
		+ "index and middle finger as they open"
	)
	var titles := ["Gesture", "Tracker", "Movement"]
	var controls: Array[Control] = [name_row, _tracker, _shape]
	for i in titles.size():
		var title := Label.new()
		title.text = titles[i]
		fields.add_child(title)
		controls[i].size_flags_horizontal = SIZE_EXPAND_FILL
		fields.add_child(controls[i])
	_record.pressed.connect(func() -> void: record_pressed.emit())
	add_child(_record)
	for label: Label in [_state, _hint, _message]:
		label.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
		label.custom_minimum_size.x = 1.0
		add_child(label)


func list_gestures(gestures: PackedStringArray) -> void:
	_names.get_popup().clear()
	for gesture in gestures:
		_names.get_popup().add_item(gesture)
	_names.disabled = gestures.is_empty()


## Keeps the choice. May be called at any time: an unchanged list stays as it is.
func list_trackers(scene_root: Node) -> void:
	var found: Array[HandTracker] = []
	if scene_root != null:
		_collect(scene_root, found)
	if not _game_tracker.is_empty():
		found.append(null)
	var names := found.map(
		func(one: HandTracker) -> String:
			return String(one.name) if one != null else "%s (running game)" % _game_tracker
	)
	if found == _trackers and names == range(_tracker.item_count).map(_tracker.get_item_text):
		return
	var chosen := tracker()
	var had_game := is_game_chosen()
	_trackers = found
	_tracker.clear()
	for text: String in names:
		_tracker.add_item(text)
	_tracker.disabled = _trackers.is_empty()
	if had_game or chosen != null:
		choose_tracker(chosen)


## `tracker_name`: empty when the game ends. A game is chosen when it starts.
func show_game(tracker_name: String, scene_root: Node) -> void:
	_game_tracker = tracker_name
	list_trackers(scene_root)
	if not tracker_name.is_empty():
		choose_tracker(null)


## Null: the running game's.
func choose_tracker(wanted: HandTracker) -> void:
	if wanted in _trackers:
		_tracker.select(_trackers.find(wanted))


## Null if the scene has none, and for the running game's.
func tracker() -> HandTracker:
	var index := _tracker.selected
	if index < 0 or index >= _trackers.size() or not is_instance_valid(_trackers[index]):
		return null
	return _trackers[index]


func is_game_chosen() -> bool:
	return not _game_tracker.is_empty() and _tracker.selected == _trackers.size() - 1


func gesture() -> String:
	return _name.text


func show_gesture(text: String) -> void:
	_name.text = text


func show_state(state: String, hint: String, is_recording: bool) -> void:
	_state.text = state
	_hint.text = hint
	_record.text = "Stop" if is_recording else "Record"
	_name.editable = not is_recording
	for control: BaseButton in [_tracker, _shape, _names]:
		control.disabled = is_recording
	if is_inside_tree():
		_record.icon = get_theme_icon(&"Stop" if is_recording else &"AutoKey", &"EditorIcons")


## The error of the recording. Empty: none.
func show_message(text: String) -> void:
	_message.text = text
	_message.visible = not text.is_empty()


func get_message() -> String:
	return _message.text


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED or what == NOTIFICATION_ENTER_TREE:
		_names.icon = get_theme_icon(&"GuiOptionArrow", &"EditorIcons")
		_state.add_theme_color_override(&"font_color", get_theme_color(&"accent_color", &"Editor"))


func _collect(node: Node, found: Array[HandTracker]) -> void:
	if node is HandTracker:
		found.append(node)
	for child in node.get_children():
		_collect(child, found)


func _on_name_left() -> void:
	gesture_chosen.emit(_name.text)


func _on_name_picked(index: int) -> void:
	gesture_chosen.emit(_names.get_popup().get_item_text(index))
