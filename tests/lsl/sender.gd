extends SceneTree
## Sends frame after frame, and an event with each, until it is killed or SENT_S have passed.

const SENT_S := 30.0

var _tracker := HandTracker.new()
var _outlet := LslOutlet.new()
var _next := 0


func _initialize() -> void:
	Engine.max_fps = 100
	_tracker.update_mode = HandTracker.UPDATE_MANUAL
	_tracker.source = ScriptSource.new()
	_outlet.tracker = _tracker
	root.add_child(_tracker)
	root.add_child(_outlet)
	_tracker.start()


func _process(_delta: float) -> bool:
	var joints := {HandTracker.JOINT_INDEX: Vector3(0.001 * _next, 0.5, -0.25)}
	_tracker.push_frame(0.01 * _next, joints, 0.75)
	_outlet.push_event("höher %d" % _next)
	_next += 1
	return _next > SENT_S / 0.01
