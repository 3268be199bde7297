@tool
extends HSplitContainer
## The takes of a gesture, and the curve of the one that is selected.

signal trim_changed(take: int, start_s: float, end_s: float)
signal trim_proposed(take: int)
signal delete_pressed(takes: PackedInt32Array)

const TakeSet := preload("take_set.gd")
const TakeView := preload("take_view.gd")
const TrackCurves := preload("track_curves.gd")

const VIEW_WIDTH := 140.0
const TITLES: Array[String] = ["Take", "Time (s)", "Amplitude (cm)", "R²"]
const WIDTHS: Array[float] = [70.0, 62.0, 104.0, 60.0]
const SCROLL_BAR_WIDTH := 14.0

var view := TakeView.new()

var _list := Tree.new()
var _trim := Button.new()
var _delete := Button.new()
var _takes: TakeSet = null
## Results of the last training, by the take's name.
var _recordings: Dictionary[String, Dictionary] = {}


func _init() -> void:
	var left := VBoxContainer.new()
	add_child(left)
	_list.columns = TITLES.size()
	_list.hide_root = true
	_list.column_titles_visible = true
	_list.select_mode = Tree.SELECT_MULTI
	for column in TITLES.size():
		_list.set_column_title(column, TITLES[column])
		_list.set_column_title_alignment(column, HORIZONTAL_ALIGNMENT_LEFT)
		var width := WIDTHS[column] * EditorInterface.get_editor_scale()
		_list.set_column_custom_minimum_width(column, int(width))
		_list.custom_minimum_size.x += width
	_list.size_flags_vertical = SIZE_EXPAND_FILL
	_list.custom_minimum_size.x += SCROLL_BAR_WIDTH * EditorInterface.get_editor_scale()
	_list.scroll_horizontal_enabled = false
	_list.multi_selected.connect(func(_i: TreeItem, _c: int, _s: bool) -> void: _show_selected())
	_list.gui_input.connect(_on_list_input)
	left.add_child(_list)
	var buttons := HBoxContainer.new()
	left.add_child(buttons)
	_trim.text = "Reset Trim"
	_trim.tooltip_text = "Trim the take to where its movement begins and ends."
	_trim.pressed.connect(func() -> void: trim_proposed.emit(selected()[0]))
	_delete.text = "Delete"
	_delete.tooltip_text = "Take the selected takes out of the set. Their files are kept."
	_delete.pressed.connect(func() -> void: delete_pressed.emit(selected()))
	for button: Button in [_trim, _delete]:
		buttons.add_child(button)
	view.size_flags_horizontal = SIZE_EXPAND_FILL
	view.custom_minimum_size.x = VIEW_WIDTH * EditorInterface.get_editor_scale()
	view.trim_changed.connect(
		func(start_s: float, end_s: float) -> void: trim_changed.emit(selected()[0], start_s, end_s)
	)
	add_child(view)


func show_takes(takes: TakeSet) -> void:
	var shown := selected()
	if takes != _takes:
		_recordings = {}
		shown = []
	_takes = takes
	_list.clear()
	_list.create_item()
	if takes != null:
		for i in takes.rows.size():
			_add_item(i, i in shown)
	_show_selected()


## Shows the result of the training for each take: see GestureTrainer.get_recordings().
func mark(recordings: Array[Dictionary]) -> void:
	_recordings = {}
	for recording in recordings:
		_recordings[recording["trial"]] = recording
	show_takes(_takes)


func select(take: int) -> void:
	_list.deselect_all()
	var item := _list.get_root().get_child(take)
	for column in TITLES.size():
		item.select(column)
	_list.scroll_to_item(item)
	_show_selected()


func selected() -> PackedInt32Array:
	var found := PackedInt32Array()
	var root := _list.get_root()
	if root != null:
		for item in root.get_children():
			if item.is_selected(0):
				found.append(item.get_index())
	return found


func _add_item(take: int, is_selected: bool) -> void:
	var row := _takes.rows[take]
	var item := _list.create_item()
	item.set_text(0, row["trial"])
	item.set_text(1, "%.2f" % (row["end_s"] - row["start_s"]))
	item.set_text(2, "%.1f" % (100.0 * row["amplitude_m"]))
	var recording: Dictionary = _recordings.get(row["trial"], {})
	if not recording.is_empty():
		var oddity: String = recording["oddity"]
		item.set_text(3, "%.3f" % recording["r2"] if oddity.is_empty() else "left out")
		if not recording["kept"]:
			item.set_custom_color(3, get_theme_color(&"error_color", &"Editor"))
			var unlike := "It is unlike the mean of all takes, and was not used."
			item.set_tooltip_text(3, unlike if oddity.is_empty() else oddity)
	if is_selected:
		for column in TITLES.size():
			item.select(column)


func _show_selected() -> void:
	var which := selected()
	_trim.disabled = which.size() != 1
	_delete.disabled = which.is_empty()
	if which.size() != 1:
		var is_empty := _takes == null or _takes.rows.is_empty()
		view.show_message("No takes yet" if is_empty else "Select a take to trim it")
		return
	var take := which[0]
	var row := _takes.rows[take]
	var curves := _takes.curves_of(take)
	var has_hand := curves.count() > 0
	var curve := MotionMetrics.feature_curve(
		RecordedTrack.load_file(_takes.measured_path(take)) if has_hand else null,
		_takes.feature_of(take),
		row,
		curves.start_s,
		TrackCurves.RATE_HZ,
		curves.count()
	)
	for i in curve.size():
		curve[i] *= row["amplitude_m"]
	view.show_take(curve, curves.start_s, [row["start_s"], row["end_s"]])


func _on_list_input(event: InputEvent) -> void:
	var key := event as InputEventKey
	var is_delete := key != null and key.pressed and key.keycode == KEY_DELETE
	if is_delete and not selected().is_empty():
		delete_pressed.emit(selected())
		_list.accept_event()
