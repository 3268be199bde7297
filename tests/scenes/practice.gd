extends "support/scene_test.gd"
## Practice runs: found positions, their file, and the moved task.

const LiveHand := preload("support/live_hand.gd")
const Participant := preload("res://scripts/participant.gd")
const Stage := preload("res://scripts/stage.gd")
const StudyOrder := preload("res://scripts/study_order.gd")
const TaskPlayer := preload("support/task_player.gd")
const TaskScene := preload("res://scripts/task_scene.gd")
const TrialRows := preload("support/trial_rows.gd")

## The sensor loses a hand farther away than this, so often and for so long.
const BAD_BEYOND_Z := -0.45
const GAP_S := 0.25
const GAP_EVERY_S := 0.8

var _folder := DirAccess.create_temp("steadyhand_practice")
var _hand := LiveHand.new()
var _found := ""


func test_a_practice_run_moves_the_task_and_is_kept() -> void:
	var name := "scene_test_%d" % Time.get_ticks_usec()
	Participant.chosen = name
	var player := TaskPlayer.new("horizontal_drag", _folder.get_current_dir(), self)
	var scene := player.scene
	scene.practice_ended.connect(func(found: String) -> void: _found = found)
	scene.follow_live()
	check_equal(player.colour("HandPlace"), Stage.PLACES[""], "no position before the practice")
	player.press(KEY_P)
	_sweep(scene, 125.0)
	check(_found.contains("stable at") and _found.contains("unstable at"), "text: %s" % _found)
	var kept := Participant.new(name)
	var stable := kept.get_position("horizontal_drag", "stable")
	var unstable := kept.get_position("horizontal_drag", "unstable")
	check(stable.z > -0.4, "stable where the hand is tracked: %s" % stable)
	check(unstable.z < -0.45, "unstable where it is lost: %s" % unstable)
	_check_place(player, stable, "stable")

	for stroke in StudyOrder.TRIALS_PER_BLOCK:
		check(_colour_is(player, "stable"), "drag %d is at the stable position" % (stroke + 1))
		_hand.make_gesture(scene, scene.task.amplitude)
		await process_frame
	_check_place(player, unstable, "unstable")
	var session := scene.session_folder
	scene.free()
	var stable_rows := 0
	for row in TrialRows.read(session):
		stable_rows += 1 if row["position"] == "stable" else 0
	check_equal(stable_rows, StudyOrder.TRIALS_PER_BLOCK, "the log names the position")

	var again := TaskPlayer.new("horizontal_drag", _folder.get_current_dir(), self)
	again.scene.follow_live()
	_check_place(again, stable, "stable")
	again.scene.free()
	var other := TaskPlayer.new("tap", _folder.get_current_dir(), self)
	other.scene.follow_live()
	check_equal(other.colour("HandPlace"), Stage.PLACES[""], "another task has its own practice")
	other.scene.free()
	DirAccess.remove_absolute("user://participants/%s.json" % name)
	Participant.chosen = ""


func test_a_practice_run_that_ends_early_moves_nothing() -> void:
	var player := TaskPlayer.new("tap", _folder.get_current_dir(), self)
	player.scene.practice_ended.connect(func(found: String) -> void: _found = found)
	player.scene.follow_live()
	var start := player.scene.task.get_start()
	player.press(KEY_P)
	_sweep(player.scene, 5.0)
	player.press(KEY_P)
	check(_found.contains("too short"), "text: %s" % _found)
	check_equal(player.scene.task.get_start(), start, "the task stays")
	player.scene.free()


# expects error: bad.json:1: Expected
# expects error: other.json: tap: 'unstable' has no position
func test_a_bad_file_is_reported_once_and_kept() -> void:
	var texts := {
		"bad": '{"tap": {"stable": ',
		"other":
		'{"tap": {"stable": {"position": [0, 0, 0]}, "unstable": {"position": [0, "a", 0]}}}',
	}
	for name: String in texts:
		var path := _folder.get_current_dir().path_join("%s.json" % name)
		FileAccess.open(path, FileAccess.WRITE).store_string(texts[name])
		var participant := Participant.new(name, _folder.get_current_dir())
		check(
			participant.error.contains("%s.json:" % name),
			"the error names the file: %s" % participant.error
		)
		check(not participant.has_positions("tap"), "no position is read")
		check_equal(FileAccess.get_file_as_string(path), texts[name], "the file stays the same")
		check_equal(participant.keep("zoom", _proposal()), OK, "a practice run is kept")
		var bad := Array(DirAccess.get_files_at(_folder.get_current_dir())).filter(
			func(file: String) -> bool: return file.begins_with(name) and file.ends_with(".bad")
		)
		check_equal(bad.size(), 1, "the old file has another name")
		var old := FileAccess.get_file_as_string(_folder.get_current_dir().path_join(bad[0]))
		check_equal(old, texts[name], "and is whole")
		var read := Participant.new(name, _folder.get_current_dir())
		check_equal(read.get_position("zoom", "unstable"), Vector3(0.25, 0, -0.5), "what was kept")


func test_a_name_in_other_case_is_refused() -> void:
	# expects one error: Participant 'Ann': there is 'ann' already. Choose another name
	var folder := _folder.get_current_dir().path_join("case")
	Participant.new("ann", folder).keep("tap", _proposal())
	var second := Participant.new("Ann", folder)
	check(not second.has_positions("tap"), "it has no positions of the first")
	check_equal(second.keep("zoom", _proposal()), OK, "its own are kept as long as the scene")
	check_equal(DirAccess.get_files_at(folder), PackedStringArray(["ann.json"]), "one file")
	check(not Participant.new("ann", folder).has_positions("zoom"), "the first is as before")


func _proposal() -> Dictionary:
	var places := {"stable": Vector3(0, 0, -0.25), "unstable": Vector3(0.25, 0, -0.5)}
	var proposal := {error = "", contrast = 5.0, distinct = true}
	for position: String in places:
		proposal[position] = {
			position = places[position], seconds = 9.0, lost_share = 0.0, noise = 0.0
		}
	return proposal


## Moves the hand through 50 x 40 x 40 cm; a hand far away is sometimes lost.
func _sweep(scene: TaskScene, seconds: float) -> void:
	var until_s := _hand.time_s + seconds
	var lost_until_s := 0.0
	var last_gap_s := _hand.time_s
	while _hand.time_s < until_s:
		var place := Vector3(
			0.25 * sin(TAU * 0.23 * _hand.time_s),
			0.2 * sin(TAU * 0.171 * _hand.time_s + 1.0),
			-0.4 + 0.2 * sin(TAU * 0.083 * _hand.time_s + 2.0)
		)
		if place.z < BAD_BEYOND_Z and _hand.time_s - last_gap_s > GAP_EVERY_S:
			last_gap_s = _hand.time_s
			lost_until_s = _hand.time_s + GAP_S
		_hand.push(scene, place, _hand.time_s >= lost_until_s)


func _check_place(player: TaskPlayer, place: Vector3, position: String) -> void:
	var task := player.scene.task
	var middle := task.get_start() + 0.5 * task.amplitude * task.get_axis()
	check(middle.distance_to(place) < 1e-4, "the task's middle is at the %s position" % position)
	var away := player.body("HandPlace").global_position - place
	check(Vector2(away.x, away.z).length() < 1e-4, "the cylinder is there")
	check(_colour_is(player, position), "in its colour")


func _colour_is(player: TaskPlayer, position: String) -> bool:
	return player.colour("HandPlace").is_equal_approx(Stage.PLACES[position])
