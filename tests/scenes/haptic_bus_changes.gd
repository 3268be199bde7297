extends "support/scene_test.gd"
## Audio buses that come, go and change their names while a spring is held.

const Rig := preload("support/rig.gd")
const Waveform := preload("support/waveform.gd")

const BUS := &"Wristband"
const LEVEL := 0.5
const SETTLING_S := 0.3
const HEARD_S := 0.2
const PATIENCE_S := 10.0

var _tracker := HandTracker.new()
var _task := GestureTask.new()
var _gesture_hmm := GestureHMM.new()
var _synth := HapticSynth.new()
var _capture := AudioEffectCapture.new()


func test_a_bus_that_comes_later_is_played_on() -> void:
	# expects error: HapticSynth: there is no audio bus 'Wristband'; nothing is played
	_build()
	check_equal(await _heard(), 0.0, "nothing without it")
	AudioServer.add_bus()
	check_equal(await _heard(), 0.0, "nor on another")
	AudioServer.set_bus_name(AudioServer.bus_count - 1, BUS)
	check_near(await _heard(), LEVEL, 0.01, "on it once it has the name")


func test_a_bus_of_another_name_is_none() -> void:
	var bus := AudioServer.get_bus_index(BUS)
	AudioServer.set_bus_name(bus, "Other")
	check_equal(await _heard(), 0.0, "nothing on Master")
	AudioServer.set_bus_name(bus, BUS)
	check_near(await _heard(), LEVEL, 0.01, "the name is back")


func test_a_bus_that_is_removed_leaves_nothing_on_master() -> void:
	AudioServer.remove_bus(AudioServer.get_bus_index(BUS))
	check_equal(await _heard(), 0.0, "while it plays")
	AudioServer.add_bus()
	AudioServer.set_bus_name(AudioServer.bus_count - 1, BUS)
	check_near(await _heard(), LEVEL, 0.01, "a new one of the name")
	root.remove_child(_synth)
	await _heard()
	AudioServer.remove_bus(AudioServer.get_bus_index(BUS))
	root.add_child(_synth)
	check_equal(await _heard(0.0), 0.0, "while the synth is out of the tree")


func test_a_layout_without_the_bus() -> void:
	var layout := AudioServer.generate_bus_layout()
	AudioServer.add_bus()
	AudioServer.set_bus_name(AudioServer.bus_count - 1, BUS)
	check_near(await _heard(), LEVEL, 0.01, "on the bus")
	var with_bus := AudioServer.generate_bus_layout()
	AudioServer.set_bus_layout(layout)
	check_equal(await _heard(), 0.0, "nothing on Master")
	AudioServer.set_bus_layout(with_bus)
	check_near(await _heard(), LEVEL, 0.01, "a layout that has it")
	for node: Node in [_synth, _gesture_hmm, _task, _tracker]:
		node.free()


func _build() -> void:
	_capture.buffer_length = 2.0
	AudioServer.add_bus_effect(0, _capture)
	_tracker.update_mode = HandTracker.UPDATE_MANUAL
	_task.gesture = &"horizontal_drag"
	_gesture_hmm.models = [load(Rig.MODEL % "horizontal_drag") as GestureModel]
	_gesture_hmm.tracker = _tracker
	_gesture_hmm.task = _task
	_gesture_hmm.motion = GestureHMM.MOTION_MEASURED
	_synth.gesture_hmm = _gesture_hmm
	var spring := SpringEffect.new()
	spring.trigger = HapticEffect.TRIGGER_ALWAYS
	_synth.effects = [spring]
	_synth.bus = BUS
	for node: Node in [_tracker, _task, _gesture_hmm, _synth]:
		root.add_child(node)


## Peak of what comes out of Master.
func _heard(settling_s: float = SETTLING_S) -> float:
	var began_s := _now_s()
	while _now_s() - began_s < settling_s:
		await _hold()
	if settling_s > 0.0:
		_capture.clear_buffer()
	var wanted := int(HEARD_S * AudioServer.get_mix_rate())
	while _capture.get_frames_available() < wanted and _now_s() - began_s < PATIENCE_S:
		await _hold()
	var samples := PackedFloat32Array()
	for frame in _capture.get_buffer(_capture.get_frames_available()):
		samples.append(frame.x)
	check(samples.size() >= wanted, "Master is mixed in real time")
	return Waveform.peak(samples)


func _hold() -> void:
	var tip := Vector3(LEVEL * _task.amplitude, 0, 0)
	_tracker.push_frame(_now_s(), {HandTracker.JOINT_INDEX: tip})
	await process_frame


static func _now_s() -> float:
	return 1e-6 * Time.get_ticks_usec()
