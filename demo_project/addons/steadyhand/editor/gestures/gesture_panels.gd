@tool
extends Control
## The three parts of the "Gestures" panel side by side, and their messages.

const ModelPanel := preload("model_panel.gd")
const RecordPanel := preload("record_panel.gd")
const TakePanel := preload("take_panel.gd")

## Pixels, before the editor's scale.
const HEIGHT := 280.0
const RECORD_WIDTH := 200.0
## Width of the takes relative to the model's.
const TAKES_STRETCH := 1.3

var _record_panel := RecordPanel.new()
var _take_panel := TakePanel.new()
var _model_panel := ModelPanel.new()


func _init() -> void:
	name = "Gestures"
	custom_minimum_size = Vector2(0.0, HEIGHT * EditorInterface.get_editor_scale())
	_record_panel.custom_minimum_size.x = RECORD_WIDTH * EditorInterface.get_editor_scale()
	# For a window that is too small.
	var scroll := ScrollContainer.new()
	scroll.set_anchors_preset(Control.PRESET_FULL_RECT)
	add_child(scroll)
	var columns := HSplitContainer.new()
	columns.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	columns.size_flags_vertical = Control.SIZE_EXPAND_FILL
	scroll.add_child(columns)
	columns.add_child(_record_panel)
	var right := HSplitContainer.new()
	columns.add_child(right)
	for panel: Control in [_take_panel, _model_panel]:
		panel.size_flags_horizontal = Control.SIZE_EXPAND_FILL
		right.add_child(panel)
	_take_panel.size_flags_stretch_ratio = TAKES_STRETCH


## The error that the panel shows. Empty: none.
func get_message() -> String:
	var text := _record_panel.get_message()
	return _model_panel.get_message() if text.is_empty() else text


## The last comparison, as MotionMetrics.confusion().
func get_confusion() -> Dictionary:
	return _model_panel.confusion.table


## About the takes, below the button that records.
func _show_message(text: String) -> void:
	_record_panel.show_message(text)
	_model_panel.show_message("")


## About the model, above its curve.
func _show_model_message(text: String) -> void:
	_record_panel.show_message("")
	_model_panel.show_message(text)
