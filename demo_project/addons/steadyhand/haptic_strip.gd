class_name HapticStrip
extends Control
## The strength of a HapticSynth's vibration over the last seconds. The right edge is now.

const POINTS := 256
const FILL := Color(0.34, 0.71, 0.91, 0.35)
const LINE := Color(0.34, 0.71, 0.91)
const FAINT := Color(0.5, 0.5, 0.5, 0.5)

@export var synth: HapticSynth
@export_range(0.5, 30.0, 0.1, "suffix:s") var seconds := 3.0

## The maximum in each of POINTS parts of the time: a ring buffer that ends at `_newest`.
var _amplitudes := PackedFloat32Array()
var _newest := 0
var _part := 0
var _curve := PackedVector2Array()


func _init() -> void:
	_amplitudes.resize(POINTS)
	_curve.resize(POINTS)


func _process(_delta: float) -> void:
	note()


## Takes the present strength. Call it once a frame, and after each step between frames. The time is
## the motion's: a replay looks the same at any speed.
func note() -> void:
	if synth == null or synth.gesture_hmm == null:
		return
	var part := floori(synth.gesture_hmm.time / seconds * POINTS)
	if part != _part:
		_advance(part - _part if part > _part and part - _part < POINTS else POINTS)
		_part = part
	_amplitudes[_newest] = maxf(_amplitudes[_newest], synth.get_amplitude())
	queue_redraw()


## The greatest strength that is shown, 0..1.
func get_greatest() -> float:
	var greatest := 0.0
	for amplitude in _amplitudes:
		greatest = maxf(greatest, amplitude)
	return greatest


## Between two frames the last strength is repeated.
func _advance(parts: int) -> void:
	var held := _amplitudes[_newest] if parts < POINTS else 0.0
	for i in parts:
		_newest = (_newest + 1) % POINTS
		_amplitudes[_newest] = held
	_amplitudes[_newest] = 0.0


func _draw() -> void:
	for i in POINTS:
		var amplitude := _amplitudes[(_newest + 1 + i) % POINTS]
		_curve[i] = Vector2(size.x * i / (POINTS - 1), size.y * (1.0 - amplitude))
	draw_rect(Rect2(Vector2.ZERO, size), FAINT, false)
	for i in POINTS - 1:
		var left := _curve[i]
		var right := _curve[i + 1]
		if left.y < size.y or right.y < size.y:
			draw_rect(Rect2(left.x, left.y, right.x - left.x, size.y - left.y), FILL)
	draw_polyline(_curve, LINE, 1.5, true)
