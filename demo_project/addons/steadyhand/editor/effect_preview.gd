@tool
extends Control
## Waveform and spectrum of a HapticEffect, for a movement of 20 cm in 0.8 s. A short waveform is
## enlarged. Each curve is scaled to its peak, and a text gives the peak.

const RATE_HZ := 8000
const SILENT := 1e-3
## Margin around the vibration, as a share of its length.
const AROUND := 0.2
const HEIGHT := 170.0
const WAVEFORM_SHARE := 0.58
const SPECTRUM_POINTS := 300
const LEAST_RANGE_HZ := 600.0
const LINE := Color(0.34, 0.71, 0.91)
const FAINT := Color(0.5, 0.5, 0.5, 0.5)
const FONT_SIZE := 11
const MARGIN := 4.0

var effect: HapticEffect:
	set = set_effect

var _samples := PackedFloat32Array()
var _frequencies := PackedFloat32Array()
var _spectrum := PackedFloat32Array()


func _init() -> void:
	custom_minimum_size = Vector2(0, HEIGHT)
	clip_contents = true


func set_effect(value: HapticEffect) -> void:
	if effect != null:
		effect.changed.disconnect(_update)
	effect = value
	if effect != null:
		effect.changed.connect(_update)
	_update()


func _update() -> void:
	_samples.clear()
	_spectrum.clear()
	if effect != null:
		_samples = effect.get_preview(RATE_HZ)
		var range_hz := clampf(2.0 * effect.frequency, LEAST_RANGE_HZ, 0.5 * RATE_HZ)
		_frequencies.resize(SPECTRUM_POINTS)
		for i in SPECTRUM_POINTS:
			_frequencies[i] = range_hz * (i + 0.5) / SPECTRUM_POINTS
		_spectrum = effect.get_preview_spectrum(_frequencies)
	queue_redraw()


func _draw() -> void:
	if _samples.is_empty() or size.x < 2.0:
		return
	var text_height := FONT_SIZE + MARGIN
	var upper := Rect2(0.0, 0.0, size.x, size.y * WAVEFORM_SHARE - text_height)
	_draw_waveform(upper)
	var lower_top := upper.end.y + text_height + MARGIN
	_draw_spectrum(Rect2(0.0, lower_top, size.x, size.y - lower_top - text_height))


func _draw_waveform(area: Rect2) -> void:
	var shown := _shown_span()
	var peak := 0.0
	for sample in _samples:
		peak = maxf(peak, absf(sample))
	var middle := area.get_center().y
	var scale_y := 0.5 * area.size.y / maxf(peak, SILENT)
	draw_line(Vector2(0, middle), Vector2(area.end.x, middle), FAINT)
	# If the carrier is too fine to be drawn, the outline: each column has a whole period or more.
	var per_column := (shown.y - shown.x) / area.size.x
	var period := RATE_HZ / effect.frequency
	var half := int(0.5 * (maxf(per_column, period) if 4.0 * per_column > period else per_column))
	for x in int(area.size.x):
		var centre := int(shown.x + (x + 0.5) * per_column)
		var lowest := 0.0
		var highest := 0.0
		for i in range(maxi(centre - half, 0), mini(centre + half + 1, _samples.size())):
			lowest = minf(lowest, _samples[i])
			highest = maxf(highest, _samples[i])
		var top := Vector2(x + 0.5, middle - scale_y * highest - 0.5)
		draw_line(top, Vector2(top.x, middle - scale_y * lowest + 0.5), LINE)
	_write(Vector2(0, area.end.y), "%.2f s" % (float(shown.x) / RATE_HZ))
	_write(Vector2(area.get_center().x, area.end.y), "%.0f %% of full scale" % (100.0 * peak))
	_write(Vector2(area.end.x, area.end.y), "%.2f s" % (float(shown.y) / RATE_HZ))


## Numbers of the first and the last sample that are shown.
func _shown_span() -> Vector2i:
	var first := _samples.size()
	var last := 0
	for i in _samples.size():
		if absf(_samples[i]) > SILENT:
			first = mini(first, i)
			last = i
	if first > last:
		return Vector2i(0, _samples.size())
	var around := int(AROUND * (last - first))
	return Vector2i(maxi(first - around, 0), mini(last + around, _samples.size()))


func _draw_spectrum(area: Rect2) -> void:
	var highest := 0
	for i in _spectrum.size():
		if _spectrum[i] > _spectrum[highest]:
			highest = i
	if _spectrum[highest] <= 0.0:
		return
	var line := PackedVector2Array()
	for i in _spectrum.size():
		var x := area.size.x * (i + 0.5) / _spectrum.size()
		line.append(Vector2(x, area.end.y - area.size.y * _spectrum[i] / _spectrum[highest]))
	draw_line(Vector2(0, area.end.y), area.end, FAINT)
	draw_polyline(line, LINE, 1.0, true)
	_write(Vector2(0, area.end.y), "0 Hz")
	var setting_x := area.size.x * effect.frequency / (_frequencies[-1] + 0.5 * _frequencies[0])
	_write(Vector2(setting_x, area.end.y), "%.0f Hz" % effect.frequency)
	_write(area.end, "%.2f %% of full scale" % (100.0 * _spectrum[highest]))


## Below `place`; not beyond the right edge.
func _write(place: Vector2, text: String) -> void:
	var font := get_theme_default_font()
	var width := font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, FONT_SIZE).x
	var left := minf(place.x + MARGIN, size.x - width - MARGIN)
	var baseline := Vector2(left, place.y + FONT_SIZE)
	var colour := get_theme_color(&"font_color", &"Label")
	draw_string(font, baseline, text, HORIZONTAL_ALIGNMENT_LEFT, -1, FONT_SIZE, colour)
