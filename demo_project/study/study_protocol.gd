class_name StudyProtocol
extends "checked_resource.gd"
## The protocol of a study. Edit it in the inspector and save it as a *.tres file. The
## defaults are those of the paper ("Procedure").

enum Order {
	## The cells of a gesture come in a random order, drawn anew for each round of blocks.
	RANDOM,
	## A row of a balanced Latin square (Williams design), chosen by the participant's number.
	LATIN_SQUARE,
	## As listed: positions, then conditions, then amplitudes, then widths.
	FIXED,
}

const Conditions := preload("res://scripts/conditions.gd")
const Tasks := preload("res://scripts/tasks.gd")

const POSITIONS: PackedStringArray = ["stable", "unstable"]
const MOST_TRIALS := 9999
const LONGEST_NAME := 64
const LONGEST_TRIAL_S := 600.0
const LONGEST_REST_S := 3600.0
const PAPER_QUESTIONNAIRE := "res://study/questionnaires/three_statements.tres"

## Name of the study's folder, and of the study in its files.
@export var study_name := "steadyhand"
@export_group("Cells")
## Some of "horizontal_drag", "vertical_drag", "tap" and "zoom". No others.
@export var gestures: PackedStringArray = ["horizontal_drag", "vertical_drag", "tap", "zoom"]
## "stable", "unstable" or both.
@export var positions: PackedStringArray = ["stable", "unstable"]
## Motions that drive vibration and scene: some of "measured", "average", "one_euro", "kalman" and
## "synthesised".
@export var conditions: PackedStringArray = ["measured", "average", "synthesised"]
## Lengths of the gesture, m. Empty: the length that the task's scene or the simulated person has.
@export var amplitudes_m: PackedFloat64Array = []
## Widths of the target, m. Empty: the width that the task's scene has.
@export var widths_m: PackedFloat64Array = []
@export_group("Trials")
## A cell is a gesture, position, condition, amplitude and width.
@export_range(1, 100, 1, "or_greater") var trials_per_cell := 10
## Trials of one cell that follow each other.
@export_range(1, 100, 1, "or_greater") var block_size := 5
## Before the first block of each gesture. No analysis counts them.
@export_range(0, 100, 1, "or_greater") var practice_trials := 3
## How the order of the cells is drawn for each participant.
@export var order := Order.RANDOM
## Whether the order of the gestures changes between participants too. Off: as listed.
@export var vary_gesture_order := false
## A trial without the end of a gesture ends after this time, s.
@export_range(1.0, LONGEST_TRIAL_S, 0.5, "suffix:s") var trial_limit_s := 30.0
@export_group("Rests")
## A rest comes after so many trials, practice trials not counted. 0: never.
@export_range(0, 1000, 1, "or_greater") var rest_after_trials := 30
## Length of a rest, s.
@export_range(0.0, LONGEST_REST_S, 1.0, "suffix:s") var rest_s := 60.0
@export_group("")
## What the participant answers, and when: see Questionnaire.
@export var questionnaires: Array[Questionnaire] = []
## Together with the participant's id it decides every random order.
@export var seed := 0


## The paper's study.
static func paper() -> StudyProtocol:
	var protocol := StudyProtocol.new()
	protocol.questionnaires = [load(PAPER_QUESTIONNAIRE) as Questionnaire]
	return protocol


## Trials of one participant without practice.
func count_trials() -> int:
	return (
		gestures.size()
		* positions.size()
		* conditions.size()
		* maxi(amplitudes_m.size(), 1)
		* maxi(widths_m.size(), 1)
		* trials_per_cell
	)


## Errors, and how to correct them. Empty: none.
func problems() -> PackedStringArray:
	var found := file_problems()
	if study_name.strip_edges().is_empty():
		found.append("The study has no name: set 'study_name'.")
	elif not _names_own_folder():
		var text := "'study_name' is '%s'; a folder has this name: use at most %d characters, "
		text += 'no dot first, no space at the ends, and none of : / \\ ? * " | %% < >.'
		found.append(text % [study_name, LONGEST_NAME])
	_check_names(found, "gestures", gestures, Tasks.SCENES.keys())
	_check_names(found, "positions", positions, POSITIONS)
	_check_names(found, "conditions", conditions, Conditions.NAMES)
	_check_lengths(found, "amplitudes_m", amplitudes_m)
	_check_lengths(found, "widths_m", widths_m)
	_check_range(found, "trials_per_cell", trials_per_cell, 1, MOST_TRIALS)
	_check_range(found, "practice_trials", practice_trials, 0, MOST_TRIALS)
	var planned := 0
	if maxi(trials_per_cell, practice_trials) <= MOST_TRIALS:
		planned = count_trials() + practice_trials * gestures.size()
	if planned > MOST_TRIALS:
		found.append(
			(
				"The plan has %d trials; at most %d fit into a session: lower 'trials_per_cell'."
				% [planned, MOST_TRIALS]
			)
		)
	if block_size < 1 or trials_per_cell % block_size != 0:
		found.append(
			(
				"'block_size' is %d; it must divide 'trials_per_cell' (%d) evenly."
				% [block_size, trials_per_cell]
			)
		)
	_check_range(found, "order", order, 0, Order.size() - 1)
	if not (trial_limit_s > 0.0 and trial_limit_s <= LONGEST_TRIAL_S):
		found.append(
			(
				"'trial_limit_s' is %s; it must be above 0 s and at most %d s."
				% [trial_limit_s, LONGEST_TRIAL_S]
			)
		)
	if rest_after_trials < 0:
		found.append("'rest_after_trials' is %d; it must be 0 or more." % rest_after_trials)
	if not (rest_s >= 0.0 and rest_s <= LONGEST_REST_S):
		found.append("'rest_s' is %s; it must be 0 to %d s." % [rest_s, LONGEST_REST_S])
	_check_questionnaires(found)
	return found


## Problems of the answers in a valid study. Empty: none.
func warnings() -> PackedStringArray:
	var found := PackedStringArray()
	for asked in questionnaires:
		if asked != null and asked.after_trials > 0 and block_size % asked.after_trials != 0:
			var text := "Questionnaire '%s': 'after_trials' is %d, and does not divide 'block_size' (%d): "
			text += "its answers are about several conditions, and count for the last one."
			found.append(text % [asked.name, asked.after_trials, block_size])
	return found


func to_dictionary() -> Dictionary:
	return {
		study_name = study_name,
		gestures = Array(gestures),
		positions = Array(positions),
		conditions = Array(conditions),
		amplitudes_m = Array(amplitudes_m),
		widths_m = Array(widths_m),
		trials_per_cell = trials_per_cell,
		block_size = block_size,
		practice_trials = practice_trials,
		order = Order.keys()[order].to_lower(),
		vary_gesture_order = vary_gesture_order,
		trial_limit_s = trial_limit_s,
		rest_after_trials = rest_after_trials,
		rest_s = rest_s,
		questionnaires =
		questionnaires.map(func(asked: Questionnaire) -> Dictionary: return asked.to_dictionary()),
		seed = seed,
	}


## Whether no other name makes the same folder.
func _names_own_folder() -> bool:
	return (
		study_name.length() <= LONGEST_NAME
		and not study_name.begins_with(".")
		and study_name == study_name.validate_filename()
	)


func _check_questionnaires(found: PackedStringArray) -> void:
	var names := PackedStringArray()
	for asked in questionnaires:
		if asked == null:
			found.append("'questionnaires' has an empty slot: fill or remove it.")
			continue
		found.append_array(asked.problems())
		if asked.name in names:
			found.append("Two questionnaires are named '%s': rename one of them." % asked.name)
		names.append(asked.name)


static func _check_names(
	found: PackedStringArray, property: String, names: PackedStringArray, known: Array
) -> void:
	if names.is_empty():
		found.append("'%s' is empty: add one of %s." % [property, ", ".join(known)])
	for i in names.size():
		if names[i] not in known:
			found.append(
				"'%s' has '%s', which is unknown: use %s." % [property, names[i], ", ".join(known)]
			)
		elif names.find(names[i]) < i:
			found.append("'%s' has '%s' twice: remove one of them." % [property, names[i]])


static func _check_range(
	found: PackedStringArray, property: String, number: int, least: int, greatest: int
) -> void:
	if number < least or number > greatest:
		found.append("'%s' is %d; it must be %d to %d." % [property, number, least, greatest])


static func _check_lengths(
	found: PackedStringArray, property: String, lengths: PackedFloat64Array
) -> void:
	for length_m in lengths:
		if not (length_m >= 1e-3 and length_m <= 2.0):
			found.append("'%s' has %s m; it must be 0.001 to 2 m." % [property, length_m])
		if lengths.count(length_m) > 1:
			found.append("'%s' has %s m twice: remove one of them." % [property, length_m])
			return
