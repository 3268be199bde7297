extends CanvasLayer
## Guides a user through the alignment of two trackers and shows the result. Add
## alignment_panel.tscn to a scene, set `alignment`, and press the button or call begin().

@export var alignment: TrackerAlignment
## How long both trackers must see the hand.
@export_range(5.0, 120.0, 1.0, "suffix:s") var seconds := 10.0
## Whether a result sets the device_transform of the tracker's source.
@export var applies := true

var _text := "Press Align, then move the hand in all directions."

@onready var _label: Label = $Panel/Rows/Label
@onready var _progress: ProgressBar = $Panel/Rows/Progress


func _ready() -> void:
	($Panel/Rows/Align as Button).pressed.connect(begin)


func _process(_delta: float) -> void:
	if alignment != null and alignment.is_running():
		_progress.value = alignment.duration / seconds
		if alignment.duration >= seconds:
			_finish()
	_label.text = _text


func begin() -> void:
	_progress.value = 0.0
	if alignment == null:
		_text = 'Set "alignment" of the panel to a TrackerAlignment.'
	elif alignment.start() == OK:
		_text = "Move the hand in all directions for %.0f s, faster and slower." % seconds
	else:
		_text = alignment.error_message


func describe() -> String:
	return _text


func _finish() -> void:
	alignment.stop()
	if alignment.solve() != OK:
		_text = "Not aligned: %s." % alignment.error_message
		return
	_text = (
		"lag %.1f ms, residual %.1f mm (at most %.1f mm), %d samples"
		% [
			1e3 * alignment.lag,
			1e3 * alignment.residual,
			1e3 * alignment.residual_max,
			alignment.sample_count
		]
	)
	if applies:
		var is_applied := alignment.apply() == OK
		_text += "\napplied" if is_applied else "\nnot applied: %s" % alignment.error_message
