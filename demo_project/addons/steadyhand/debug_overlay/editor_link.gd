extends Node
## Sends the frames of the running game to the editor's "Gestures" panel while that records.

const CAPTURE := &"steadyhand"
const TRACKER := "steadyhand:tracker"
const FRAME := "steadyhand:frame"

var _tracker: HandTracker = null
var _is_sending := false


func _enter_tree() -> void:
	if EngineDebugger.is_active():
		EngineDebugger.register_message_capture(CAPTURE, _on_message)


func _exit_tree() -> void:
	if EngineDebugger.has_capture(CAPTURE):
		EngineDebugger.unregister_message_capture(CAPTURE)


## Null: no tracker.
func follow(tracker: HandTracker) -> void:
	if is_instance_valid(_tracker):
		_tracker.frame_received.disconnect(_on_frame)
	_tracker = tracker
	if _tracker != null:
		_tracker.frame_received.connect(_on_frame)
		_send(TRACKER, [String(_tracker.name)])


func _on_message(message: String, data: Array) -> bool:
	if message == "record":
		_is_sending = data[0]
	return message == "record"


func _on_frame(frame: HandFrame) -> void:
	if _is_sending:
		_send(FRAME, [frame.time, frame.get_joints(), frame.confidence])


func _send(message: String, data: Array) -> void:
	if EngineDebugger.is_active():
		EngineDebugger.send_message(message, data)
