extends CanvasLayer
## Shows how a HandTracker does: its source, whether the hand is tracked, rate, jitter, latency,
## noise and faults. Add tracker_hud.tscn to a scene and set `tracker`.

@export var tracker: HandTracker:
	set(value):
		if is_instance_valid(tracker):
			tracker.failed.disconnect(_on_failed)
			tracker.source_ready.disconnect(_on_source_ready)
		tracker = value
		_failure = ""
		if tracker != null:
			tracker.failed.connect(_on_failed)
			tracker.source_ready.connect(_on_source_ready)

var _failure := ""

@onready var _label: Label = $Panel/Label


func _process(_delta: float) -> void:
	_label.text = describe()


func describe() -> String:
	if not is_instance_valid(tracker):
		return "no tracker"
	if tracker.is_hand_tracked():
		_failure = ""
	var source := "no source" if tracker.source == null else tracker.source.get_class()
	var state := "not running"
	if not _failure.is_empty():
		state = _failure
	elif tracker.is_running():
		state = "hand tracked" if tracker.is_hand_tracked() else "no hand"
	var latency := "latency unknown"
	if is_finite(tracker.latency):
		latency = "latency %.0f ms" % (1e3 * tracker.latency)
	var noise := "noise unknown"
	if is_finite(tracker.noise):
		noise = "noise %.2f mm" % (1e3 * tracker.noise)
	return (
		"%s: %s\n%.1f Hz, jitter %.2f ms, %s, %s\n%d dropouts, %d freezes, %d jumps"
		% [
			source,
			state,
			tracker.frame_rate,
			1e3 * tracker.frame_jitter,
			latency,
			noise,
			tracker.dropout_count,
			tracker.freeze_count,
			tracker.jump_count
		]
	)


func _on_failed(reason: String) -> void:
	_failure = reason


func _on_source_ready() -> void:
	_failure = ""
