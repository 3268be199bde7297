extends "support/scene_test.gd"
## Protocols and the plans that are drawn from them.

const StudyPlan := preload("res://study/study_plan.gd")

const DRAWN := 477809202221779224


func test_default_protocol_is_the_papers() -> void:
	var protocol := StudyProtocol.paper()
	check_equal(protocol.problems(), PackedStringArray(), "it has no problems")
	var trials := StudyPlan.make(protocol, "p01")
	var cells := _count(trials, ["gesture", "position", "condition"])
	check_equal(cells.size(), 4 * 2 * 3, "a cell for each gesture, position and condition")
	check_equal(cells.values().count(10), cells.size(), "10 trials in each cell")
	var blocks := _count(trials, ["block", "gesture", "position", "condition"])
	check_equal(blocks.values().count(5), blocks.size(), "blocks of 5 trials of one cell")
	var practice := trials.filter(func(trial: Dictionary) -> bool: return trial["practice"])
	check_equal(practice.size(), 4 * 3, "3 practice trials for each gesture")
	for i in trials.size():
		if trials[i]["trial"] != i + 1:
			check(false, "trial %d has number %d" % [i + 1, trials[i]["trial"]])
	var asked := StudyPlan.make_questionnaires(protocol, trials)
	check_equal(asked.size(), 240 / 5, "three statements after every 5 trials")
	for entry in asked:
		var trial: Dictionary = trials[entry["after_trial"] - 1]
		var is_last: bool = int(trial["repetition"]) % 5 == 0 and not trial["practice"]
		if not is_last:
			check(false, "a questionnaire interrupts a block after trial %s" % trial)


func test_each_property_of_a_protocol_has_a_tooltip() -> void:
	for file: String in ["study_protocol", "questionnaire"]:
		var lines := FileAccess.get_file_as_string("res://study/%s.gd" % file).split("\n")
		for i in lines.size():
			if lines[i].begins_with("@export") and lines[i].contains(" var "):
				check(lines[i - 1].begins_with("## "), "%s: %s" % [file, lines[i]])


func test_equal_seed_and_participant_give_an_equal_plan() -> void:
	var protocol := StudyProtocol.paper()
	var first := StudyPlan.make(protocol, "p01")
	check_equal(StudyPlan.make(protocol, "p01"), first, "the same input gives the same plan")
	check(StudyPlan.make(protocol, "p02") != first, "another participant gets another plan")
	protocol.seed = 1
	check(StudyPlan.make(protocol, "p01") != first, "another seed gives another plan")
	# Python: int(hashlib.sha256(b"7/p01/3").hexdigest()[:15], 16)
	check_equal(StudyPlan.draw(7, "p01", 3), DRAWN, "draws equal those of another program")


func test_random_order_is_even() -> void:
	var protocol := StudyProtocol.new()
	protocol.gestures = ["tap"]
	protocol.positions = ["stable"]
	protocol.practice_trials = 0
	var first: Dictionary[String, int] = {}
	for i in 600:
		var condition: String = StudyPlan.make(protocol, "p%d" % i)[0]["condition"]
		first[condition] = first.get(condition, 0) + 1
	for condition in first:
		# Four standard deviations of a binomial distribution.
		check_near(first[condition], 200.0, 46.0, "%s is first as often as others" % condition)


func test_latin_squares_are_balanced() -> void:
	for n in range(1, 13):
		var rows := StudyPlan.latin_square(n)
		var places := {}
		var pairs := {}
		for row in rows:
			for place in n:
				var key := [place, row[place]]
				places[key] = places.get(key, 0) + 1
				if place > 0:
					var pair := [row[place - 1], row[place]]
					pairs[pair] = pairs.get(pair, 0) + 1
		check_equal(rows.size(), n if n % 2 == 0 or n == 1 else 2 * n, "n = %d: rows" % n)
		var each := rows.size() / n
		check_equal(places.values().count(each), n * n, "n = %d: each at each place" % n)
		var pairs_each: int = pairs.values().count(each)
		check_equal(pairs_each, n * (n - 1), "n = %d: each follows each other" % n)


func test_latin_square_protocol_balances_conditions_over_participants() -> void:
	var protocol := StudyProtocol.new()
	protocol.order = StudyProtocol.Order.LATIN_SQUARE
	protocol.gestures = ["tap"]
	protocol.positions = ["stable"]
	protocol.practice_trials = 0
	protocol.trials_per_cell = 5
	var places: Array[Dictionary] = []
	for participant in 6:
		var trials := StudyPlan.make(protocol, "p%02d" % (participant + 1))
		for trial in trials:
			places.append(
				{place = trial["block"], condition = trial["condition"], practice = false}
			)
	var counts := _count(places, ["place", "condition"])
	check_equal(counts.size(), 9, "three conditions at three places")
	check_equal(counts.values().count(10), 9, "two of six participants each")


func test_factors_of_amplitude_and_width_multiply_cells() -> void:
	var protocol := StudyProtocol.new()
	protocol.amplitudes_m = [0.1, 0.2]
	protocol.widths_m = [0.02, 0.04, 0.08]
	protocol.order = StudyProtocol.Order.FIXED
	protocol.trials_per_cell = 2
	protocol.block_size = 1
	var trials := StudyPlan.make(protocol, "ann")
	var cells := _count(trials, ["gesture", "position", "condition", "amplitude_m", "width_m"])
	check_equal(cells.size(), 4 * 2 * 3 * 2 * 3, "cells")
	check_equal(cells.values().count(2), cells.size(), "two trials in each")
	check_equal(protocol.count_trials(), 2 * cells.size(), "as counted")


func test_rests_come_after_so_many_trials() -> void:
	var protocol := StudyProtocol.paper()
	var rests := 0
	var counted := 0
	for trial in StudyPlan.make(protocol, "p01"):
		if trial["rest_before_s"] > 0.0:
			rests += 1
			check_equal(counted % 30, 0, "a rest after %d trials" % counted)
		counted += 0 if trial["practice"] else 1
	check_equal(rests, 240 / 30 - 1, "none after the last trial")


func test_problems_say_what_to_change() -> void:
	var protocol := StudyProtocol.paper()
	protocol.study_name = " "
	protocol.gestures = ["wave", "tap", "tap"]
	protocol.positions = []
	protocol.block_size = 3
	protocol.amplitudes_m = [NAN]
	protocol.rest_s = -1.0
	var asked := Questionnaire.new()
	asked.maximum = 0
	asked.items = ["a"]
	protocol.questionnaires = [asked, null]
	var found := "\n".join(protocol.problems())
	for text: String in [
		"'study_name'",
		"'wave', which is unknown: use horizontal_drag",
		"'tap' twice",
		"'positions' is empty: add one of stable",
		"'block_size' is 3; it must divide 'trials_per_cell' (10)",
		"'amplitudes_m' has nan",
		"'rest_s' is -1.0; it must be 0 to 3600 s",
		"'maximum' is 0; it must be above 0",
		"1 items, but 0 texts",
		"an empty slot",
	]:
		check(text in found, "a problem says: %s" % text)


func test_numbers_that_would_hang_a_study_are_refused() -> void:
	for one: Array in [
		["order", 7],
		["order", -1],
		["trials_per_cell", 1 << 62],
		["practice_trials", 1 << 62],
		["rest_s", INF],
		["rest_s", 1e18],
		["rest_after_trials", -1],
		["trial_limit_s", INF],
	]:
		var protocol := StudyProtocol.paper()
		protocol.set(one[0], one[1])
		var found := "\n".join(protocol.problems())
		check("'%s' is %s; it must be" % one in found, "%s = %s: %s" % [one[0], one[1], found])
	for one: Array in [["kind", 9], ["minimum", -(1 << 62)], ["maximum", 1 << 62]]:
		var asked: Questionnaire = load(StudyProtocol.PAPER_QUESTIONNAIRE).duplicate()
		asked.set(one[0], one[1])
		check_equal(asked.problems().size(), 1, "%s = %s" % one)


func test_names_that_make_no_folder_or_column_are_refused() -> void:
	for name: String in ["..", "x".repeat(65), "a:b", "a/b", " a"]:
		var protocol := StudyProtocol.paper()
		protocol.study_name = name
		var found := protocol.problems()
		check_equal(found.size(), 1, "one problem of '%s'" % name)
		check("'study_name' is '%s'; a folder has this name: use" % name in "".join(found), name)
	for name: String in ["a_b", "Größe 研究 (2)", "x".repeat(64)]:
		var protocol := StudyProtocol.paper()
		protocol.study_name = name
		check_equal(protocol.problems(), PackedStringArray(), "'%s' is accepted" % name)
	var asked := Questionnaire.new()
	asked.items = ["a", " "]
	asked.texts = ["b", "c"]
	check("item 2 has no name" in "".join(asked.problems()), "an item without a name")


func test_values_of_a_wrong_type_in_a_file_are_refused() -> void:
	# expects error: Unable to convert array index 0
	for line: String in [
		'gestures = "tap"',
		"amplitudes_m = 0.1",
		'order = "fixed"',
		"seed = 1.5",
		"study_name = 3",
		'rest_s = "60"',
		"questionnaires = [3]",
		"questionnaires = [\n3,\n]",
		'gestures = "tap\nzoom"',
		"amplitudes_m =\n0.1",
		'seed = {\n"a;]": "b\\"}" ; a comment with ]\n}',
	]:
		var found := _problems_of_file("", line)
		var property := line.get_slice("=", 0).strip_edges()
		check_equal(found.size(), 1, "one problem of %s" % line)
		check("'%s' is " % property in "".join(found), "%s: %s" % [line, found])
	var item := '[sub_resource type="Resource" id="asked"]\nscript = ExtResource("asked")\n'
	item += 'items = PackedStringArray("a")\ntexts = PackedStringArray("b")\nafter_trials = "5"\n'
	var inner := 'questionnaires = Array[ExtResource("asked")]([SubResource("asked")])'
	check(
		"'after_trials' is " in "".join(_problems_of_file(item, inner)), "of a resource in the file"
	)
	for line: String in [
		"rest_s = 60",
		'gestures = ["tap"]',
		"amplitudes_m = [0.1, 1]",
		'study_name = &"a = b"',
		"order = 2",
		"rest_s=\n60",
		'gestures = [\n"tap",\n"zoom"\n]\nseed = 3',
		'study_name = "tap = [3"\nseed = 3',
		"; rest_s = [\nseed = 3",
	]:
		check_equal(_problems_of_file("", line), PackedStringArray(), "accepted: %s" % line)


func test_answers_about_several_conditions_give_a_warning() -> void:
	var protocol := StudyProtocol.paper()
	for block_size: int in [5, 10]:
		protocol.block_size = block_size
		check_equal(
			protocol.warnings(), PackedStringArray(), "a question after 5 of %d" % block_size
		)
	for block_size: int in [1, 2]:
		protocol.block_size = block_size
		var warning := "'after_trials' is 5, and does not divide 'block_size' (%d)" % block_size
		check(warning in "".join(protocol.warnings()), warning)


func test_a_misspelt_property_of_a_file_is_a_problem() -> void:
	var folder := DirAccess.create_temp("steadyhand_study_plan")
	var protocol := StudyProtocol.paper()
	protocol.questionnaires = [Questionnaire.new()]
	var path := folder.get_current_dir().path_join("pilot.tres")
	check_equal(ResourceSaver.save(protocol, path), OK, "a protocol is saved")
	var text := FileAccess.get_file_as_string(path)
	text = (
		text.replace("\n[resource]", 'itemz = ["a"]\n\n[resource]') + '\nconditons = ["measured"]\n'
	)
	FileAccess.open(path, FileAccess.WRITE).store_string(text)
	var found := "\n".join((load(path) as StudyProtocol).problems())
	check(
		"%s: unknown property 'conditons'" % path in found, "the protocol's is named with its file"
	)
	check("unknown property 'itemz'" in found, "its questionnaire's is named")


func test_questionnaires_survive_json() -> void:
	for path: String in ["three_statements", "task_load"]:
		var asked := load("res://study/questionnaires/%s.tres" % path) as Questionnaire
		check_equal(asked.problems(), PackedStringArray(), "%s has no problems" % path)
		var text := JSON.stringify(asked.to_dictionary())
		var again := Questionnaire.from_dictionary(JSON.parse_string(text))
		check_equal(again.to_dictionary(), asked.to_dictionary(), "%s is the same again" % path)


## Problems of a protocol whose file has this line.
func _problems_of_file(sub_resource: String, line: String) -> PackedStringArray:
	var text := '[gd_resource type="Resource" format=3]\n'
	text += '[ext_resource type="Script" path="res://study/study_protocol.gd" id="protocol"]\n'
	text += '[ext_resource type="Script" path="res://study/questionnaire.gd" id="asked"]\n'
	text += '%s[resource]\nscript = ExtResource("protocol")\n%s\n' % [sub_resource, line]
	var path := "user://wrong_type.tres"
	FileAccess.open(path, FileAccess.WRITE).store_string(text)
	var protocol: StudyProtocol = ResourceLoader.load(path, "", ResourceLoader.CACHE_MODE_IGNORE)
	return protocol.problems()


## Trials that are no practice, by these keys.
func _count(trials: Array[Dictionary], keys: PackedStringArray) -> Dictionary:
	var counts := {}
	for trial in trials:
		if trial["practice"]:
			continue
		var key: Array = Array(keys).map(func(name: String) -> Variant: return trial[name])
		counts[key] = counts.get(key, 0) + 1
	return counts
