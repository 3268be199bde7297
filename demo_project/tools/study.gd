extends "tool.gd"
## godot --headless --path demo_project --script res://tools/study.gd -- --out DIR
##     [--participants N] [--protocol FILE] (a StudyProtocol as *.tres; default: the paper's)
##     [--seed S] [--resume]
##
## Simulated participants p01, p02 ... make a whole study through the real nodes, faster than real
## time; see docs/study_files.md for what is in DIR. With --resume, unfinished sessions go on and
## complete ones are left as they are. Without it no participant may have a session in DIR.
##
## Exit code: 0; 2 if nothing could be done or a file could not be written.

const Progress := preload("progress.gd")
const ResourceText := preload("res://study/resource_text.gd")
const SyntheticQuestionnairePanel := preload("res://study/synthetic_questionnaire_panel.gd")
const SyntheticStudyHand := preload("res://study/synthetic_study_hand.gd")

const MOST_PARTICIPANTS := 999
const LONGEST_SEED := 18
const REPEATED := (
	"%s exists. A second session would have the same data as the first."
	+ " Add --resume, or name another folder"
)


func work(arguments: PackedStringArray) -> void:
	var flag := Array(arguments).find("--resume")
	if flag >= 0 and (flag + 1 == arguments.size() or arguments[flag + 1].begins_with("--")):
		arguments.insert(flag + 1, "true")
	var defaults: Dictionary[String, String] = {
		participants = "9", protocol = "", out = "", seed = "", resume = "false"
	}
	var options := CommandLine.new(arguments, defaults)
	var out_folder := options.path("out")
	var count := options.whole_number("participants", 1, MOST_PARTICIPANTS)
	var protocol_path := options.optional_path("protocol")
	var resumes := options.choice("resume", ["true", "false"]) == "true"
	var seed_text := options.text("seed")
	if not options.error.is_empty():
		fail(options.error, EXIT_BAD_INPUT)
		return
	if not protocol_path.is_empty() and not FileAccess.file_exists(protocol_path):
		fail("--protocol is '%s': there is no such file" % protocol_path, EXIT_BAD_INPUT)
		return
	var loaded := _load(protocol_path)
	if not loaded is StudyProtocol:
		var text := "--protocol is '%s': %s" % [protocol_path, _load_problem(loaded, protocol_path)]
		fail(text, EXIT_BAD_INPUT)
		return
	var protocol := loaded as StudyProtocol
	if not seed_text.is_empty():
		if not seed_text.is_valid_int() or seed_text.length() > LONGEST_SEED:
			var rule := "a whole number of at most %d digits" % LONGEST_SEED
			fail("--seed is '%s'; it must be %s" % [seed_text, rule], EXIT_BAD_INPUT)
			return
		protocol.seed = seed_text.to_int()
	var repeated := "" if resumes else _existing(out_folder, count)
	if not repeated.is_empty():
		fail(REPEATED % repeated, EXIT_BAD_INPUT)
		return
	for warning in protocol.warnings():
		printerr("study: %s" % warning)
	exit_code = 0
	for index in count:
		if not _run_participant(index, protocol, out_folder, resumes):
			exit_code = EXIT_BAD_INPUT
			return


## Folder of the first participant who has one. Empty: none.
func _existing(out_folder: String, count: int) -> String:
	for index in count:
		var folder := out_folder.path_join("sub-" + _id(index))
		if DirAccess.dir_exists_absolute(folder):
			return folder
	return ""


func _id(index: int) -> String:
	return "p%02d" % (index + 1)


## Null if the engine cannot load it.
func _load(path: String) -> Resource:
	if path.is_empty():
		return StudyProtocol.paper()
	# The engine would print several errors, which do not name the option.
	Engine.print_error_messages = false
	var loaded := ResourceLoader.load(path)
	Engine.print_error_messages = true
	return loaded


## Why this is no protocol.
func _load_problem(loaded: Resource, path: String) -> String:
	if loaded != null:
		return "this is a %s, no StudyProtocol" % loaded.get_class()
	var is_text := path.get_extension() == "tres"
	var fault := ResourceText.fault(FileAccess.get_file_as_string(path)) if is_text else ""
	if fault.is_empty():
		return "it is no StudyProtocol, it is damaged, or it names a file that is missing"
	return "%s. Correct it, or save the protocol again in the editor" % fault


func _run_participant(
	index: int, protocol: StudyProtocol, out_folder: String, resumes: bool
) -> bool:
	var id := _id(index)
	var session := StudySession.new()
	var hand := SyntheticStudyHand.new()
	hand.subject = index
	hand.seed = protocol.seed
	var opened := ERR_DOES_NOT_EXIST
	if resumes:
		opened = session.resume(out_folder, id, hand.origin)
		session.compare_protocol(protocol)
		if opened == ERR_DOES_NOT_EXIST and not session.trials.is_empty():
			print("%s: complete" % session.folder)
			hand.free()
			return true
	if opened == ERR_DOES_NOT_EXIST:
		session = StudySession.new()
		opened = session.start(out_folder, id, protocol, hand.origin, hand.get_settings())
	if opened != OK:
		hand.free()
		return false
	print(
		"%s: trial %d of %d" % [session.folder, session.count_finished() + 1, session.trials.size()]
	)
	var panel := SyntheticQuestionnairePanel.new()
	panel.participant = id
	panel.seed = protocol.seed
	var runner := StudyRunner.new()
	runner.vibration_bus = &""
	root.add_child(runner)
	runner.trial_ended.connect(
		func(_trial: Dictionary, figures: Dictionary) -> void: panel.remember(figures)
	)
	var progress := Progress.new(id)
	runner.begin(session, hand, panel)
	while runner.step():
		progress.show(float(session.count_finished()) / session.trials.size())
	runner.end()
	runner.free()
	return session.flush() == OK
