extends RefCounted
## A simulated Leap service: tests/devices/leap_stub.py as a process of its own.

var port := 0
## Position of the fingertip in the first frame, m.
var start := Vector3.ZERO

var _pid := -1
var _log := ""


## `folder`: for the messages and the log. `options`: more of leap_stub.py's.
func _init(folder: String, scenario: String, options: PackedStringArray = []) -> void:
	var tools := ProjectSettings.globalize_path("res://").path_join("../tests/devices")
	var messages := folder.path_join("drag.jsonl")
	var dialect := "bridge" if "bridge" in options else "orion"
	OS.execute(
		"python3",
		[
			tools.path_join("make_leap_messages.py"),
			"--dialect",
			dialect,
			"--rest-after",
			"4",
			"--out",
			messages
		]
	)
	_log = folder.path_join("client.log")
	var arguments := PackedStringArray([tools.path_join("leap_stub.py"), "--scenario", scenario])
	arguments.append_array(["--messages", messages, "--log", _log, "--seconds", "30"])
	arguments.append_array(options)
	var process := OS.execute_with_pipe("python3", arguments)
	_pid = process["pid"]
	port = (process["stdio"] as FileAccess).get_line().to_int()
	if port == 0:
		push_error("tests/devices/leap_stub.py did not start")
	start = _first_tip(messages)


func stop() -> void:
	OS.kill(_pid)


## Messages of the clients.
func log_text() -> String:
	return FileAccess.get_file_as_string(_log)


static func _first_tip(messages: String) -> Vector3:
	var line := FileAccess.get_file_as_string(messages).get_slice("\n", 0)
	var frame: Dictionary = JSON.parse_string(line)
	for pointable: Dictionary in frame["pointables"]:
		if pointable["type"] == 1:
			var tip: Array = pointable["tipPosition"]
			return 0.001 * Vector3(tip[0], tip[1], tip[2])
	return Vector3.ZERO
