extends QuestionnairePanel
## Buttons on the screen. Number keys and arrow keys choose, Enter confirms, S skips the item.

const PANEL_STYLE := preload("panel_style.tres")
const THEME := preload("theme.tres")
const WIDTH := 760
## More answers than this are chosen with a slider.
const MOST_BUTTONS := 11

var _asked: Questionnaire = null
var _items: PackedStringArray = []
var _value: Variant = null
var _changes := 0
var _layer := CanvasLayer.new()
var _panel := PanelContainer.new()
var _text := Label.new()
var _scale := HBoxContainer.new()
var _buttons: Array[Button] = []
var _slider: HSlider = null
var _chosen := Label.new()
var _confirm := Button.new()
var _skip := Button.new()


func _ready() -> void:
	_layer.visible = false
	add_child(_layer)
	var centre := CenterContainer.new()
	centre.set_anchors_preset(Control.PRESET_FULL_RECT)
	_layer.add_child(centre)
	_panel.theme = THEME
	_panel.add_theme_stylebox_override("panel", PANEL_STYLE)
	centre.add_child(_panel)
	var rows := VBoxContainer.new()
	rows.custom_minimum_size = Vector2(WIDTH, 0)
	rows.add_theme_constant_override("separation", 24)
	_panel.add_child(rows)
	_text.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	_text.add_theme_font_size_override("font_size", 26)
	_scale.alignment = BoxContainer.ALIGNMENT_CENTER
	_chosen.horizontal_alignment = HORIZONTAL_ALIGNMENT_CENTER
	var actions := HBoxContainer.new()
	_scale.add_theme_constant_override("separation", 10)
	actions.add_theme_constant_override("separation", 10)
	actions.alignment = BoxContainer.ALIGNMENT_CENTER
	_confirm.text = "Confirm (Enter)"
	_confirm.focus_mode = Control.FOCUS_NONE
	_confirm.pressed.connect(confirm)
	_skip.text = "Skip (S)"
	_skip.focus_mode = Control.FOCUS_NONE
	_skip.pressed.connect(skip_item)
	for row: Control in [_text, _scale, _chosen, actions]:
		rows.add_child(row)
	actions.add_child(_confirm)
	actions.add_child(_skip)


func ask(asked: Questionnaire, items: PackedStringArray, _trial: Dictionary) -> void:
	_asked = asked
	_items = items.duplicate()
	_show_item()


func close() -> void:
	_items.clear()
	_layer.visible = false


## An answer that is not confirmed yet.
func choose(value: int) -> void:
	if _items.is_empty() or value < _asked.minimum or value > _asked.maximum:
		return
	if _value != null and _value != value:
		_changes += 1
	_value = value
	_confirm.disabled = false
	_chosen.text = str(value)
	for i in _buttons.size():
		_buttons[i].set_pressed_no_signal(_asked.minimum + i * _asked.step == value)
	if _slider != null:
		_slider.set_value_no_signal(value)


func confirm() -> void:
	if _items.is_empty() or _value == null:
		return
	var item := _items[0]
	var value: int = _value
	var changes := _changes
	_go_on()
	answered.emit(item, value, changes)


func skip_item() -> void:
	if _items.is_empty():
		return
	var item := _items[0]
	_go_on()
	skipped.emit(item)


func _unhandled_key_input(event: InputEvent) -> void:
	var key := event as InputEventKey
	if not _layer.visible or not key.pressed:
		return
	if key.keycode == KEY_ENTER or key.keycode == KEY_KP_ENTER:
		confirm()
	elif key.keycode == KEY_S:
		skip_item()
	elif key.keycode == KEY_LEFT or key.keycode == KEY_RIGHT:
		var step := _asked.step if key.keycode == KEY_RIGHT else -_asked.step
		var from: int = _middle() if _value == null else _value
		choose(clampi(from + step, _asked.minimum, _asked.maximum))
	elif key.keycode >= KEY_0 and key.keycode <= KEY_9 and not _buttons.is_empty():
		choose(key.keycode - KEY_0)
	else:
		return
	get_viewport().set_input_as_handled()


func _go_on() -> void:
	_items.remove_at(0)
	_show_item()


func _show_item() -> void:
	_layer.visible = not _items.is_empty()
	_value = null
	_changes = 0
	_confirm.disabled = true
	_chosen.text = " "
	if _items.is_empty():
		return
	_text.text = _asked.texts[_asked.items.find(_items[0])]
	for child in _scale.get_children():
		child.queue_free()
	_buttons.clear()
	_slider = null
	_add_label(_asked.minimum_label)
	if (_asked.maximum - _asked.minimum) / _asked.step < MOST_BUTTONS:
		_add_buttons()
	else:
		_add_slider()
	_add_label(_asked.maximum_label)


func _add_label(text: String) -> void:
	var label := Label.new()
	label.text = text
	_scale.add_child(label)


func _add_buttons() -> void:
	for value in range(_asked.minimum, _asked.maximum + 1, _asked.step):
		var button := Button.new()
		button.text = str(value)
		button.toggle_mode = true
		button.focus_mode = Control.FOCUS_NONE
		button.custom_minimum_size = Vector2(56, 56)
		button.pressed.connect(choose.bind(value))
		_scale.add_child(button)
		_buttons.append(button)


## It starts in the middle, but an answer is chosen only once it has been moved.
func _add_slider() -> void:
	_slider = HSlider.new()
	_slider.min_value = _asked.minimum
	_slider.max_value = _asked.maximum
	_slider.step = _asked.step
	_slider.focus_mode = Control.FOCUS_NONE
	_slider.custom_minimum_size = Vector2(420, 32)
	_slider.set_value_no_signal(_middle())
	_slider.value_changed.connect(func(value: float) -> void: choose(roundi(value)))
	_scale.add_child(_slider)


func _middle() -> int:
	var steps := (_asked.maximum - _asked.minimum) / _asked.step
	return _asked.minimum + steps / 2 * _asked.step
