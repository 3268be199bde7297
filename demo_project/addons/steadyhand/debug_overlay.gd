extends CanvasLayer
## Shows in a running game the state of a HandTracker, the gesture of a GestureHMM, and why no
## gesture starts. In the scene it shows the measured fingertip and the output motion. Add
## debug_overlay.tscn to a scene. It shows `gesture_hmm`, or `tracker` alone. Without either, it
## takes the first GestureHMM of the tree.

const EditorLink := preload("debug_overlay/editor_link.gd")
const IdleReason := preload("debug_overlay/idle_reason.gd")
const MotionStrip := preload("debug_overlay/motion_strip.gd")
const ScenePoints := preload("debug_overlay/scene_points.gd")

@export var gesture_hmm: GestureHMM:
	set(value):
		gesture_hmm = value
		_follow()
## The tracker of `gesture_hmm` if that is set.
@export var tracker: HandTracker:
	set(value):
		tracker = value
		_follow()

## The tree has changed since the last search for a GestureHMM, which is slow in a large tree.
var _is_search_due := true
var _followed: HandTracker = null
var _reason := IdleReason.new()

@onready var _tracker_label: Label = $Panel/Rows/Tracker
@onready var _gesture_label: Label = $Panel/Rows/Gesture
@onready var _progress: ProgressBar = $Panel/Rows/Progress
@onready var _strip: MotionStrip = $Panel/Rows/Strip
@onready var _points: ScenePoints = $Points
@onready var _link: EditorLink = $EditorLink


func _ready() -> void:
	_link.follow(_followed)
	get_tree().tree_changed.connect(func() -> void: _is_search_due = true)


func _process(delta: float) -> void:
	_choose()
	_follow()
	_reason.pass_time(delta)
	_tracker_label.text = describe_tracker()
	_gesture_label.text = describe_gesture()
	var has_gesture := is_instance_valid(gesture_hmm)
	_gesture_label.visible = has_gesture
	_progress.visible = has_gesture
	_strip.visible = has_gesture
	_points.visible = has_gesture
	if has_gesture:
		_progress.value = gesture_hmm.progress if not gesture_hmm.gesture.is_empty() else 0.0
		_strip.note(gesture_hmm)
		_points.show_motion(gesture_hmm)


## Source, state, rate, noise and faults of the tracker, in three lines.
func describe_tracker() -> String:
	_follow()
	if not is_instance_valid(_followed):
		return "no tracker"
	var source := "no source" if _followed.source == null else _followed.source.get_class()
	var state := "not running"
	if not _reason.failure.is_empty():
		state = _reason.failure
	elif _followed.is_running():
		state = "hand tracked" if _followed.is_hand_tracked() else "no hand"
	var latency := "latency unknown"
	if is_finite(_followed.latency):
		latency = "latency %.0f ms" % (1e3 * _followed.latency)
	var noise := "noise unknown"
	if is_finite(_followed.noise):
		noise = "noise %.2f mm" % (1e3 * _followed.noise)
	return (
		"%s: %s\n%.1f Hz, jitter %.2f ms, %s, %s\n%d dropouts, %d freezes, %d jumps"
		% [
			source,
			state,
			_followed.frame_rate,
			1e3 * _followed.frame_jitter,
			latency,
			noise,
			_followed.dropout_count,
			_followed.freeze_count,
			_followed.jump_count
		]
	)


## The active gesture, or why none starts.
func describe_gesture() -> String:
	_follow()
	if not is_instance_valid(gesture_hmm):
		return ""
	if gesture_hmm.gesture.is_empty():
		return _reason.of(gesture_hmm)
	return (
		"%s: %.0f %%, %.1f cm\nconfidence %.2f, state %d"
		% [
			gesture_hmm.gesture,
			100.0 * gesture_hmm.progress,
			100.0 * gesture_hmm.value,
			gesture_hmm.confidence,
			gesture_hmm.state
		]
	)


func _choose() -> void:
	if _is_search_due and not is_instance_valid(gesture_hmm) and not is_instance_valid(tracker):
		_is_search_due = false
		var found := get_tree().root.find_children("*", "GestureHMM", true, false)
		gesture_hmm = found[0] as GestureHMM if not found.is_empty() else null


## The tracker may change at any time.
func _follow() -> void:
	var wanted := tracker
	if is_instance_valid(gesture_hmm):
		wanted = gesture_hmm.tracker
	if is_instance_valid(wanted) and wanted == _followed:
		return
	if not is_instance_valid(wanted):
		wanted = null
	if is_instance_valid(_followed):
		_reason.leave(_followed)
	_followed = wanted
	if _followed != null:
		_reason.follow(_followed)
	if is_node_ready():
		_link.follow(_followed)
