extends "support/scene_test.gd"
## The order of a live hand's trials: blocks, positions in turn, conditions at random.

const Conditions := preload("res://scripts/conditions.gd")
const LiveHand := preload("support/live_hand.gd")
const StudyOrder := preload("res://scripts/study_order.gd")
const TaskPlayer := preload("support/task_player.gd")
const TrialRows := preload("support/trial_rows.gd")

const SEEDS := 300
const ROUNDS := 4

var _folder := DirAccess.create_temp("steadyhand_study_order")


func test_each_condition_has_its_blocks_in_each_round() -> void:
	var order := StudyOrder.new()
	order.conditions = Conditions.COMPARED.duplicate()
	var count := order.conditions.size()
	for positions: int in [1, 2]:
		var drawn_first: Dictionary[GestureHMM.Motion, int] = {}
		var is_whole := true
		var is_in_blocks := true
		for order_seed in SEEDS:
			order.begin(7, order_seed)
			var drawn: Array[GestureHMM.Motion] = []
			for turn in ROUNDS * count:
				for trial in StudyOrder.TRIALS_PER_BLOCK * positions:
					var index := 7 + turn * StudyOrder.TRIALS_PER_BLOCK * positions + trial
					var condition := order.condition_at(index, positions)
					if trial == 0:
						drawn.append(condition)
					is_in_blocks = is_in_blocks and condition == drawn[-1]
					var block := trial / StudyOrder.TRIALS_PER_BLOCK
					is_in_blocks = is_in_blocks and order.position_at(index, positions) == block
			for first in range(0, drawn.size(), count):
				var used: Dictionary[GestureHMM.Motion, bool] = {}
				for condition in drawn.slice(first, first + count):
					used[condition] = true
				is_whole = is_whole and used.size() == count
				drawn_first[drawn[first]] = drawn_first.get(drawn[first], 0) + 1
		check(is_in_blocks, "%d positions: a condition stays for a block at each" % positions)
		check(is_whole, "each is used once before any repeats")
		# Four standard deviations of a binomial, p = 1/3.
		var rounds := float(SEEDS * ROUNDS)
		for condition in order.conditions:
			var share: float = drawn_first.get(condition, 0) / rounds
			check_near(
				share, 1.0 / count, 4.0 * sqrt(2.0 / 9.0 / rounds), "each is first equally often"
			)


func test_a_live_hand_compares_conditions_block_by_block() -> void:
	var player := TaskPlayer.new("horizontal_drag", _folder.get_current_dir(), self)
	var scene := player.scene
	scene.follow_live()
	player.press(KEY_R)
	var hand := LiveHand.new()
	var count := StudyOrder.TRIALS_PER_BLOCK * Conditions.COMPARED.size()
	for drag in count:
		hand.make_gesture(scene, scene.task.amplitude)
		await process_frame
	var session := scene.session_folder
	player.press(KEY_1)
	hand.make_gesture(scene, scene.task.amplitude)
	scene.free()
	var conditions: Array[String] = []
	for row in TrialRows.read(session):
		conditions.append(row["condition"])
	var compared: Array[String] = []
	# Without the first trial, which R has cut off.
	for first in range(1, 1 + count, StudyOrder.TRIALS_PER_BLOCK):
		var five := conditions.slice(first, first + StudyOrder.TRIALS_PER_BLOCK)
		compared.append(five[0])
		check_equal(five.count(five[0]), 5, "five drags in one condition: %s" % five[0])
	compared.sort()
	check_equal(compared, ["average", "measured", "synthesised"] as Array[String], "the paper's")
	check_equal(conditions[-1], "measured", "a key chooses a condition")


func test_r_or_a_condition_key_ends_the_comparison() -> void:
	for ends: Key in [KEY_R, KEY_1]:
		var player := TaskPlayer.new("horizontal_drag", _folder.get_current_dir(), self)
		var scene := player.scene
		var readout := scene.find_child("Status", true, false) as Label
		scene.follow_live()
		player.press(KEY_R)
		await process_frame
		await process_frame
		check_equal(
			readout.text,
			"conditions in a random order",
			"key %d: the readout shows the order" % ends
		)
		player.press(ends)
		await process_frame
		await process_frame
		check_equal(readout.text, "one condition", "the readout shows the end of the comparison")
		var chosen := scene.gesture_hmm.motion
		var hand := LiveHand.new()
		for drag in 2 * StudyOrder.TRIALS_PER_BLOCK:
			hand.make_gesture(scene, scene.task.amplitude)
			await process_frame
			check_equal(scene.gesture_hmm.motion, chosen, "which stays")
		scene.free()
