extends SceneTree
## A test without a framework: copy it, put your scene in place of the sample, and run
##     godot --headless --fixed-fps 90 --path . --script res://script_test.gd
## The exit status is the number of checks that failed.

const KEY_PANEL := preload("res://addons/steadyhand/samples/key_panel.tscn")

var _failures := 0


func _initialize() -> void:
	# No node is ready before the first frame.
	await process_frame
	await _test_a_tap_presses_its_key()
	await _test_a_dropout_of_0_1_s_does_no_harm()
	print("%d failed" % _failures)
	quit(_failures)


func _test_a_tap_presses_its_key() -> void:
	var panel := KEY_PANEL.instantiate()
	root.add_child(panel)
	var hmm := panel.get_node(^"GestureHMM") as GestureHMM
	var hand := GestureTestHand.attach(hmm.tracker)
	hand.make_gesture(hmm.tasks[4])
	_check(await hand.wait_for(panel.key_pressed, 5.0), "a key is pressed")
	_check(hmm.current_task == hmm.tasks[4], "it is the 5")
	panel.free()


func _test_a_dropout_of_0_1_s_does_no_harm() -> void:
	var panel := KEY_PANEL.instantiate()
	root.add_child(panel)
	var hmm := panel.get_node(^"GestureHMM") as GestureHMM
	var hand := GestureTestHand.attach(hmm.tracker)
	hmm.gesture_started.connect(
		func(_gesture: StringName, _task: GestureTask) -> void: hand.drop_out(0.1)
	)
	hand.make_gesture(hmm.tasks[4])
	_check(await hand.wait_for(panel.key_pressed, 5.0), "a key is pressed")
	panel.free()


func _check(condition: bool, what: String) -> void:
	print("%s  %s" % ["pass" if condition else "FAIL", what])
	if not condition:
		_failures += 1
