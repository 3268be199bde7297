extends RefCounted
## A command line tool of the demo project, run in its own headless Godot: $GODOT, because a script
## may start the engine.

var exit_code := -1
## Standard output and error.
var output := ""


## tool: name of a script in res://tools, without extension.
func _init(tool: String, arguments: PackedStringArray) -> void:
	var command := PackedStringArray(
		["--headless", "--path", ProjectSettings.globalize_path("res://")]
	)
	command.append_array(["--script", "res://tools/%s.gd" % tool, "--"])
	command.append_array(arguments)
	var lines := []
	var godot := OS.get_environment("GODOT")
	if godot.is_empty():
		godot = OS.get_executable_path()
	exit_code = OS.execute(godot, command, lines, true)
	output = "\n".join(lines)


## Empty if one line contains all of `texts`; otherwise a message with the output.
func missing(texts: PackedStringArray) -> String:
	for line in output.split("\n"):
		if Array(texts).all(func(text: String) -> bool: return line.contains(text)):
			return ""
	return "'%s' is not in: %s" % ["' and '".join(texts), output]
