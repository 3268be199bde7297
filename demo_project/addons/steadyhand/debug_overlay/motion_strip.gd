extends Control
## The measured and the output motion, over the last seconds.

const SHOWN_S := 4.0
const MEASURED := Color(1.0, 0.75, 0.3)
const OUTPUT := Color(0.34, 0.71, 0.91)
const FAINT := Color(0.5, 0.5, 0.5, 0.5)
const FONT_SIZE := 12
## m
const LEAST_SPAN := 0.02

var _times := PackedFloat64Array()
var _measured := PackedFloat64Array()
var _output := PackedFloat64Array()


## Called once a frame.
func note(hmm: GestureHMM) -> void:
	var time_s := hmm.time
	if not _times.is_empty() and time_s < _times[-1]:
		_times.clear()
		_measured.clear()
		_output.clear()
	if _times.is_empty() or time_s > _times[-1]:
		_times.append(time_s)
		_measured.append(hmm.get_motion_value(GestureHMM.MOTION_MEASURED))
		_output.append(hmm.value)
	if _times.size() > 1 and _times[-1] - _times[0] > 2.0 * SHOWN_S:
		var from := _times.bsearch(_times[-1] - SHOWN_S)
		_times = _times.slice(from)
		_measured = _measured.slice(from)
		_output = _output.slice(from)
	queue_redraw()


func _draw() -> void:
	draw_rect(Rect2(Vector2.ZERO, size), FAINT, false)
	var font := get_theme_default_font()
	for i in 2:
		var at := Vector2(6.0 + 80.0 * i, FONT_SIZE + 2.0)
		var text: String = ["measured", "output"][i]
		draw_string(font, at, text, 0, -1, FONT_SIZE, [MEASURED, OUTPUT][i])
	if _times.size() < 2:
		return
	var first := maxi(_times.bsearch(_times[-1] - SHOWN_S) - 1, 0)
	var low := INF
	var high := -INF
	for i in range(first, _times.size()):
		low = minf(low, minf(_measured[i], _output[i]))
		high = maxf(high, maxf(_measured[i], _output[i]))
	var middle := 0.5 * (low + high)
	var span := maxf(1.2 * (high - low), LEAST_SPAN)
	for curve: PackedFloat64Array in [_measured, _output]:
		var points := PackedVector2Array()
		for i in range(first, _times.size()):
			var x := size.x * (1.0 - (_times[-1] - _times[i]) / SHOWN_S)
			points.append(Vector2(maxf(x, 0.0), size.y * (0.5 - (curve[i] - middle) / span)))
		var is_output := curve == _output
		draw_polyline(points, OUTPUT if is_output else MEASURED, 2.0 if is_output else 1.0, true)
