extends Node3D
## A map that grows as three fingers open. Strokes add up; one more at the largest scale shows the
## whole map again.

const LARGEST := 27.0

var zoom := 1.0

var _zoom_before := 1.0

@onready var _hmm: GestureHMM = $GestureHMM
@onready var _task: GestureTask = $GestureTask
@onready var _map: ShaderMaterial = ($Map as MeshInstance3D).material_override


func _ready() -> void:
	_hmm.gesture_started.connect(_on_gesture_started)
	_hmm.gesture_aborted.connect(func(_g: StringName, _t: GestureTask) -> void: zoom = _zoom_before)


func _process(_delta: float) -> void:
	if _hmm.gesture != &"":
		# The map between the fingertips stays there, and keeps its size while the hand closes.
		var factor := 1.0 + _hmm.value / _task.start_radius
		zoom = clampf(_zoom_before * factor, zoom, LARGEST)
	_map.set_shader_parameter(&"zoom", zoom)
	($Factor as Label3D).text = "x %.1f" % zoom


func _on_gesture_started(_gesture: StringName, _at: GestureTask) -> void:
	if zoom >= LARGEST:
		zoom = 1.0
	_zoom_before = zoom
