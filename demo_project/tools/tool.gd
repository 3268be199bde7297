extends SceneTree
## A command line tool. It does its work in the first frame, because the root is in no tree before,
## and ends the process with `exit_code`. A script error leaves EXIT_INCOMPLETE.

const CommandLine := preload("command_line.gd")

const EXIT_INCOMPLETE := 1
const EXIT_BAD_INPUT := 2

var exit_code := EXIT_INCOMPLETE


func _process(_delta: float) -> bool:
	work(OS.get_cmdline_user_args())
	quit(exit_code)
	return true


## Sets `exit_code` last.
func work(_arguments: PackedStringArray) -> void:
	pass


func fail(message: String, code: int) -> void:
	printerr("%s: %s" % [get_script().resource_path.get_file().get_basename(), message])
	exit_code = code
