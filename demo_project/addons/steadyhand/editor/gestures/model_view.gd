@tool
extends Control
## Draws a model as the paper's Fig. 3: the takes, and over them the reference curve with its states
## and spread.

const PlotArea := preload("plot_area.gd")

const WIDTH := 220.0
const HEIGHT := 120.0
const SPREAD_OPACITY := 0.25
const ELEMENT_POINTS := 24
## Lines of text above the curve.
const HEADING := 2.2

var message := "Train a model to see its curve"

var _model: GestureModel = null
var _recordings: Array[Dictionary] = []


func _init() -> void:
	custom_minimum_size = Vector2(WIDTH, HEIGHT) * EditorInterface.get_editor_scale()
	clip_contents = true


## `recordings`: of GestureTrainer.get_recordings(), may be empty.
func show_model(model: GestureModel, recordings: Array[Dictionary]) -> void:
	_model = model
	_recordings = recordings
	queue_redraw()


func _draw() -> void:
	var plot := PlotArea.new(self)
	if _model == null:
		plot.write(0.5 * size, message, 0.5, 0.5)
		return
	plot = PlotArea.new(self, HEADING * plot.text_height() / EditorInterface.get_editor_scale())
	plot.low = Vector2(0.0, -0.1)
	plot.high = Vector2(1.0, 1.1)
	plot.draw_grid("", "")
	_draw_recordings(plot)
	_draw_spread(plot)
	for state in _model.state_count:
		_draw_state(plot, state)
	_draw_legend(plot)


func _draw_recordings(plot: PlotArea) -> void:
	var text_colour := get_theme_color(&"font_color", &"Label")
	var error_colour := get_theme_color(&"error_color", &"Editor")
	for recording in _recordings:
		var curve: PackedFloat64Array = recording["curve"]
		var points := PackedVector2Array()
		for i in curve.size():
			var y := clampf(curve[i], plot.low.y, plot.high.y)
			points.append(plot.place(float(i) / (curve.size() - 1), y))
		var colour := Color(text_colour, 0.3) if recording["kept"] else Color(error_colour, 0.7)
		plot.draw_curve(points, colour, 1.0)


func _draw_spread(plot: PlotArea) -> void:
	var mean := _model.get_reference_mean()
	var deviation := _model.get_reference_deviation()
	var upper := PackedVector2Array()
	var lower := PackedVector2Array()
	for i in mean.size():
		var x := float(i) / (mean.size() - 1)
		upper.append(plot.place(x, minf(mean[i] + deviation[i], plot.high.y)))
		lower.append(plot.place(x, maxf(mean[i] - deviation[i], plot.low.y)))
	var colour := Color(plot.accent(), SPREAD_OPACITY)
	# Quads: a polygon that crosses itself is not drawn.
	for i in mean.size() - 1:
		var corners := [upper[i], upper[i + 1], lower[i + 1], lower[i]]
		if upper[i].distance_to(lower[i]) > 0.5 and upper[i + 1].distance_to(lower[i + 1]) > 0.5:
			draw_colored_polygon(PackedVector2Array(corners), colour)


func _draw_state(plot: PlotArea, state: int) -> void:
	var element := _model.get_element(state)
	var begin: float = element["phase_begin"]
	var end: float = element["phase_end"]
	var points := PackedVector2Array()
	for i in ELEMENT_POINTS + 1:
		var phase := lerpf(begin, end, float(i) / ELEMENT_POINTS)
		points.append(plot.place(phase, _model.evaluate(phase)))
	var colour := plot.state_colour(state)
	if state > 0:
		var foot := plot.place(begin, plot.low.y)
		draw_dashed_line(foot, plot.place(begin, plot.high.y), Color(colour, 0.6))
	plot.draw_curve(points, colour, 3.0)
	var at := plot.place(0.5 * (begin + end), plot.high.y)
	var duration := (
		"%.0f ± %.0f ms" % [1e3 * element["duration_mean"], 1e3 * element["duration_deviation"]]
	)
	var has_room := plot.text_width(duration) < plot.rect.size.x * (end - begin)
	plot.write(at - Vector2(0.0, plot.text_height()), "state %d" % state, 0.5, 1.0, colour)
	if has_room:
		plot.write(at, duration, 0.5, 1.0, colour)


func _draw_legend(plot: PlotArea) -> void:
	var kept := 0
	for recording in _recordings:
		kept += int(recording["kept"])
	var lines := PackedStringArray(["%s, %.2f s" % [_model.gesture, _model.duration_mean]])
	if not _recordings.is_empty():
		lines.append("%d of %d takes used" % [kept, _recordings.size()])
	for i in lines.size():
		var above := (lines.size() - i) * plot.text_height()
		plot.write(plot.rect.end - Vector2(6.0, above + 4.0), lines[i], 1.0, 0.0)
