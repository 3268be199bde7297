extends "tool.gd"
## Trials of synthetic people, as TrialSet.write_synthetic() makes them:
##
## godot --headless --path demo_project --script res://tools/make_trials.gd -- --out DIR
##     --gestures NAME,NAME,... [--population train|tune|evaluate] [--subjects N]
##     [--trials-per-subject N] [--paces X,X,...] [--duration SECONDS]
##     [--earlier-rounds N]


func work(arguments: PackedStringArray) -> void:
	var defaults: Dictionary[String, String] = {
		"out": "",
		"gestures": "",
		"population": "evaluate",
		"subjects": "8",
		"trials-per-subject": "5",
		"paces": "1",
		"duration": "0",
		"earlier-rounds": "0",
	}
	var options := CommandLine.new(arguments, defaults)
	var out := options.path("out")
	var wanted := {
		gestures = options.given("gestures").split(","),
		population = options.text("population"),
		subjects = options.text("subjects").to_int(),
		trials_per_subject = options.text("trials-per-subject").to_int(),
		paces = options.text("paces").split_floats(","),
		duration = options.text("duration").to_float(),
		earlier_rounds = options.text("earlier-rounds").to_int(),
	}
	if not options.error.is_empty():
		fail(options.error, EXIT_BAD_INPUT)
		return
	exit_code = 0 if TrialSet.write_synthetic(out, wanted) == OK else EXIT_BAD_INPUT
