extends "support/scene_test.gd"
## Nodes follow their parent if no other node is set, and the overlay finds a GestureHMM.

const DebugOverlay := preload("res://addons/steadyhand/debug_overlay.gd")
const SOURCE := preload("res://addons/steadyhand/samples/repeated_drag.tres")
const MODEL := "res://addons/steadyhand/models/horizontal_drag.gesture"
const STEP_S := 0.01


func test_children_follow_their_parents() -> void:
	var tracker := _tracker()
	var hmm := _hmm()
	var synth := HapticSynth.new()
	tracker.add_child(hmm)
	hmm.add_child(synth)
	check(hmm.tracker == null, "outside of the tree it has no tracker")
	root.add_child(tracker)
	check_equal(hmm.tracker, tracker, "the tracker above")
	check_equal(synth.gesture_hmm, hmm, "the GestureHMM above")
	var peak := _play(tracker, synth)
	check_equal(hmm.recognised, &"horizontal_drag", "its gesture is recognised")
	check(peak > 0.9, "and felt: %s" % peak)
	tracker.free()


func test_a_node_that_is_set_comes_before_the_parent() -> void:
	var parent := _tracker()
	var other := _tracker()
	var hmm := _hmm()
	hmm.tracker = other
	parent.add_child(hmm)
	for node: Node in [parent, other]:
		root.add_child(node)
	check_equal(hmm.tracker, other, "it stays")
	hmm.tracker = parent
	hmm.reparent(other)
	check_equal(hmm.tracker, parent, "a set tracker stays with another parent")
	for node: Node in [parent, other]:
		node.free()


func test_a_child_that_moves_follows_its_new_parent() -> void:
	var first := _tracker()
	var second := _tracker()
	var hmm := _hmm()
	for node: Node in [first, second]:
		root.add_child(node)
	first.add_child(hmm)
	check_equal(hmm.tracker, first, "the first")
	hmm.reparent(second)
	check_equal(hmm.tracker, second, "the second")
	second.remove_child(hmm)
	check(hmm.tracker == null, "no tracker outside of the tree")
	for node: Node in [first, second, hmm]:
		node.free()


func test_the_overlay_shows_the_first_gesture_hmm() -> void:
	var tracker := _tracker()
	var scene := load("res://addons/steadyhand/debug_overlay.tscn") as PackedScene
	var overlay := scene.instantiate() as DebugOverlay
	root.add_child(overlay)
	var hmm := _hmm()
	tracker.add_child(hmm)
	root.add_child(tracker)
	for frame in 2:
		await process_frame
	check_equal(overlay.gesture_hmm, hmm, "it is found")
	for node: Node in [overlay, tracker]:
		node.free()


func test_a_simulated_person_makes_its_own_gesture_at_a_task_of_a_new_one() -> void:
	var task := GestureTask.new()
	task.name = "Mine"
	task.gesture = &"my_own"
	var source := SyntheticSource.new()
	source.placement = SyntheticSource.PLACEMENT_TASK
	source.task_path = ^"../Mine"
	var tracker := _tracker()
	tracker.source = source
	root.add_child(task)
	root.add_child(tracker)
	check_equal(tracker.start(), OK, "it starts")
	source.place_at(task)
	check_equal(source.gesture, &"horizontal_drag", "a copy keeps the gesture")
	for node: Node in [tracker, task]:
		node.free()


func _tracker() -> HandTracker:
	var tracker := HandTracker.new()
	tracker.source = SOURCE
	tracker.update_mode = HandTracker.UPDATE_MANUAL
	tracker.autostart = false
	return tracker


func _hmm() -> GestureHMM:
	var hmm := GestureHMM.new()
	hmm.models = [load(MODEL) as GestureModel]
	return hmm


## The strongest vibration.
func _play(tracker: HandTracker, synth: HapticSynth) -> float:
	tracker.start()
	var peak := 0.0
	for step in 300:
		tracker.advance(STEP_S)
		peak = maxf(peak, synth.get_amplitude())
	return peak
