extends "support/scene_test.gd"
## The vibration on an audio bus, as the audio thread mixes it.

const Waveform := preload("support/waveform.gd")

const FREQUENCY_HZ := 180.0
const LEVEL := 0.5
const BUS := "Wristband"
const HEARD_S := 0.5
const PATIENCE_MS := 10000

var _tracker := HandTracker.new()
var _task := GestureTask.new()
var _gesture_hmm := GestureHMM.new()
var _synth := HapticSynth.new()
var _capture := AudioEffectCapture.new()
var _time_s := 0.0


func test_the_bus_carries_the_vibration() -> void:
	_build()
	_hold(LEVEL * _task.amplitude)
	var samples := await _listen()
	var rate_hz := AudioServer.get_mix_rate()
	check_near(
		Waveform.amplitude_at(samples, rate_hz, FREQUENCY_HZ), LEVEL, 0.02, "amplitude at 180 Hz"
	)
	check_near(Waveform.peak(samples), LEVEL, 0.02, "peak")
	var greatest := LEVEL * TAU * FREQUENCY_HZ / rate_hz
	check(Waveform.greatest_step(samples) < 1.02 * greatest, "no click")


func test_a_change_of_level_does_not_click() -> void:
	_capture.clear_buffer()
	_hold(0.1 * _task.amplitude)
	var samples := await _listen()
	var greatest := LEVEL * TAU * FREQUENCY_HZ / AudioServer.get_mix_rate()
	check(Waveform.greatest_step(samples) < 1.1 * greatest, "no step above the waveform's own")


func test_rest_is_silent() -> void:
	_hold(0.0)
	await _listen()
	_capture.clear_buffer()
	check(Waveform.peak(await _listen()) < 1e-4, "nothing where nothing moves")
	for node: Node in [_synth, _gesture_hmm, _task, _tracker]:
		node.free()


func _build() -> void:
	AudioServer.add_bus()
	var bus := AudioServer.bus_count - 1
	AudioServer.set_bus_name(bus, BUS)
	_capture.buffer_length = 2.0
	AudioServer.add_bus_effect(bus, _capture)
	_tracker.source = HandTracker.SOURCE_SCRIPT
	_tracker.update_mode = HandTracker.UPDATE_MANUAL
	_task.gesture = &"horizontal_drag"
	_gesture_hmm.models = [load("res://addons/steadyhand/models/horizontal_drag.gesture")]
	_gesture_hmm.tracker = _tracker
	_gesture_hmm.task = _task
	_gesture_hmm.motion = GestureHMM.MOTION_MEASURED
	_synth.gesture_hmm = _gesture_hmm
	_synth.frequency = FREQUENCY_HZ
	_synth.bus = BUS
	for node: Node in [_tracker, _task, _gesture_hmm, _synth]:
		root.add_child(node)
	_tracker.start()


## Lets the hand be there, at that distance from the start, for a while of its own time.
func _hold(distance_m: float) -> void:
	for frame in 20:
		_time_s += 0.01
		_tracker.push_frame(_time_s, {HandTracker.JOINT_INDEX: Vector3(distance_m, 0, 0)})


## Half a second of the bus's left channel, from a while after now on: the audio thread mixes in
## real time.
func _listen() -> PackedFloat32Array:
	await create_timer(0.2).timeout
	_capture.clear_buffer()
	var wanted := int(HEARD_S * AudioServer.get_mix_rate())
	var began_ms := Time.get_ticks_msec()
	while (
		_capture.get_frames_available() < wanted and Time.get_ticks_msec() - began_ms < PATIENCE_MS
	):
		await process_frame
	var samples := PackedFloat32Array()
	for frame in _capture.get_buffer(mini(wanted, _capture.get_frames_available())):
		samples.append(frame.x)
	check_equal(samples.size(), wanted, "the bus is mixed in real time")
	return samples
