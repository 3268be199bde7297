extends "support/scene_test.gd"
## The command that lets simulated participants make a study.

const StudySupport := preload("support/study_support.gd")
const ToolRun := preload("support/tool_run.gd")

var _folder := DirAccess.create_temp("steadyhand_study_command")
var _root := _folder.get_current_dir()


func test_the_command_refuses_what_it_cannot_use() -> void:
	var out := _root.path_join("refused")
	var empty := StudySupport.protocol()
	empty.gestures = []
	var empty_path := _root.path_join("empty.tres")
	check_equal(ResourceSaver.save(empty, empty_path), OK, "a protocol without gestures is saved")
	var binary_path := _root.path_join("damaged.res")
	FileAccess.open(binary_path, FileAccess.WRITE).store_buffer([0xff, 0xfe, 0xfd])
	var mistakes: Dictionary[String, PackedStringArray] = {
		"--out is missing": [],
		"--participants is '0'; it must be a whole number from 1 to 999": ["--participants", "0"],
		"--participants is '2.5'; it must be a whole number": ["--participants", "2.5"],
		"--seed is 'x'; it must be a whole number": ["--seed", "x"],
		"--seed is '9999999999999999999'; it must be": ["--seed", "9999999999999999999"],
		"'gestures' is empty: add one of": ["--protocol", empty_path],
		"none.tres': there is no such file": ["--protocol", out.path_join("none.tres")],
		"this is a StyleBoxFlat, no StudyProtocol": ["--protocol", "res://study/panel_style.tres"],
		"line 5: the value of 'gestures' does not end":
		["--protocol", _protocol_file("open", 'gestures = ["tap"\nseed = 3\n')],
		"line 6: 'seed' has no valid value":
		["--protocol", _protocol_file("bad", 'gestures = ["tap"]\nseed = three\n')],
		"it is no StudyProtocol, it is damaged, or it names a file": ["--protocol", binary_path],
	}
	for message in mistakes:
		var arguments := mistakes[message].duplicate()
		if message != "--out is missing":
			arguments.append_array(["--out", out])
		var tool := ToolRun.new("study", arguments)
		check_equal(tool.exit_code, 2, "exit code with %s" % [mistakes[message]])
		check_equal(tool.missing([message]), "", "the message")
		var errors := tool.output.count("ERROR: ") + tool.output.count("study: --")
		check_equal(errors, 1, "no other error with '%s'" % message)
	check(not DirAccess.dir_exists_absolute(out), "nothing is written")


func test_the_command_leaves_complete_sessions_alone() -> void:
	var protocol := StudySupport.protocol()
	protocol.gestures = ["tap"]
	var path := _root.path_join("protocol.tres")
	check_equal(ResourceSaver.save(protocol, path), OK, "a protocol is saved")
	var out := _root.path_join("command")
	var arguments := ["--out", out, "--protocol", path, "--participants", "2", "--seed", "5"]
	var first := ToolRun.new("study", PackedStringArray(arguments))
	check_equal(first.exit_code, 0, "exit code")
	var warning := "study: Questionnaire 'three_statements': 'after_trials' is 4, and does not divide"
	check_equal(first.missing([warning]), "", "a warning of its questionnaire")
	var table := FileAccess.get_file_as_string(out.path_join("sub-p02/ses-01/trials.csv"))
	check_equal(table.count("\n"), 10, "a header, 8 trials and a practice trial")
	var repeated := ToolRun.new("study", PackedStringArray(arguments))
	check_equal(repeated.exit_code, 2, "exit code of a repeated command")
	check_equal(repeated.missing(["sub-p01 exists.", "Add --resume"]), "", "it says what to do")
	arguments.append("--resume")
	var second := ToolRun.new("study", PackedStringArray(arguments))
	check_equal(second.exit_code, 0, "exit code with --resume")
	check_equal(
		second.missing(["sub-p02/ses-01: complete"]), "", "the output names the complete session"
	)
	var again := FileAccess.get_file_as_string(out.path_join("sub-p02/ses-01/trials.csv"))
	check_equal(again, table, "and changes nothing")
	check(not DirAccess.dir_exists_absolute(out.path_join("sub-p02/ses-02")), "no new session")
	arguments[arguments.find("5")] = "6"
	var other := ToolRun.new("study", PackedStringArray(arguments))
	var changed := "sub-p02/ses-01: it keeps the protocol of its start, but 'seed' of the study's"
	check_equal(other.missing([changed]), "", "a warning of another seed")


## A file with these lines as its resource; the first has number 5.
func _protocol_file(name: String, lines: String) -> String:
	var text := '[gd_resource type="Resource" format=3]\n'
	text += '[ext_resource type="Script" path="res://study/study_protocol.gd" id="protocol"]\n'
	text += '[resource]\nscript = ExtResource("protocol")\n' + lines
	var path := _root.path_join("%s.tres" % name)
	FileAccess.open(path, FileAccess.WRITE).store_string(text)
	return path
