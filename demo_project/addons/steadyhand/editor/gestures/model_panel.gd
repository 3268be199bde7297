@tool
extends VBoxContainer
## Trains, compares and saves; shows the model's curve and the confusion of the takes.

signal train_pressed
signal cancel_pressed
signal compare_pressed
signal save_chosen(path: String)

const ConfusionTable := preload("confusion_table.gd")
const ModelView := preload("model_view.gd")

## Share of the editor's window.
const DIALOG_RATIO := 0.5

var view := ModelView.new()
var confusion := ConfusionTable.new()
## Name of the file that the dialog proposes.
var file_name := ""

var _train := Button.new()
var _compare := Button.new()
var _save := Button.new()
var _progress := ProgressBar.new()
var _message := Label.new()
var _tabs := TabContainer.new()
var _file_dialog: EditorFileDialog = null
var _is_training := false


func _init() -> void:
	var row := HBoxContainer.new()
	add_child(row)
	_train.pressed.connect(_on_train_pressed)
	_train.tooltip_text = "Train a model with all takes of this gesture."
	_compare.text = "Compare"
	_compare.tooltip_text = "Run all takes of the project through all of its models."
	_compare.pressed.connect(func() -> void: compare_pressed.emit())
	_save.text = "Save..."
	_save.tooltip_text = "Save the model as a *.gesture file."
	_save.pressed.connect(_ask_where_to_save)
	_progress.max_value = 1.0
	_progress.step = 0.001
	_progress.size_flags_horizontal = SIZE_EXPAND_FILL
	_progress.size_flags_vertical = SIZE_SHRINK_CENTER
	for control: Control in [_train, _compare, _save, _progress]:
		row.add_child(control)
	_message.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	_message.visible = false
	add_child(_message)
	_tabs.size_flags_vertical = SIZE_EXPAND_FILL
	view.name = "Model"
	confusion.name = "Confusion"
	_tabs.add_child(view)
	_tabs.add_child(confusion)
	add_child(_tabs)


func show_tab(tab: Control) -> void:
	_tabs.current_tab = tab.get_index()


func show_progress(done: float) -> void:
	_progress.value = done


## Empty: no error.
func show_message(text: String) -> void:
	_message.text = text
	_message.visible = not text.is_empty()


func get_message() -> String:
	return _message.text


func show_state(has_takes: bool, has_model: bool, is_training: bool, is_comparing: bool) -> void:
	var is_busy := is_training or is_comparing
	_is_training = is_training
	_train.text = "Cancel" if is_training else "Train"
	_train.disabled = is_comparing or not has_takes
	_compare.disabled = is_busy or not has_takes
	_save.disabled = is_busy or not has_model
	_progress.visible = is_busy


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED or what == NOTIFICATION_ENTER_TREE:
		var colour := get_theme_color(&"warning_color", &"Editor")
		_message.add_theme_color_override(&"font_color", colour)


func _on_train_pressed() -> void:
	if _is_training:
		cancel_pressed.emit()
	else:
		train_pressed.emit()


func _ask_where_to_save() -> void:
	if _file_dialog == null:
		_file_dialog = EditorFileDialog.new()
		_file_dialog.file_mode = EditorFileDialog.FILE_MODE_SAVE_FILE
		_file_dialog.add_filter("*.gesture", "Gesture model")
		_file_dialog.file_selected.connect(func(path: String) -> void: save_chosen.emit(path))
		add_child(_file_dialog)
	_file_dialog.current_path = "res://%s.gesture" % file_name
	_file_dialog.popup_centered_ratio(DIALOG_RATIO)
