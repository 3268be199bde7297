class_name StudySession
extends RefCounted
## The files of one session of one participant: docs/study_files.md. Opens a new session or resumes
## an unfinished one. A crash loses the running trial at most.

## Rows could not be written, or can be written again (empty). Show it to the operator.
signal trouble(message: String)
signal event_added(event: String, value: String, trial: int)

const Columns := preload("study_columns.gd")
const SessionFile := preload("session_file.gd")
const SessionLock := preload("session_lock.gd")
const Stored := preload("res://scripts/stored.gd")
const StudyTable := preload("study_table.gd")
const WholeFile := preload("whole_file.gd")

const SESSION_FILE := "session.json"
const ID_LENGTH := 32
const LETTERS_AND_DIGITS := "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"

const ORIGIN_DIFFERS := (
	"%s: this session has the origin '%s', and this hand has '%s'."
	+ " Use another id, or the source of this session"
)

## Of the participant: STUDY/sub-ID/ses-NN.
var folder := ""
var participant := ""
var number := 0
var run := 0
var origin := ""
## As in session.json.
var trials: Array[Dictionary] = []
var protocol: Dictionary = {}
## Properties of the study's protocol that have changed since then; see compare_protocol().
var changed := PackedStringArray()
## Why nothing could be opened. Empty when all is well.
var error := ""

var _planned: Array[Dictionary] = []
var _questionnaires: Dictionary[String, Questionnaire] = {}
var _finished: Dictionary[int, bool] = {}
var _answered: Dictionary[String, bool] = {}
var _trials_table: StudyTable = null
var _answers_table: StudyTable = null
var _events_table: StudyTable = null
## Texts of whole files that are not on the disk yet, by path.
var _pending_files: Dictionary[String, String] = {}
var _is_in_trouble := false
var _lock := SessionLock.new()


## Why `id` cannot be a participant's id. Empty when it can.
static func id_problem(id: String) -> String:
	var is_good := id.length() >= 1 and id.length() <= ID_LENGTH
	for letter in id:
		is_good = is_good and letter in LETTERS_AND_DIGITS
	if is_good:
		return ""
	return (
		"Participant '%s': an id must be 1 to %d letters (a-z, A-Z) and digits, such as p01."
		% [id, ID_LENGTH]
	)


## Name of a folder beside `path` that differs only in upper and lower case. Empty: none.
static func folder_in_other_case(path: String) -> String:
	var parent := path.get_base_dir()
	if not DirAccess.dir_exists_absolute(parent):
		return ""
	return Stored.same_in_other_case(path.get_file(), DirAccess.get_directories_at(parent))


## Starts a new session in any case. `settings`: of the nodes, for session.json.
func start(
	study_folder: String,
	participant_id: String,
	wanted: StudyProtocol,
	given_origin: String,
	settings: Dictionary = {}
) -> Error:
	var found := wanted.problems()
	if not found.is_empty():
		return _fail("The protocol cannot be used: %s" % " ".join(found))
	if _enter(study_folder, participant_id) != OK:
		return ERR_INVALID_PARAMETER
	var person_folder := folder
	number = _last_session(person_folder) + 1
	folder = person_folder.path_join("ses-%02d" % number)
	if DirAccess.dir_exists_absolute(folder) and _has_trials():
		return _fail(
			"%s has trials, but no session.json: restore it, or move the folder away" % folder
		)
	var made := DirAccess.make_dir_recursive_absolute(folder)
	if made != OK:
		return _fail("%s: the folder cannot be made: %s" % [folder, error_string(made)])
	var plan := SessionFile.make(wanted, participant_id, number, given_origin, settings)
	if SessionFile.write(folder.path_join(SESSION_FILE), plan) != OK:
		return _fail(WholeFile.failure_of(folder.path_join(SESSION_FILE)))
	return _open()


## Resumes the participant's last session. ERR_DOES_NOT_EXIST: none is unfinished.
## `given_origin`: of the hand that would continue it.
func resume(study_folder: String, participant_id: String, given_origin: String) -> Error:
	if _enter(study_folder, participant_id) != OK:
		return ERR_INVALID_PARAMETER
	number = _last_session(folder)
	folder = folder.path_join("ses-%02d" % number)
	if number == 0:
		return ERR_DOES_NOT_EXIST
	var opened := _open()
	if opened == OK and is_complete():
		return ERR_DOES_NOT_EXIST
	if opened == OK and origin != given_origin:
		return _fail(ORIGIN_DIFFERS % [folder, origin, given_origin])
	return opened


## Resumes the last session if it is unfinished, else starts a new one.
func start_or_resume(
	study_folder: String,
	participant_id: String,
	wanted: StudyProtocol,
	given_origin: String,
	settings: Dictionary = {}
) -> Error:
	var resumed := resume(study_folder, participant_id, given_origin)
	if resumed != ERR_DOES_NOT_EXIST:
		compare_protocol(wanted)
		return resumed
	return start(study_folder, participant_id, wanted, given_origin, settings)


## Warns if the protocol has changed since the session was planned.
func compare_protocol(wanted: StudyProtocol) -> void:
	if protocol.is_empty():
		return
	changed = SessionFile.differences(protocol, wanted)
	if not changed.is_empty():
		var text := "%s: it keeps the protocol of its start, but '%s' of the study's protocol changed."
		push_warning(text % [folder, "', '".join(changed)])


## The first planned trial without a row. Empty when every trial has one.
func next_trial() -> Dictionary:
	for trial in trials:
		if not _finished.has(trial["trial"]):
			return trial
	return {}


## The questionnaire that comes before the next trial: {after_trial, questionnaire, items (names of
## those without an answer)}. Empty: none.
func next_questionnaire() -> Dictionary:
	for entry in _planned:
		var after: int = entry["after_trial"]
		if not _finished.has(after):
			continue
		var asked := _questionnaires[entry["questionnaire"]]
		var items := PackedStringArray()
		for item in asked.items:
			if not _answered.has(_answer_key(after, asked.name, item)):
				items.append(item)
		if not items.is_empty():
			return {after_trial = after, questionnaire = asked, items = items}
	return {}


func is_complete() -> bool:
	return next_trial().is_empty() and next_questionnaire().is_empty()


func count_finished() -> int:
	return _finished.size()


func trial_path(trial: int, kind: String) -> String:
	return folder.path_join("trial_%04d.%s.csv" % [trial, kind])


## Adds the trial's row and writes all that is not on the disk yet. `row`: the columns that the plan
## does not have. The trial counts as finished, even if its row has to wait for the disk.
func finish_trial(trial: int, row: Dictionary) -> Error:
	var planned := trials[trial - 1]
	var whole := _common()
	for key: String in planned:
		if key in Columns.TRIALS:
			whole[key] = planned[key]
	whole["finished"] = Time.get_datetime_string_from_system()
	whole.merge(row, true)
	_trials_table.add(whole)
	_finished[trial] = true
	return flush()


## `answer`: item, text, value (null: skipped), changes, shown_s, answered_s.
func add_answer(after_trial: int, asked: Questionnaire, answer: Dictionary) -> void:
	var row := _common()
	for key: String in ["gesture", "position", "condition"]:
		row[key] = trials[after_trial - 1][key]
	row["after_trial"] = after_trial
	row["questionnaire"] = asked.name
	row["minimum"] = asked.minimum
	row["maximum"] = asked.maximum
	row["skipped"] = answer.get("value") == null
	row.merge(answer)
	_answers_table.add(row)
	_answered[_answer_key(after_trial, asked.name, answer["item"])] = true


## Waits in memory for the next flush(). `trial`: 0 outside of trials.
func add_event(time_s: float, event: String, value: String = "", trial: int = 0) -> void:
	var number_of_trial: Variant = trial if trial > 0 else null
	_events_table.add(
		{t_s = time_s, run = run, trial = number_of_trial, event = event, value = value}
	)
	event_added.emit(event, value, trial)


## Written with the next flush().
func add_file(path: String, text: String) -> void:
	_pending_files[path] = text


## Writes all that waits in memory. Not while a hand moves: it may take some milliseconds. Files of
## a trial are on the disk before its row is.
func flush() -> Error:
	for path: String in _pending_files.keys():
		if WholeFile.write(path, _pending_files[path]) != OK:
			return _report_trouble(path)
		_pending_files.erase(path)
	for table: StudyTable in [_events_table, _answers_table, _trials_table]:
		if table.flush() != OK:
			return _report_trouble(table.path)
	if _is_in_trouble:
		_is_in_trouble = false
		print("%s: can be written again; nothing is lost" % folder)
		trouble.emit("")
	return OK


func _enter(study_folder: String, participant_id: String) -> Error:
	error = id_problem(participant_id)
	if not error.is_empty():
		return _fail(error)
	participant = participant_id
	folder = study_folder.path_join("sub-%s" % participant_id)
	var other := folder_in_other_case(folder)
	if not other.is_empty():
		return _fail(
			(
				"Participant '%s': there is '%s' already. Choose another id: case is not enough."
				% [participant_id, other.trim_prefix("sub-")]
			)
		)
	return OK


## Lets another program open the session. Also done when the object is freed.
func close() -> void:
	_lock.release()


## Reads the plan and what is finished of it, and takes cut rows off.
func _open() -> Error:
	var path := folder.path_join(SESSION_FILE)
	var plan := SessionFile.read(path)
	if plan.is_empty():
		return _fail(
			(
				"%s: this is no session of version %d, or it is cut or edited: restore it from a back-up"
				% [path, SessionFile.VERSION]
			)
		)
	if _lock.take(folder) != OK:
		return _fail(_lock.error)
	origin = plan["origin"]
	protocol = plan["protocol"]
	trials.assign(plan["trials"])
	_planned.assign(plan["questionnaires"])
	for asked: Dictionary in protocol["questionnaires"]:
		_questionnaires[asked["name"]] = Questionnaire.from_dictionary(asked)
	_trials_table = StudyTable.new(folder.path_join("trials.csv"), Columns.TRIALS)
	if not FileAccess.file_exists(_trials_table.path) and _has_trials():
		return _fail(
			(
				(
					"%s is missing, but trials were made: restore it from a back-up. "
					% _trials_table.path
				)
				+ "Otherwise new trials would replace them"
			)
		)
	_answers_table = StudyTable.new(folder.path_join("answers.csv"), Columns.ANSWERS)
	_events_table = StudyTable.new(folder.path_join("events.csv"), Columns.EVENTS)
	for table: StudyTable in [_trials_table, _answers_table, _events_table]:
		if table.open() != OK:
			return _fail(WholeFile.failure_of(table.path))
		if not table.has_header():
			return _fail(
				(
					"%s: the first line is not this table's header: restore the file from a back-up"
					% table.path
				)
			)
	run = 1
	for row in _trials_table.read():
		_finished[row["trial"].to_int()] = true
		run = maxi(run, row["run"].to_int() + 1)
	for row in _answers_table.read():
		var after: int = row["after_trial"].to_int()
		_answered[_answer_key(after, row["questionnaire"], row["item"])] = true
	for row in _events_table.read():
		run = maxi(run, row["run"].to_int() + 1)
	return OK


## Whether the folder has files of a trial.
func _has_trials() -> bool:
	var files := Array(DirAccess.get_files_at(folder))
	return files.any(func(file: String) -> bool: return file.begins_with("trial"))


## The highest number of a session with a session.json: a folder without it is empty.
static func _last_session(person_folder: String) -> int:
	var last := 0
	if DirAccess.dir_exists_absolute(person_folder):
		for name in DirAccess.get_directories_at(person_folder):
			var path := person_folder.path_join(name).path_join(SESSION_FILE)
			if name.begins_with("ses-") and FileAccess.file_exists(path):
				last = maxi(last, name.trim_prefix("ses-").to_int())
	return last


func _common() -> Dictionary:
	return {participant = participant, session = number, origin = origin, run = run}


static func _answer_key(after_trial: int, questionnaire: String, item: String) -> String:
	return "%d/%s/%s" % [after_trial, questionnaire, item]


func _fail(message: String) -> Error:
	error = message
	push_error(message)
	return ERR_INVALID_PARAMETER


## Reported once until the disk can be written again.
func _report_trouble(path: String) -> Error:
	if not _is_in_trouble:
		_is_in_trouble = true
		var message := (
			WholeFile.failure_of(path)
			+ " Nothing is lost yet: free some space and go on. Do not close the program before."
		)
		push_error(message)
		trouble.emit(message)
	return ERR_FILE_CANT_WRITE
