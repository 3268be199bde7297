class_name Questionnaire
extends "checked_resource.gd"
## Statements or scales that the participant answers between trials.

enum Kind {
	## Agreement with statements. A high value is a good one.
	LIKERT,
	## Raw NASA Task Load Index: six scales from 0 to 100. A high value is a high load.
	TASK_LOAD,
}

## Limit of both ends of the scale, without the sign.
const FARTHEST_ANSWER := 1000000

## Name in answers.csv and in the report.
@export var name := "questionnaire"
## What a high answer means.
@export var kind := Kind.LIKERT
## Names of the items in answers.csv, for example "smoothness".
@export var items: PackedStringArray = []
## Texts for the participant, one for each item.
@export_multiline var texts: PackedStringArray = []
## Least answer to every item. Answers are whole numbers.
@export var minimum := 0
## Greatest answer to every item.
@export var maximum := 4
## Distance between two neighbouring answers.
@export var step := 1
## Name of the scale's lower end. Empty: the panel shows numbers only.
@export var minimum_label := ""
## Name of the scale's upper end.
@export var maximum_label := ""
## Shown after so many trials of the plan, without practice trials. 0: once, after the last one.
@export var after_trials := 5


## Errors, and how to correct them. Empty: none.
func problems() -> PackedStringArray:
	var found := file_problems()
	var where := "Questionnaire '%s'" % name
	if name.strip_edges().is_empty():
		found.append("A questionnaire has no name: set 'name'.")
	if items.is_empty():
		found.append("%s has no items: add names to 'items'." % where)
	if items.size() != texts.size():
		found.append(
			(
				"%s: %d items, but %d texts: write one text for each item."
				% [where, items.size(), texts.size()]
			)
		)
	for item in items:
		if item.strip_edges().is_empty():
			found.append("%s: item %d has no name: add one." % [where, items.find(item) + 1])
			break
		if items.count(item) > 1:
			found.append("%s: item '%s' comes twice: rename one of them." % [where, item])
			break
	if kind < 0 or kind >= Kind.size():
		found.append("%s: 'kind' is %d; it must be 0 to %d." % [where, kind, Kind.size() - 1])
	if minimum < -FARTHEST_ANSWER or maximum > FARTHEST_ANSWER:
		found.append(
			(
				"%s: the scale is %d..%d; its ends must be %d to %d."
				% [where, minimum, maximum, -FARTHEST_ANSWER, FARTHEST_ANSWER]
			)
		)
	elif maximum <= minimum:
		found.append("%s: 'maximum' is %d; it must be above %d." % [where, maximum, minimum])
	elif step < 1 or (maximum - minimum) % step != 0:
		found.append(
			(
				"%s: 'step' is %d; it must divide the scale %d..%d evenly."
				% [where, step, minimum, maximum]
			)
		)
	if after_trials < 0:
		found.append("%s: 'after_trials' is %d; it must be 0 or more." % [where, after_trials])
	return found


func to_dictionary() -> Dictionary:
	return {
		name = name,
		kind = Kind.keys()[kind].to_lower(),
		items = Array(items),
		texts = Array(texts),
		minimum = minimum,
		maximum = maximum,
		step = step,
		minimum_label = minimum_label,
		maximum_label = maximum_label,
		after_trials = after_trials,
	}


## From the result of to_dictionary(), also after conversion to JSON.
static func from_dictionary(saved: Dictionary) -> Questionnaire:
	var made := Questionnaire.new()
	made.name = saved.get("name", "")
	made.kind = Kind.get(str(saved.get("kind", "likert")).to_upper(), Kind.LIKERT)
	made.items = PackedStringArray(saved.get("items", []))
	made.texts = PackedStringArray(saved.get("texts", []))
	made.minimum = int(saved.get("minimum", 0))
	made.maximum = int(saved.get("maximum", 4))
	made.step = int(saved.get("step", 1))
	made.minimum_label = saved.get("minimum_label", "")
	made.maximum_label = saved.get("maximum_label", "")
	made.after_trials = int(saved.get("after_trials", 0))
	return made
