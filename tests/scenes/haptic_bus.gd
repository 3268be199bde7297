extends "support/scene_test.gd"
## The vibration on an audio bus, as the audio thread mixes it.

const HeardSpring := preload("support/heard_spring.gd")
const Rig := preload("support/rig.gd")
const Waveform := preload("support/waveform.gd")

const FREQUENCY_HZ := 180.0
const LEVEL := 0.5
const HEARD_S := 0.5
## Below 24 bits.
const SILENCE := 1e-7

var _spring: HeardSpring


func test_the_bus_carries_the_vibration() -> void:
	_build()
	var samples := await _listen(LEVEL)
	var rate_hz := AudioServer.get_mix_rate()
	check_near(
		Waveform.amplitude_at(samples, rate_hz, FREQUENCY_HZ), LEVEL, 0.02, "amplitude at 180 Hz"
	)
	check_near(Waveform.peak(samples), LEVEL, 0.01, "peak")
	var greatest := LEVEL * TAU * FREQUENCY_HZ / rate_hz
	check(Waveform.greatest_step(samples) < 1.02 * greatest, "no click")


func test_a_change_of_level_does_not_click() -> void:
	var samples := await _listen(0.1 * LEVEL, 0.0)
	var greatest := LEVEL * TAU * FREQUENCY_HZ / AudioServer.get_mix_rate()
	check(Waveform.peak(samples) > 0.5 * LEVEL, "the change is audible")
	check(Waveform.greatest_step(samples) < 1.1 * greatest, "no step above the waveform's own")


func test_rest_is_silent() -> void:
	check(Waveform.peak(await _listen(0.0)) < 1e-4, "silence without motion")


func test_a_tracker_that_stops_is_silent() -> void:
	await _listen(LEVEL)
	await create_timer(1.5).timeout
	var capture := _spring.capture
	var samples := capture.get_buffer(capture.get_frames_available())
	check(samples.size() > 0 and samples[-1] == Vector2.ZERO, "silence without frames")
	_spring.free_nodes()


func test_a_live_tap_is_an_impulse_from_its_first_sample_on() -> void:
	var folder := DirAccess.create_temp("steadyhand_bus")
	var trials := Rig.write_trials(folder.get_current_dir(), 1, "tap")
	var rig := Rig.new(trials.get_trial(0), trials.get_measured_path(0), root)
	var synth := HapticSynth.new()
	synth.gesture_hmm = rig.gesture_hmm
	synth.bus = HeardSpring.BUS
	root.add_child(synth)
	var capture := _spring.capture
	capture.clear_buffer()
	rig.tracker.update_mode = HandTracker.UPDATE_IDLE
	rig.tracker.start()
	var heard := PackedFloat32Array()
	while not rig.tracker.is_finished():
		await process_frame
		for frame in capture.get_buffer(capture.get_frames_available()):
			heard.append(frame.x)
	synth.free()
	rig.free_nodes()
	var first := 0
	while first < heard.size() and absf(heard[first]) < SILENCE:
		first += 1
	check(first < heard.size() - 2000, "the tap is felt")
	# The sample at phase 0 is 0.
	var rate_hz := AudioServer.get_mix_rate()
	var t := 1.0 / rate_hz
	var peak := heard[first] / (exp(-200.0 * t) * sin(TAU * 300.0 * t))
	var error := 0.0
	for i in 1500:
		t = (i + 1) / rate_hz
		var truth := peak * exp(-200.0 * t) * sin(TAU * 300.0 * t)
		error = maxf(error, absf(heard[first + i] - truth))
	check(peak > 0.1 and peak < 1.0, "M is the speed: %s" % peak)
	check(error < 1e-4, "M exp(-N t) sin(2 pi f t), within %s" % error)
	check_equal(Waveform.peak(heard.slice(first + 2000)), 0.0, "silence after it")


func _build() -> void:
	AudioServer.add_bus()
	var bus := AudioServer.bus_count - 1
	AudioServer.set_bus_name(bus, HeardSpring.BUS)
	_spring = HeardSpring.new(self, bus)


## Half a second of the bus's left channel while the hand is held at `level` (share of the task's
## amplitude), from `settling_s` after now on.
func _listen(level: float, settling_s: float = 0.3) -> PackedFloat32Array:
	await _spring.settle(level, settling_s)
	var samples := await _spring.record(level, HEARD_S)
	var wanted := int(HEARD_S * AudioServer.get_mix_rate())
	samples.resize(mini(wanted, samples.size()))
	check_equal(samples.size(), wanted, "the bus is mixed in real time")
	return samples
