extends "tool.gd"
## godot --headless --path demo_project --script res://tools/synthesise.gd -- --out DIR
##     [--gestures NAME,NAME...] (default: all but the worked example, and none)
##     [--population train|tune|evaluate] [--subjects N] [--trials N] (a gesture, position, subject)
##
## Writes a trial set of synthetic people.


func work(arguments: PackedStringArray) -> void:
	var defaults: Dictionary[String, String] = {
		out = "", gestures = "", population = "train", subjects = "8", trials = "5"
	}
	var options := CommandLine.new(arguments, defaults)
	var out_folder := options.path("out")
	if not options.error.is_empty():
		fail(options.error, EXIT_BAD_INPUT)
		return
	var wanted := {
		gestures = options.text("gestures").split(",", false),
		population = options.text("population"),
		subjects = options.text("subjects").to_int(),
		trials_per_subject = options.text("trials").to_int(),
	}
	exit_code = 0 if TrialSet.write_synthetic(out_folder, wanted) == OK else EXIT_BAD_INPUT
	if exit_code == 0:
		print("wrote %s" % out_folder)
