# engine options: --fixed-fps 90
extends "support/scene_test.gd"
## Typical mistakes in a game's scene each give one warning that says what to do.

const Rig := preload("support/rig.gd")

const OVERLAY := preload("res://addons/steadyhand/debug_overlay.tscn")
const PLACE := Vector3(0.0, 1.0, -0.3)

var _folder := DirAccess.create_temp("steadyhand_mistakes")


func test_a_short_repeated_recording_in_a_wrong_direction_is_warned_of() -> void:
	# expects one warning: the hand leaves its start towards
	await _play_repeated_drag(PLACE, Vector3.LEFT, "index")


func test_a_short_repeated_recording_far_from_the_task_is_warned_of() -> void:
	# expects one warning: the fingertip has come no nearer to its start than 0.5
	await _play_repeated_drag(PLACE + Vector3(0.0, 0.5, 0.0), Vector3.RIGHT, "index")


func test_a_short_repeated_recording_of_another_joint_is_warned_of() -> void:
	# expects one warning: 'horizontal_drag' is not recognised. It needs index; no frame had index
	await _play_repeated_drag(PLACE, Vector3.RIGHT, "ring")


func test_a_tracker_that_is_not_in_the_scene_is_warned_of() -> void:
	# expects one warning: It is not in the scene. Add it by add_child()
	var tracker := HandTracker.new()
	tracker.source = SyntheticSource.new()
	var hmm := _drag_hmm()
	hmm.tracker = tracker
	root.add_child(hmm)
	var overlay: Node = OVERLAY.instantiate()
	root.add_child(overlay)
	await create_timer(10.0).timeout
	var shown: String = overlay.describe_gesture()
	check_equal(shown, "The HandTracker is not in the scene: add it by add_child().", "overlay")
	root.add_child(tracker)
	await create_timer(0.5).timeout
	check(tracker.is_hand_tracked(), "once added, the tracker runs")
	for node: Node in [overlay, hmm, tracker]:
		node.free()


func test_an_empty_effect_is_warned_of_once_in_several_gestures() -> void:
	# expects one warning: "effects"[0] is null and plays nothing
	var tracker := HandTracker.new()
	tracker.source = load("res://addons/steadyhand/samples/repeated_drag.tres")
	var hmm := _drag_hmm()
	var ended := [0]
	hmm.gesture_ended.connect(
		func(_name: StringName, _s: float, _task: GestureTask, _share: float) -> void: ended[0] += 1
	)
	var synth := HapticSynth.new()
	synth.bus = &"Master"
	synth.effects = [null]
	root.add_child(tracker)
	tracker.add_child(hmm)
	hmm.add_child(synth)
	await create_timer(12.0).timeout
	check(ended[0] >= 3, "%d gestures end" % ended[0])
	tracker.free()


## Plays a drag of 1.5 s at 90 Hz for 20 s. The task is at PLACE and leads to the right.
func _play_repeated_drag(start: Vector3, direction: Vector3, joint: String) -> void:
	var source := RecordedSource.new()
	source.track = _folder.get_current_dir().path_join(joint + ".csv")
	source.loop = true
	var file := FileAccess.open(source.track, FileAccess.WRITE)
	file.store_line("t,%s_x,%s_y,%s_z" % [joint, joint, joint])
	for frame in 135:
		var way := 0.2 * smoothstep(45.0, 105.0, frame) + 1e-4 * sin(2.0 * frame)
		var place := start + way * direction
		file.store_line("%.6f,%.6f,%.6f,%.6f" % [frame / 90.0, place.x, place.y, place.z])
	file.close()
	var tracker := HandTracker.new()
	tracker.source = source
	var task := GestureTask.new()
	task.gesture = &"horizontal_drag"
	task.position = PLACE
	var hmm := _drag_hmm()
	hmm.tasks = [task]
	root.add_child(task)
	root.add_child(tracker)
	tracker.add_child(hmm)
	await create_timer(20.0).timeout
	check(hmm.recognised.is_empty(), "no gesture ends")
	for node: Node in [tracker, task]:
		node.free()


func _drag_hmm() -> GestureHMM:
	var hmm := GestureHMM.new()
	hmm.models = [load(Rig.MODEL % "horizontal_drag") as GestureModel]
	return hmm
