extends "tool.gd"
## godot --headless --path demo_project --script res://tools/evaluate.gd -- --trials DIR --out DIR
##     [--models DIR] [--mode phase|paper] [--context scene|open] [--sensor-latency SECONDS]
##     [--min-confidence PROBABILITY]
##
## Exit code: 0; 1 if a trial could not be evaluated (the others are reported) or the set has none;
## 2 if nothing could be done.

const Evaluation := preload("evaluation.gd")
const ModelFolder := preload("model_folder.gd")

## The largest GestureHMM.sensor_latency, s.
const LONGEST_LATENCY_S := 0.2


func work(arguments: PackedStringArray) -> void:
	var defaults: Dictionary[String, String] = {
		trials = "",
		out = "",
		models = ModelFolder.default_path(),
		mode = Evaluation.MODES.keys()[0],
		context = Evaluation.CONTEXTS[0],
	}
	defaults["sensor-latency"] = str(Evaluation.default_of(&"sensor_latency"))
	defaults["min-confidence"] = str(Evaluation.default_of(&"min_confidence"))
	var options := CommandLine.new(arguments, defaults)
	var trials_folder := options.path("trials")
	var out_folder := options.path("out")
	var settings := {
		mode = options.choice("mode", Evaluation.MODES.keys()),
		context = options.choice("context", Evaluation.CONTEXTS),
		sensor_latency_s = options.number("sensor-latency", 0.0, LONGEST_LATENCY_S, "time in s"),
		min_confidence = options.number("min-confidence", 0.0, 1.0, "probability"),
		models = options.path("models"),
		trials = trials_folder,
	}
	if not options.error.is_empty():
		fail(options.error, EXIT_BAD_INPUT)
		return
	var models := ModelFolder.load_all(settings["models"])
	if models.is_empty():
		exit_code = EXIT_BAD_INPUT
		return
	var trial_set := TrialSet.load_folder(trials_folder)
	if trial_set == null:
		exit_code = EXIT_BAD_INPUT
		return
	var evaluation := Evaluation.new()
	evaluation.run(trial_set, models, settings, out_folder, root)
	if not evaluation.get_text().is_empty():
		print(evaluation.get_text())
	if not evaluation.error.is_empty():
		fail(evaluation.error, EXIT_BAD_INPUT)
	elif not evaluation.shortcoming().is_empty():
		fail(evaluation.shortcoming(), EXIT_INCOMPLETE)
	else:
		exit_code = 0
