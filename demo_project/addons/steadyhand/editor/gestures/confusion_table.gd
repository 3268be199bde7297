@tool
extends VBoxContainer
## Counts as which gesture each take was recognised: a row for each gesture made.

const NONE := "none"
const TITLE := "made \\ recognised"

var table := {}

var _grid := Tree.new()
var _note := Label.new()


func _init() -> void:
	_grid.hide_root = true
	_grid.column_titles_visible = true
	_grid.size_flags_vertical = SIZE_EXPAND_FILL
	_grid.select_mode = Tree.SELECT_ROW
	add_child(_grid)
	_note.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	_note.text = "Compare runs the takes of all gestures through all models, without a task."
	add_child(_note)


## `counts`: as MotionMetrics.confusion(). `left_out`: gestures that need a task.
func show_table(counts: Dictionary, left_out: PackedStringArray) -> void:
	table = counts
	_grid.clear()
	_grid.create_item()
	var columns: Array = [] if counts.is_empty() else (counts.values()[0] as Dictionary).keys()
	_grid.columns = columns.size() + 1
	_grid.set_column_title(0, TITLE)
	for i in columns.size():
		_grid.set_column_title(i + 1, columns[i])
	for made: String in counts:
		var item := _grid.create_item()
		item.set_text(0, made)
		for i in columns.size():
			var expected := NONE if made in left_out else made
			_fill(item, i + 1, counts[made][columns[i]], columns[i] == expected)
	var notes := PackedStringArray()
	if counts.is_empty():
		notes.append("There are no takes to compare.")
	if not left_out.is_empty():
		notes.append(
			"A circle is recognised only at its GestureTask. Left out: " + ", ".join(left_out) + "."
		)
	_note.text = " ".join(notes)
	_note.visible = not notes.is_empty()


func _fill(item: TreeItem, column: int, count: int, is_right: bool) -> void:
	item.set_text(column, str(count) if count > 0 else "·")
	item.set_text_alignment(column, HORIZONTAL_ALIGNMENT_CENTER)
	if count > 0:
		var colour := &"success_color" if is_right else &"error_color"
		item.set_custom_color(column, get_theme_color(colour, &"Editor"))
