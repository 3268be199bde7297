extends "desktop_questionnaire_panel.gd"
## The questionnaire on a display in the scene. The participant touches a button with the tip of the
## index finger, or holds it in front of the button. The operator's keys work too.

const WorldPanel := preload("world_panel.gd")

const DWELL_S := 0.8
## The cursor is shown if the fingertip is this near, m.
const NEAR_M := 0.1
## A fingertip further behind the display than this does not point, m.
const BEHIND_M := 0.06
## After a touch the fingertip must come back this far before it touches again, m.
const RELEASE_M := 0.012
const TEXT_SIZE := 24
const QUESTION_SIZE := 34
const CURSOR_SIZE := 26.0
const WAITING := Color(1.0, 1.0, 1.0, 0.85)
const PRESSING := Color(1.0, 0.75, 0.1, 1.0)
## How far beside the slider a touch still counts, pixels.
const SLIDER_MARGIN := 24.0

var _display: WorldPanel = null
var _cursor := Panel.new()
var _over: Control = null
var _over_since_s := 0.0
var _is_armed := false
## After a dwell the fingertip must leave the control before the next press.
var _is_dwell_used := false


## `display`: where the panel is shown. `tracker`: of the participant's hand.
func _init(display: WorldPanel, tracker: HandTracker) -> void:
	_display = display
	tracker.frame_received.connect(_on_frame)
	tracker.tracking_lost.connect(_hide_cursor)


func _ready() -> void:
	super()
	_panel.theme = THEME.duplicate()
	_panel.theme.default_font_size = TEXT_SIZE
	_text.add_theme_font_size_override("font_size", QUESTION_SIZE)
	_confirm.text = "Confirm"
	_skip.text = "Skip"
	for button: Button in [_confirm, _skip]:
		button.custom_minimum_size = Vector2(180, 72)
	var style := StyleBoxFlat.new()
	style.bg_color = Color.WHITE
	style.set_corner_radius_all(int(0.5 * CURSOR_SIZE))
	style.set_border_width_all(3)
	style.border_color = Color.BLACK
	_cursor.add_theme_stylebox_override("panel", style)
	_cursor.size = Vector2.ONE * CURSOR_SIZE
	_cursor.mouse_filter = Control.MOUSE_FILTER_IGNORE
	_layer.add_child(_cursor)
	_hide_cursor()


func _add_buttons() -> void:
	super()
	for button in _buttons:
		button.custom_minimum_size = Vector2(76, 76)


func _on_frame(frame: HandFrame) -> void:
	var joints := frame.get_joints()
	if not _layer.visible or not joints.has(HandTracker.JOINT_INDEX):
		_hide_cursor()
		return
	var place := _display.to_display(joints[HandTracker.JOINT_INDEX])
	var pixel := Vector2(place.x, place.y)
	var is_inside := Rect2(Vector2.ZERO, WorldPanel.SIZE).has_point(pixel)
	if not is_inside or place.z > NEAR_M or place.z < -BEHIND_M:
		_hide_cursor()
		return
	_cursor.visible = true
	_cursor.position = pixel - 0.5 * _cursor.size
	_point(frame.time, pixel, place.z)


func _point(time_s: float, pixel: Vector2, distance_m: float) -> void:
	var over := _control_at(pixel)
	if over != _over:
		_over = over
		_over_since_s = time_s
		_is_dwell_used = false
	var dwell := (time_s - _over_since_s) / DWELL_S
	if over == null or _is_dwell_used:
		dwell = 0.0
	_cursor.modulate = WAITING.lerp(PRESSING, clampf(dwell, 0.0, 1.0))
	var is_touching := _is_armed and distance_m <= 0.0
	if distance_m > RELEASE_M:
		_is_armed = true
	elif distance_m <= 0.0:
		_is_armed = false
	if over != null and (is_touching or dwell >= 1.0):
		_is_dwell_used = true
		_press(over, pixel)


func _press(over: Control, pixel: Vector2) -> void:
	if over is Button:
		(over as Button).pressed.emit()
		return
	var rect := over.get_global_rect()
	var share := clampf((pixel.x - rect.position.x) / rect.size.x, 0.0, 1.0)
	var steps := (_asked.maximum - _asked.minimum) / _asked.step
	choose(_asked.minimum + _asked.step * roundi(share * steps))


## A button that can be pressed, or the slider. Null: neither.
func _control_at(pixel: Vector2) -> Control:
	var controls: Array[Control] = [_confirm, _skip]
	controls.append_array(_buttons)
	for control in controls:
		if not (control as Button).disabled and control.get_global_rect().has_point(pixel):
			return control
	if _slider != null and _slider.get_global_rect().grow(SLIDER_MARGIN).has_point(pixel):
		return _slider
	return null


func _hide_cursor() -> void:
	_cursor.visible = false
	_over = null
	_is_armed = false
