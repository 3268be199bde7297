extends RefCounted
## A command line tool of the demo project in a headless Godot of its own: $GODOT, as what starts
## the engine may be a script that its path does not tell of.

var exit_code := -1
## Standard output and error.
var said := ""


## `tool`: of res://tools, without its ending.
func _init(tool: String, arguments: PackedStringArray) -> void:
	var command := PackedStringArray(
		["--headless", "--path", ProjectSettings.globalize_path("res://")]
	)
	command.append_array(["--script", "res://tools/%s.gd" % tool, "--"])
	command.append_array(arguments)
	var output := []
	var godot := OS.get_environment("GODOT")
	if godot.is_empty():
		godot = OS.get_executable_path()
	exit_code = OS.execute(godot, command, output, true)
	said = "\n".join(output)


## Empty where one line holds all of `texts`; else what was said.
func not_said(texts: PackedStringArray) -> String:
	for line in said.split("\n"):
		if Array(texts).all(func(text: String) -> bool: return line.contains(text)):
			return ""
	return "'%s' is not in: %s" % ["' and '".join(texts), said]
