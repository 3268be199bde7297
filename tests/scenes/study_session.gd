extends "support/scene_test.gd"
## The files of a session: new, resumed, cut off, refused.

const Columns := preload("res://study/study_columns.gd")

var _folder := DirAccess.create_temp("steadyhand_study_session")
var _root := _folder.get_current_dir()


func test_a_new_session_has_plan_and_header() -> void:
	var session := _start("new", "ann")
	check_equal(session.folder, _root.path_join("new/sub-ann/ses-01"), "folder")
	var text := FileAccess.get_file_as_string(session.folder.path_join("session.json"))
	var saved: Dictionary = JSON.parse_string(text)
	for key: String in [
		"format",
		"version",
		"study",
		"participant",
		"session",
		"origin",
		"seed",
		"protocol",
		"trials",
		"questionnaires",
		"settings",
		"versions",
		"machine",
		"started"
	]:
		check(saved.has(key), "session.json has %s" % key)
	check_equal(saved["trials"].size(), 8, "trials in the plan")
	check_equal(saved["settings"]["mode"], "phase", "settings of the nodes")
	session.finish_trial(1, {shown_s = 1.5, recognised = "tap"})
	var lines := _text(session, "trials.csv").split("\n")
	check_equal(lines[0], ",".join(Columns.TRIALS), "columns of trials.csv")
	check_equal(lines.size(), 3, "a header and a row")
	check(lines[1].begins_with("1,1,1,1,ann,1,mouse,0,tap,"), "the plan is in the row")


func test_columns_are_those_of_the_documentation() -> void:
	var text := FileAccess.get_file_as_string(
		ProjectSettings.globalize_path("res://").path_join("../docs/study_files.md")
	)
	for columns: PackedStringArray in [Columns.TRIALS, Columns.ANSWERS]:
		for column in columns:
			var name := column
			for condition: String in ["measured", "average", "synthesised"]:
				name = (
					name.trim_suffix("_" + condition) + ("_C" if name.ends_with(condition) else "")
				)
			check("`%s`" % name in text, "docs/study_files.md has %s" % column)


func test_bad_ids_are_refused() -> void:
	# expects error: Participant 'ann/b': an id must be 1 to 32 letters (a-z, A-Z) and digits
	# expects error: Participant 'ann:b': an id must be
	# expects error: Participant '': an id must be
	# expects error: Participant 'Ann': there is 'ann' already
	for id: String in ["ä", "a".repeat(33), "a b", ".."]:
		check("'%s'" % id in StudySession.id_problem(id), "'%s' is refused" % id)
	check_equal(StudySession.id_problem("a".repeat(32)), "", "32 letters are not too many")
	for id: String in ["ann/b", "ann:b", ""]:
		var session := StudySession.new()
		var result := session.start(_root.path_join("bad"), id, _protocol(), "mouse")
		check(result != OK, "'%s' is refused" % id)
		check("'%s'" % id in session.error, "the message names it")
	check(not DirAccess.dir_exists_absolute(_root.path_join("bad")), "nothing is written")
	_start("case", "ann")
	var session := StudySession.new()
	check(
		session.start(_root.path_join("case"), "Ann", _protocol(), "mouse") != OK, "Ann beside ann"
	)


func test_a_bad_protocol_is_refused() -> void:
	# expects error: The protocol cannot be used: 'gestures' is empty
	var protocol := _protocol()
	protocol.gestures = []
	var session := StudySession.new()
	check(session.start(_root.path_join("bad"), "ann", protocol, "mouse") != OK, "refused")


func test_a_second_session_gets_the_next_number() -> void:
	var first := _start("twice", "ann")
	first.finish_trial(1, {})
	var before := _text(first, "trials.csv")
	var second := _start("twice", "ann")
	check_equal(second.folder.get_file(), "ses-02", "folder")
	second.finish_trial(1, {})
	check_equal(_text(first, "trials.csv"), before, "the first one stays as it is")


func test_an_unfinished_session_resumes_at_the_first_missing_trial() -> void:
	var session := _start("resume", "ann")
	check_equal(session.run, 1, "first run")
	for trial in [1, 2, 3]:
		session.finish_trial(trial, {})
	var resumed := StudySession.new()
	check_equal(resumed.resume(_root.path_join("resume"), "ann", "mouse"), OK, "resumed")
	check_equal(resumed.run, 2, "second run")
	check_equal(resumed.trials, session.trials, "the plan is the same")
	check_equal(resumed.next_trial()["trial"], 4, "next trial")
	for trial in range(4, 9):
		resumed.finish_trial(trial, {})
	check(resumed.next_trial().is_empty(), "no trial is left")
	while not resumed.next_questionnaire().is_empty():
		_answer(resumed)
	resumed.flush()
	check(resumed.is_complete(), "the session is complete")
	var again := StudySession.new()
	var result := again.resume(_root.path_join("resume"), "ann", "mouse")
	check_equal(result, ERR_DOES_NOT_EXIST, "a complete session is not resumed")


func test_a_session_of_another_running_program_is_refused() -> void:
	# expects one error: process 1 writes to this session. Close that program
	var session := _start("lock", "ann")
	var path := session.folder.path_join("session.lock")
	check_equal(_text(session, "session.lock"), "%d\n" % OS.get_process_id(), "the lock")
	session.finish_trial(1, {})
	var folder := session.folder
	session = null
	check(not FileAccess.file_exists(path), "a closed session has no lock")
	FileAccess.open(path, FileAccess.WRITE).store_string("1\n")
	var second := StudySession.new()
	check(second.resume(_root.path_join("lock"), "ann", "mouse") != OK, "refused")
	check(folder in second.error, "the message names the session")
	check(FileAccess.file_exists(path), "the lock stays")
	FileAccess.open(path, FileAccess.WRITE).store_string("999999999\n")
	check_equal(
		second.resume(_root.path_join("lock"), "ann", "mouse"), OK, "a stale lock is taken over"
	)


func test_a_changed_protocol_is_named_where_a_session_is_resumed() -> void:
	# expects one warning: ses-01: it keeps the protocol of its start, but 'seed', 'trials_per_cell'
	var session := _start("changed", "ann")
	session.close()
	var same := StudySession.new()
	same.start_or_resume(_root.path_join("changed"), "ann", _protocol(), "mouse")
	check_equal(same.changed, PackedStringArray(), "the same protocol")
	same.close()
	var protocol := _protocol()
	protocol.trials_per_cell = 4
	protocol.seed = 9
	var resumed := StudySession.new()
	var result := resumed.start_or_resume(_root.path_join("changed"), "ann", protocol, "mouse")
	check_equal(result, OK, "the session is resumed")
	check_equal(resumed.changed, PackedStringArray(["seed", "trials_per_cell"]), "what differs")
	check_equal(resumed.trials.size(), session.trials.size(), "it keeps its plan")


func test_a_hand_of_another_origin_cannot_resume_a_session() -> void:
	# expects one error: origin/sub-ann/ses-01: this session has the origin 'mouse', and this hand
	var session := _start("origin", "ann")
	session.close()
	var other := StudySession.new()
	var refused := other.resume(_root.path_join("origin"), "ann", "synthetic")
	check_equal(refused, ERR_INVALID_PARAMETER, "refused")
	check("Use another id" in other.error, "the message says what to do")


func test_a_cut_session_file_is_refused() -> void:
	# expects one error: half/sub-ann/ses-01/session.json: this is no session of version 1
	var session := _start("half", "ann")
	var path := session.folder.path_join("session.json")
	var text := _text(session, "session.json")
	FileAccess.open(path, FileAccess.WRITE).store_string(text.left(text.length() / 2))
	check(StudySession.new().resume(_root.path_join("half"), "ann", "mouse") != OK, "refused")


func test_a_plan_that_cannot_run_is_refused() -> void:
	# expects error: plan/sub-ann/ses-01/session.json: this is no session of version 1
	var session := _start("plan", "ann")
	session.close()
	var path := session.folder.path_join("session.json")
	var text := _text(session, "session.json")
	for change: Array in [
		['"gesture": "', '"gesture": "un'],
		['"rest_before_s": 0.0', '"rest_before_s": 1e30'],
		['"practice": ', '"practise": '],
		['"protocol": {', '"protocol": 1, "other": {'],
	]:
		FileAccess.open(path, FileAccess.WRITE).store_string(text.replace(change[0], change[1]))
		var refused := StudySession.new().resume(_root.path_join("plan"), "ann", "mouse")
		check_equal(refused, ERR_INVALID_PARAMETER, "with %s" % change[1])


func test_trials_without_a_session_file_are_refused() -> void:
	# expects one error: has trials, but no session.json: restore it, or move the folder away
	var session := _start("no_plan", "ann")
	session.finish_trial(1, {})
	session.close()
	DirAccess.remove_absolute(session.folder.path_join("session.json"))
	var next := StudySession.new()
	var refused := next.start_or_resume(_root.path_join("no_plan"), "ann", _protocol(), "mouse")
	check_equal(refused, ERR_INVALID_PARAMETER, "no plan is made for the trials of another plan")


func test_a_session_that_lost_its_trials_table_is_refused() -> void:
	# expects one error: trials.csv is missing, but trials were made: restore it from a back-up
	var session := _start("lost", "ann")
	session.add_file(session.folder.path_join("trial_0001.motion.csv"), "t\n")
	session.finish_trial(1, {})
	DirAccess.remove_absolute(session.folder.path_join("trials.csv"))
	check(StudySession.new().resume(_root.path_join("lost"), "ann", "mouse") != OK, "not resumed")
	check(not FileAccess.file_exists(session.folder.path_join("trials.csv")), "nothing is written")


func test_a_table_that_a_spreadsheet_saved_is_read_or_refused() -> void:
	# expects one error: trials.csv: the first line is not this table's header
	var session := _start("sheet", "ann")
	session.finish_trial(1, {})
	var path := session.folder.path_join("trials.csv")
	var text := _text(session, "trials.csv")
	FileAccess.open(path, FileAccess.WRITE).store_string("\ufeff" + text.replace("\n", "\r\n"))
	var again := StudySession.new()
	check_equal(
		again.resume(_root.path_join("sheet"), "ann", "mouse"), OK, "a BOM and CRLF are read"
	)
	check_equal(again.next_trial()["trial"], 2, "trial 1 is finished")
	FileAccess.open(path, FileAccess.WRITE).store_string(text.replace(",", ";"))
	check(
		StudySession.new().resume(_root.path_join("sheet"), "ann", "mouse") != OK,
		"semicolons are refused"
	)


func test_unanswered_items_are_asked_again_after_a_crash() -> void:
	var session := _start("answers", "ann")
	for trial in [1, 2, 3, 4]:
		session.finish_trial(trial, {})
	var due := session.next_questionnaire()
	check_equal(due["after_trial"], 4, "a questionnaire is due")
	session.add_answer(4, due["questionnaire"], {item = "synchronisation", value = 3, changes = 0})
	session.flush()
	var resumed := StudySession.new()
	resumed.resume(_root.path_join("answers"), "ann", "mouse")
	var left: PackedStringArray = resumed.next_questionnaire()["items"]
	check_equal(left, PackedStringArray(["smoothness", "completion"]), "the others are left")


func test_a_cut_last_row_is_kept_aside() -> void:
	var session := _start("cut", "ann")
	for trial in [1, 2]:
		session.finish_trial(trial, {})
	var path := session.folder.path_join("trials.csv")
	var whole := _text(session, "trials.csv")
	var file := FileAccess.open(path, FileAccess.WRITE)
	var second := whole.split("\n")[2]
	file.store_string(whole.substr(0, whole.length() - 12))
	file.close()
	var resumed := StudySession.new()
	check_equal(resumed.resume(_root.path_join("cut"), "ann", "mouse"), OK, "resumed")
	check_equal(resumed.next_trial()["trial"], 2, "the cut trial is made again")
	resumed.finish_trial(2, {})
	check_equal(_text(resumed, "trials.csv").count("\n"), 3, "a header and two rows")
	var kept := second.substr(0, second.length() - 11) + "\n"
	check_equal(_text(resumed, "trials.csv.cut"), kept, "the cut row is in the .cut file")


func test_texts_with_commas_quotes_and_line_breaks_stay_one_row() -> void:
	var session := _start("quotes", "ann")
	session.add_event(1.0, "answered", 'a, "b"\nc', 1)
	session.flush()
	var file := FileAccess.open(session.folder.path_join("events.csv"), FileAccess.READ)
	file.get_csv_line()
	var row := file.get_csv_line()
	check_equal(row[4], 'a, "b" c', "the text")
	check_equal(row.size(), 5, "cells")


func test_rows_wait_in_memory_while_the_file_cannot_be_written() -> void:
	# expects one error: cannot be written. Is the disk full, or has another program opened the file?
	var session := _start("waits", "ann")
	session.finish_trial(1, {})
	var path := session.folder.path_join("trials.csv")
	DirAccess.rename_absolute(path, path + ".away")
	DirAccess.make_dir_absolute(path)
	var messages: Array[String] = []
	session.trouble.connect(func(message: String) -> void: messages.append(message))
	check(session.finish_trial(2, {}) != OK, "trial 2 has to wait")
	check(session.finish_trial(3, {}) != OK, "trial 3 has to wait")
	check_equal(messages.size(), 1, "one message")
	DirAccess.remove_absolute(path)
	DirAccess.rename_absolute(path + ".away", path)
	check_equal(session.finish_trial(4, {}), OK, "trial 4 is written")
	check_equal(messages.size(), 2, "a signal that the file can be written again")
	var lines := _text(session, "trials.csv").split("\n", false)
	check_equal(lines.size(), 5, "a header and four rows")
	for i in range(1, 5):
		check_equal(lines[i].get_slice(",", 0), str(i), "row %d" % i)


func _answer(session: StudySession) -> void:
	var due := session.next_questionnaire()
	for item: String in due["items"]:
		session.add_answer(due["after_trial"], due["questionnaire"], {item = item, changes = 0})


func _start(study: String, id: String) -> StudySession:
	var session := StudySession.new()
	check_equal(
		session.start(_root.path_join(study), id, _protocol(), "mouse", {mode = "phase"}),
		OK,
		"started"
	)
	return session


func _protocol() -> StudyProtocol:
	var protocol := StudyProtocol.paper()
	protocol.gestures = ["tap"]
	protocol.conditions = ["measured", "synthesised"]
	protocol.trials_per_cell = 2
	protocol.block_size = 2
	protocol.practice_trials = 0
	protocol.questionnaires[0] = protocol.questionnaires[0].duplicate()
	protocol.questionnaires[0].after_trials = 4
	return protocol


func _text(session: StudySession, name: String) -> String:
	return FileAccess.get_file_as_string(session.folder.path_join(name))
