extends "support/scene_test.gd"
## Displays of the vibration: the inspector's preview of an effect, and the strip in a game.

const EffectPreview := preload("res://addons/steadyhand/editor/effect_preview.gd")
const PushedHand := preload("support/pushed_hand.gd")
const Rig := preload("support/rig.gd")
const Waveform := preload("support/waveform.gd")

const RATE_HZ := 8000

var _folder := DirAccess.create_temp("steadyhand_seen")


func test_a_preview_has_the_effect_s_own_frequency() -> void:
	var frequencies := PackedFloat32Array()
	for frequency in range(20, 600, 2):
		frequencies.append(frequency)
	var spring := SpringEffect.new()
	for frequency_hz: float in [60.0, 180.0, 320.0]:
		spring.frequency = frequency_hz
		var spectrum := spring.get_preview_spectrum(frequencies)
		var highest := 0
		for i in spectrum.size():
			highest = i if spectrum[i] > spectrum[highest] else highest
		check_near(frequencies[highest], frequency_hz, 2.0, "the spectrum's peak")


func test_a_preview_is_as_strong_as_the_effect() -> void:
	var spring := SpringEffect.new()
	spring.drive = HapticEffect.DRIVE_CONSTANT
	spring.trigger = HapticEffect.TRIGGER_ALWAYS
	spring.gain = 0.4
	var samples := spring.get_preview(RATE_HZ)
	check_equal(samples.size(), int(1.2 * RATE_HZ), "1.2 s")
	check_near(Waveform.peak(samples), 0.4, 1e-3, "its gain")
	var impulse := ImpulseEffect.new().get_preview(48000)
	var first := 0
	while is_zero_approx(impulse[first]):
		first += 1
	check_near(first / 48000.0, _arrival_s(), 1e-4, "the impulse comes at the arrival")


func test_a_preview_of_a_wrong_rate_is_refused() -> void:
	# expects error: SpringEffect: the sample rate must be 8000..192000 Hz
	check_equal(SpringEffect.new().get_preview(1000).size(), 0, "nothing")


func test_the_inspector_s_preview_follows_the_effect() -> void:
	var spring := SpringEffect.new()
	var preview := EffectPreview.new()
	preview.size = Vector2(300, 170)
	preview.effect = spring
	root.add_child(preview)
	var drawn := [0]
	preview.draw.connect(func() -> void: drawn[0] += 1)
	await process_frame
	await process_frame
	check(drawn[0] > 0, "drawn")
	drawn[0] = 0
	spring.gain = 0.5
	await process_frame
	await process_frame
	check(drawn[0] > 0, "drawn again after a change")
	preview.effect = null
	spring.gain = 1.0
	preview.free()


func test_the_strip_draws_the_vibration() -> void:
	var trials := Rig.write_trials(_folder.get_current_dir(), 1, "horizontal_drag")
	var rig := Rig.new(trials.get_trial(0), trials.get_measured_path(0), root)
	var synth := HapticSynth.new()
	synth.gesture_hmm = rig.gesture_hmm
	var strip := HapticStrip.new()
	strip.synth = synth
	strip.seconds = 10.0
	strip.size = Vector2(300, 40)
	for node: Node in [synth, strip]:
		root.add_child(node)
	rig.tracker.start()
	var felt := 0.0
	while not rig.tracker.is_finished():
		rig.tracker.advance(0.01)
		strip.note()
		felt = maxf(felt, synth.get_amplitude())
	check(felt > 0.8, "there is something to draw: %s" % felt)
	check_near(strip.get_greatest(), felt, 1e-6, "and it is drawn")
	await process_frame
	for node: Node in [strip, synth]:
		node.free()
	rig.free_nodes()


## When the movement of the previews is at 95 %, by bisection.
static func _arrival_s() -> float:
	var low := 0.0
	var high := 1.0
	for i in 50:
		var s := 0.5 * (low + high)
		if PushedHand.share(s) < 0.95:
			low = s
		else:
			high = s
	return 0.8 * high
