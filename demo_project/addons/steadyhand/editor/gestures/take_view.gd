@tool
extends Control
## The curve of a take, whose ends are dragged; or the hand while it is recorded.

## The user has dragged an end of the movement.
signal trim_changed(start_s: float, end_s: float)

const PlotArea := preload("plot_area.gd")
const TrackCurves := preload("track_curves.gd")

const HEIGHT := 120.0
## Pixels, before the editor's scale.
const GRIP_WIDTH := 8.0
const SHADE_OPACITY := 0.1
const AROUND := 0.08
const SHORTEST_S := 0.05
## Length of the live curve, s.
const SHOWN_S := 8.0

var message := ""

var _curve := PackedFloat64Array()
var _start_s := 0.0
## Start and end of the movement, s, on the track's clock.
var _trim := PackedFloat64Array([0.0, 0.0])
var _trace_times := PackedFloat64Array()
var _trace_points := PackedVector3Array()
## -1: no end is dragged; 0 the start, 1 the end.
var _dragged := -1
var _plot: PlotArea = null


func _init() -> void:
	custom_minimum_size = Vector2(0.0, HEIGHT * EditorInterface.get_editor_scale())
	clip_contents = true


## `curve`: m at TrackCurves.RATE_HZ from `start_s` on. `trim`: start and end of the movement, s.
func show_take(curve: PackedFloat64Array, start_s: float, trim: PackedFloat64Array) -> void:
	_curve = curve
	_start_s = start_s
	_trim = trim
	_trace_times = PackedFloat64Array()
	queue_redraw()


func show_trace(times: PackedFloat64Array, points: PackedVector3Array) -> void:
	_trace_times = times
	_trace_points = points
	_curve = PackedFloat64Array()
	queue_redraw()


func show_message(text: String) -> void:
	message = text
	show_take(PackedFloat64Array(), 0.0, [0.0, 0.0])


## Where the edge of the movement is drawn, pixels. 0: its start, 1: its end.
func get_edge(side: int) -> float:
	return _plot.place(_trim[side] - _start_s, 0.0).x


func _draw() -> void:
	_plot = PlotArea.new(self)
	if not _trace_times.is_empty():
		_draw_trace()
	elif _curve.is_empty():
		_plot.write(0.5 * size, message, 0.5, 0.5)
	else:
		_draw_take()


func _draw_take() -> void:
	var plot := _plot
	var values := Array(_curve)
	var least: float = 100.0 * values.min()
	var most: float = 100.0 * values.max()
	var around := maxf(AROUND * (most - least), 0.1)
	plot.low = Vector2(0.0, least - around)
	plot.high = Vector2((_curve.size() - 1) / TrackCurves.RATE_HZ, most + around)
	plot.draw_grid(" s", " cm")
	var points := PackedVector2Array()
	for i in _curve.size():
		points.append(plot.place(i / TrackCurves.RATE_HZ, 100.0 * _curve[i]))
	var text_colour := get_theme_color(&"font_color", &"Label")
	plot.draw_curve(points, Color(text_colour, 0.35), 1.5)
	var first := clampi(_point_of(_trim[0]), 0, points.size() - 1)
	var last := clampi(_point_of(_trim[1]), first, points.size() - 1)
	var left := points[first].x
	var right := points[last].x
	var shown := Rect2(left, plot.rect.position.y, right - left, plot.rect.size.y)
	draw_rect(shown, Color(plot.accent(), SHADE_OPACITY))
	plot.draw_curve(points.slice(first, last + 1), plot.accent(), 2.5)
	var scale_factor := EditorInterface.get_editor_scale()
	for x: float in [left, right]:
		var top := Vector2(x, plot.rect.position.y)
		draw_line(top, Vector2(x, plot.rect.end.y), plot.accent(), 2.0 * scale_factor)
		var grip := Vector2(GRIP_WIDTH, 2.0 * GRIP_WIDTH) * scale_factor
		var middle := Vector2(x, plot.rect.get_center().y)
		draw_rect(Rect2(middle - 0.5 * grip, grip), plot.accent())


func _draw_trace() -> void:
	var plot := _plot
	var box := AABB()
	var has_box := false
	for point in _trace_points:
		if point.is_finite():
			box = box.expand(point) if has_box else AABB(point, Vector3.ZERO)
			has_box = true
	var last := _trace_times[-1]
	var span := maxf(100.0 * box.get_longest_axis_size(), 5.0)
	plot.low = Vector2(-SHOWN_S, -0.6 * span)
	plot.high = Vector2(0.0, 0.6 * span)
	plot.draw_grid(" s", " cm")
	for axis in 3:
		var line := PackedVector2Array()
		for i in _trace_times.size():
			var ago := _trace_times[i] - last
			if ago < -SHOWN_S:
				continue
			if not _trace_points[i].is_finite():
				plot.draw_curve(line, plot.hue(axis / 3.0), 1.5)
				line = PackedVector2Array()
				continue
			var value := 100.0 * (_trace_points[i] - box.get_center())[axis]
			line.append(plot.place(ago, value))
		plot.draw_curve(line, plot.hue(axis / 3.0), 1.5)
		var at := plot.rect.position + Vector2(6.0 + 1.5 * plot.text_height() * axis, 2.0)
		plot.write(at, ["x", "y", "z"][axis], 0.0, 0.0, plot.hue(axis / 3.0))


func _gui_input(event: InputEvent) -> void:
	if _curve.is_empty() or _plot == null:
		return
	var click := event as InputEventMouseButton
	if click != null and click.button_index == MOUSE_BUTTON_LEFT:
		if click.pressed:
			_dragged = _grip_at(click.position.x)
		elif _dragged >= 0:
			_dragged = -1
			trim_changed.emit(_trim[0], _trim[1])
		accept_event()
	var motion := event as InputEventMouseMotion
	if motion == null:
		return
	var is_over := _dragged >= 0 or _grip_at(motion.position.x) >= 0
	mouse_default_cursor_shape = CURSOR_HSIZE if is_over else CURSOR_ARROW
	if _dragged < 0:
		return
	var time_s := _start_s + _plot.value_at(motion.position.x)
	var end_s := _start_s + (_curve.size() - 1) / TrackCurves.RATE_HZ
	if _dragged == 0:
		_trim[0] = clampf(time_s, _start_s, _trim[1] - SHORTEST_S)
	else:
		_trim[1] = clampf(time_s, _trim[0] + SHORTEST_S, end_s)
	queue_redraw()


func _grip_at(x: float) -> int:
	var reach := GRIP_WIDTH * EditorInterface.get_editor_scale()
	for side in 2:
		if absf(get_edge(side) - x) <= reach:
			return side
	return -1


func _point_of(time_s: float) -> int:
	return roundi((time_s - _start_s) * TrackCurves.RATE_HZ)
