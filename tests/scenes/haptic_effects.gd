extends "support/scene_test.gd"
## The vibration of a gesture: its effects, each from its exact sample on.

const Rig := preload("support/rig.gd")
const Waveform := preload("support/waveform.gd")

const RATE_HZ := 48000
const LAST_STEP := 2400
## Share of the amplitude at which a motion has arrived.
const ARRIVED := 0.95

var _folder := DirAccess.create_temp("steadyhand_effects")


func test_a_drag_is_a_spring_and_a_cue_from_its_end_on() -> void:
	var played := _play("horizontal_drag", [])
	var samples: PackedFloat32Array = played["samples"]
	var arrival: int = played["arrival"]
	check(arrival > 0, "the drag arrives")
	var before := samples.slice(arrival - RATE_HZ / 20, arrival)
	check(Waveform.peak(before) > 0.8, "the spring is stretched: %s" % Waveform.peak(before))
	var cue := samples.slice(arrival + RATE_HZ / 50, arrival + RATE_HZ / 25)
	var level := Waveform.amplitude_at(cue, RATE_HZ, 180.0)
	check(
		level > 0.45 and level < 0.8, "0.5 from the constant speed, more from the hand: %s" % level
	)
	check_equal(Waveform.peak(samples.slice(arrival + int(0.062 * RATE_HZ))), 0.0, "then silence")
	var bound := 2.0 * sin(PI * 180.0 / RATE_HZ)
	# While the spring fades the cue swells, and both are heard.
	check(Waveform.greatest_step(samples) < 1.5 * bound, "no click")


func test_a_tap_is_an_impulse_from_the_sample_of_the_contact_on() -> void:
	var played := _play("tap", [])
	var samples: PackedFloat32Array = played["samples"]
	var arrival: int = played["arrival"]
	check_equal(Waveform.peak(samples.slice(0, arrival - 1)), 0.0, "silence before the contact")
	var peak: float = played["speed"]
	var worst := INF
	# The value between two instants is known to a sample.
	for first: int in [arrival - 1, arrival, arrival + 1]:
		var error := 0.0
		for i in RATE_HZ / 30:
			var t := float(i) / RATE_HZ
			var truth := peak * exp(-200.0 * t) * sin(TAU * 300.0 * t)
			error = maxf(error, absf(samples[first + i] - truth))
		worst = minf(worst, error)
	check(worst < 0.01 * peak, "M exp(-N t) sin(2 pi f t), within %s of M = %s" % [worst, peak])
	check_equal(
		Waveform.peak(samples.slice(arrival + int(0.042 * RATE_HZ))), 0.0, "over after 40 ms"
	)


func test_more_than_eight_effects_are_warned_of() -> void:
	# expects warning: only the first 8 of 9 effects are played
	var effects: Array[HapticEffect] = []
	for i in 9:
		effects.append(SpringEffect.new())
	var synth := HapticSynth.new()
	synth.effects = effects
	check_equal(synth.effects.size(), 9, "all are kept")
	synth.free()


func test_effects_change_while_they_play_without_a_click() -> void:
	var spring := SpringEffect.new()
	spring.trigger = HapticEffect.TRIGGER_ALWAYS
	var other := SpringEffect.new()
	other.trigger = HapticEffect.TRIGGER_ALWAYS
	other.gain = 0.3
	var sets: Array[Array] = [[spring], [other], [], [spring]]
	var changes := func(synth: HapticSynth, step: int) -> void:
		if step % 37 == 0:
			var effects: Array[HapticEffect] = []
			effects.assign(sets[step / 37 % sets.size()])
			synth.effects = effects
		elif step % 101 == 0:
			spring.gain = 0.2 if spring.gain == 1.0 else 1.0
	var played := _play("horizontal_drag", [spring], changes)
	var bound := 2.0 * sin(PI * 180.0 / RATE_HZ)
	var greatest := Waveform.greatest_step(played["samples"]) / bound
	check(
		greatest > 0.3 and greatest < 1.02, "greatest step: %.3f of the waveform's own" % greatest
	)


func test_a_custom_waveform_is_played_at_the_arrival() -> void:
	var custom := CustomEffect.new()
	custom.trigger = HapticEffect.TRIGGER_ARRIVAL
	custom.drive = HapticEffect.DRIVE_CONSTANT
	custom.frequency = 2000.0
	custom.waveform_rate = 1000.0
	var waveform := PackedFloat32Array()
	waveform.resize(30)
	waveform.fill(-0.5)
	custom.waveform = waveform
	var played := _play("tap", [custom])
	var samples: PackedFloat32Array = played["samples"]
	var arrival: int = played["arrival"]
	var within := samples.slice(arrival + 50, arrival + int(0.028 * RATE_HZ))
	check_near(within[0], -0.5, 1e-3, "its level")
	check_near(within[-1], -0.5, 1e-3, "to its end")
	check_equal(Waveform.peak(samples.slice(arrival + int(0.03 * RATE_HZ))), 0.0, "then silence")


func test_an_effect_ends_in_time() -> void:
	# expects error: ImpulseEffect: decay must be 1.0..10000.0
	# expects error: InertialViscousEffect: duration must be 0.001..10.0
	# expects error: CustomEffect: duration must be 0.001..10.0
	# expects error: CustomEffect: waveform_rate must be 1000.0..192000.0
	var impulse := ImpulseEffect.new()
	var cue := InertialViscousEffect.new()
	var custom := CustomEffect.new()
	for number: float in [1e-300, 0.0, -1.0, 1e300, INF, NAN]:
		impulse.decay = number
		cue.duration = number
		custom.duration = number
		custom.waveform_rate = number
	check_equal(impulse.decay, 200.0, "the decay stays")
	check_equal(cue.duration, 0.06, "the duration of the cue stays")
	check_equal(custom.duration, 0.06, "a curve's")
	check_equal(custom.waveform_rate, 48000.0, "the rate of a waveform stays")
	cue.duration = 10.0
	check_equal(cue.duration, 10.0, "the longest duration is accepted")


func test_the_device_decides_frequency_and_strength() -> void:
	var device := HapticDeviceProfile.new()
	device.resonance = 175.0
	device.maximum_amplitude = 0.5
	var synth := HapticSynth.new()
	synth.device = device
	var played := _play("horizontal_drag", [], Callable(), synth)
	var samples: PackedFloat32Array = played["samples"]
	var arrival: int = played["arrival"]
	check_near(Waveform.peak(samples), 0.5, 1e-3, "limited to the device's maximum")
	var window := samples.slice(arrival - RATE_HZ / 25, arrival)
	var at_resonance := Waveform.amplitude_at(window, RATE_HZ, 175.0)
	check_near(at_resonance, 0.5, 0.02, "at its resonance")


func test_a_response_is_filled_in_point_by_point() -> void:
	# expects warning: HapticDeviceProfile: some points of "response" are left out
	var device := HapticDeviceProfile.new()
	var synth := HapticSynth.new()
	synth.device = device
	edited_scene_root = synth
	root.add_child(synth)
	var refreshed: Array[Node] = []
	var note := func(node: Node) -> void: refreshed.append(node)
	node_configuration_warning_changed.connect(note)
	var points := PackedVector2Array([Vector2(720, 0.2), Vector2(0, 0), Vector2(45, 1.0)])
	device.response = points
	check_equal(device.response, points, "as given")
	check_equal(refreshed, [synth] as Array[Node], "the synth's warnings are refreshed")
	node_configuration_warning_changed.disconnect(note)
	edited_scene_root = null
	root.remove_child(synth)
	var spring := SpringEffect.new()
	spring.drive = HapticEffect.DRIVE_CONSTANT
	spring.frequency = 180.0
	spring.gain = 0.3
	var played := _play("horizontal_drag", [spring], Callable(), synth)
	check_near(
		Waveform.peak(played["samples"]),
		0.3 / 0.6,
		5e-3,
		"0.6 half-way between the frequencies, in octaves"
	)


func test_a_script_takes_the_live_vibration() -> void:
	var spring := SpringEffect.new()
	spring.channels = 2
	var rig := _make_rig("horizontal_drag")
	var synth := _live_synth(rig, spring)
	var left := 0.0
	var right := 0.0
	for step in range(ceili(rig.tracker.get_start_time() / 0.016), 150):
		rig.tracker.advance_to(0.016 * step)
		for frame in synth.get_buffer(128):
			left = maxf(left, absf(frame.x))
			right = maxf(right, absf(frame.y))
	check_equal(left, 0.0, "nothing on the other channel")
	check(right > 0.9 and right <= 1.0, "the spring: %s" % right)
	synth.free()
	rig.free_nodes()


func test_a_stopped_game_is_silent() -> void:
	var spring := SpringEffect.new()
	spring.drive = HapticEffect.DRIVE_CONSTANT
	var rig := _make_rig("horizontal_drag")
	var synth := _live_synth(rig, spring)
	var peaks := PackedFloat32Array()
	for step in 100:
		# As a frame of a game does at an Engine.time_scale of 1, and then of 0.
		rig.tracker.advance(0.016 if step < 50 else 0.0)
		var samples := PackedFloat32Array()
		for frame in synth.get_buffer(128):
			samples.append(frame.x)
		peaks.append(Waveform.peak(samples))
	check(peaks[49] > 0.9, "vibration while time advances: %s" % peaks[49])
	check_equal(peaks[99], 0.0, "silence 0.8 s after time has stopped")
	synth.free()
	rig.free_nodes()


func _make_rig(gesture: String) -> Rig:
	var trials := Rig.write_trials(_folder.get_current_dir(), 1, gesture)
	return Rig.new(trials.get_trial(0), trials.get_measured_path(0), root)


## Always felt, and taken at 8 kHz; the rig's tracker is started.
func _live_synth(rig: Rig, spring: SpringEffect) -> HapticSynth:
	spring.trigger = HapticEffect.TRIGGER_ALWAYS
	var synth := HapticSynth.new()
	synth.gesture_hmm = rig.gesture_hmm
	synth.effects = [spring]
	synth.buffer_sample_rate = 8000
	root.add_child(synth)
	rig.tracker.start()
	return synth


## A trial through the nodes and into a file. Of the result, `arrival` is the number of the first
## sample at or after the arrival, `speed` the hand's there, m/s.
func _play(
	gesture: String,
	effects: Array[HapticEffect],
	each: Callable = Callable(),
	synth := HapticSynth.new()
) -> Dictionary:
	var rig := _make_rig(gesture)
	var wav_path := _folder.get_current_dir().path_join("%s.wav" % gesture)
	synth.gesture_hmm = rig.gesture_hmm
	synth.effects = effects
	synth.wav_path = wav_path
	root.add_child(synth)
	rig.tracker.start()
	var first := ceili(rig.tracker.get_start_time() / Rig.STEP_S)
	var before := 0.0
	var arrival_s := -1.0
	var speed := 0.0
	for step in range(first, LAST_STEP + 1):
		if each.is_valid():
			each.call(synth, step)
		rig.tracker.advance_to(step * Rig.STEP_S)
		var position := rig.gesture_hmm.value / rig.task.amplitude
		if arrival_s < 0.0 and position >= ARRIVED:
			var share := (ARRIVED - before) / (position - before)
			arrival_s = (step - 1 + share) * Rig.STEP_S
			speed = rig.gesture_hmm.velocity
		before = position
	synth.stop_wav()
	synth.free()
	rig.free_nodes()
	return {
		samples = Waveform.read_wav(wav_path, RATE_HZ),
		arrival = ceili((arrival_s - first * Rig.STEP_S) * RATE_HZ),
		speed = speed,
	}
