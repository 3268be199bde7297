@tool
extends RefCounted
## The frame of a curve that a Control draws: axes, labels and colours of the editor's theme.

const MARGIN_LEFT := 44.0
const MARGIN_RIGHT := 10.0
const MARGIN_TOP := 10.0
const MARGIN_BOTTOM := 22.0
const GRID_OPACITY := 0.12
## Share of the hue circle, so that neighbouring states differ most.
const GOLDEN := 0.618034

var rect := Rect2()
## Range of the shown values.
var low := Vector2.ZERO
var high := Vector2.ONE

var _control: Control
var _scale := 1.0
var _font: Font
var _font_size := 12
var _text_colour := Color.WHITE


func _init(control: Control, top_extra: float = 0.0) -> void:
	_control = control
	_scale = EditorInterface.get_editor_scale()
	_font = control.get_theme_font(&"font", &"Label")
	_font_size = int(0.85 * control.get_theme_font_size(&"font_size", &"Label"))
	_text_colour = control.get_theme_color(&"font_color", &"Label")
	var corner := _scale * Vector2(MARGIN_LEFT, MARGIN_TOP + top_extra)
	var far := control.size - _scale * Vector2(MARGIN_RIGHT, MARGIN_BOTTOM)
	rect = Rect2(corner, (far - corner).max(Vector2.ONE))


## Where a value is drawn.
func place(x: float, y: float) -> Vector2:
	var share := (Vector2(x, y) - low) / (high - low)
	return rect.position + rect.size * Vector2(share.x, 1.0 - share.y)


func value_at(x: float) -> float:
	return low.x + (high.x - low.x) * (x - rect.position.x) / rect.size.x


func draw_grid(x_unit: String, y_unit: String) -> void:
	var line := Color(_text_colour, GRID_OPACITY)
	var steps := Vector2(_step(high.x - low.x, rect.size.x), _step(high.y - low.y, rect.size.y))
	var x := ceilf(low.x / steps.x) * steps.x
	while x <= high.x + 1e-9:
		var foot := place(x, low.y)
		_control.draw_line(foot, place(x, high.y), line)
		write(foot + Vector2(0.0, _scale * 4.0), _number(x, steps.x) + x_unit, 0.5, 0.0)
		x += steps.x
	var y := ceilf(low.y / steps.y) * steps.y
	while y <= high.y + 1e-9:
		var left := place(low.x, y)
		_control.draw_line(left, place(high.x, y), line)
		write(left - Vector2(_scale * 4.0, 0.0), _number(y, steps.y) + y_unit, 1.0, 0.5)
		y += steps.y


## `anchor`: the share of the text that lies to the left of `at`, and above it.
func write(
	at: Vector2, text: String, anchor_x: float, anchor_y: float, colour := Color.TRANSPARENT
) -> void:
	var size := _font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, _font_size)
	var left := clampf(at.x - anchor_x * size.x, 0.0, maxf(_control.size.x - size.x, 0.0))
	var baseline := at.y - anchor_y * size.y + _font.get_ascent(_font_size)
	var shown := Color(_text_colour, 0.75) if colour.a == 0.0 else colour
	_control.draw_string(
		_font, Vector2(left, baseline), text, HORIZONTAL_ALIGNMENT_LEFT, -1, _font_size, shown
	)


func draw_curve(points: PackedVector2Array, colour: Color, width: float) -> void:
	if points.size() > 1:
		_control.draw_polyline(points, colour, width * _scale, true)


func text_width(text: String) -> float:
	return _font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, _font_size).x


func text_height() -> float:
	return _font.get_height(_font_size)


## Colour of a hidden state; readable on the theme's background.
func state_colour(state: int) -> Color:
	return hue(0.58 + GOLDEN * state)


func hue(turn: float) -> Color:
	var is_dark := _text_colour.get_luminance() > 0.5
	return Color.from_ok_hsl(fposmod(turn, 1.0), 0.75, 0.68 if is_dark else 0.48)


func accent() -> Color:
	return _control.get_theme_color(&"accent_color", &"Editor")


## 1, 2 or 5 times a power of ten, with labels some 60 pixels apart.
func _step(span: float, pixels: float) -> float:
	var wanted := span * 60.0 * _scale / maxf(pixels, 1.0)
	var power := pow(10.0, floorf(log(maxf(wanted, 1e-9)) / log(10.0)))
	for factor: float in [1.0, 2.0, 5.0]:
		if factor * power >= wanted:
			return factor * power
	return 10.0 * power


func _number(value: float, step: float) -> String:
	var decimals := clampi(ceili(-log(step) / log(10.0) - 1e-6), 0, 4)
	return ("%%.%df" % decimals) % (value if absf(value) > 1e-9 else 0.0)
