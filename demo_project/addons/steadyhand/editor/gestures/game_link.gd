@tool
extends EditorDebuggerPlugin
## Frames of a game that runs from this editor and shows the debug overlay. The game may run on
## another device, such as a headset.

signal game_started(tracker_name: String)
signal game_ended
signal frame_received(time_s: float, joints: Dictionary, confidence: float)

const EditorLink := preload("../../debug_overlay/editor_link.gd")

## -1: no game has sent its tracker.
var _session := -1


func _has_capture(capture: String) -> bool:
	return capture == EditorLink.CAPTURE


func _capture(message: String, data: Array, session_id: int) -> bool:
	match message:
		EditorLink.TRACKER:
			_session = session_id
			game_started.emit(data[0])
		EditorLink.FRAME:
			frame_received.emit(data[0], data[1], data[2])
		_:
			return false
	return true


func _setup_session(session_id: int) -> void:
	get_session(session_id).stopped.connect(_on_stopped.bind(session_id))


func record(is_on: bool) -> void:
	if _session >= 0:
		get_session(_session).send_message("%s:record" % EditorLink.CAPTURE, [is_on])


func _on_stopped(session_id: int) -> void:
	if session_id == _session:
		_session = -1
		game_ended.emit()
