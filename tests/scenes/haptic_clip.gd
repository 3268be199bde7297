extends "support/scene_test.gd"
## Clips: designed vibrations from files, as effects, and back into files.

const Rig := preload("support/rig.gd")
const Waveform := preload("support/waveform.gd")

const RATE_HZ := 48000
const LAST_STEP := 2400
const LIVE_STEP_S := 0.01
const LIVE_STEPS := 240
const CLIP := """{ "version": { "major": 1, "minor": 0, "patch": 0 }, "metadata": {},
	"signals": { "continuous": { "envelopes": {
		"amplitude": [ { "time": 0, "amplitude": %s }, { "time": 0.2, "amplitude": 0.5 } ],
		"frequency": [ { "time": 0, "frequency": 1 } ] } } } }"""
const PATTERN := """{ "Version": 1.0, "Pattern": [ { "Event": { "Time": 0.05,
	"EventType": "HapticTransient", "EventParameters": [
		{ "ParameterID": "HapticSharpness", "ParameterValue": 1 } ] } } ] }"""

var _folder := DirAccess.create_temp("steadyhand_clip")
## On the tracker's clock: the first sample, and gesture_started.
var _began_s := NAN
var _started_s := NAN


func test_a_file_loads_as_an_effect() -> void:
	var clip := load(_write("plain.haptic", CLIP % "0.5")) as HapticEffect as HapticClip
	check(clip != null, "it is a HapticClip")
	check_near(clip.duration, 0.2, 1e-9, "its duration")
	check_near(clip.get_amplitude_at(0.1), 0.5, 1e-9, "its amplitude")
	check_near(clip.get_frequency_at(0.1), 200.0, 1e-9, "its frequency")
	var pattern: HapticClip = load(_write("tap.ahap", PATTERN))
	check_equal(pattern.get_transient_count(), 1, "a transient")
	check_near(pattern.duration, 0.05 + 2.0 / 165.0, 1e-9, "two periods of 165 Hz")


func test_a_bad_file_gets_one_error_with_its_line() -> void:
	# expects error: bad.haptic:3: amplitude: not within 0 .. 1
	# expects error: cut.ahap:2: not valid JSON: the file ends here
	# expects error: there is no such file
	check(HapticClip.load_file(_write("bad.haptic", CLIP % "1.5")) == null, "a bad number")
	check(HapticClip.load_file(_write("cut.ahap", PATTERN.left(90))) == null, "a cut file")
	check(HapticClip.load_file(_path("none.haptic")) == null, "no file")


func test_a_saved_clip_keeps_its_settings() -> void:
	var clip := HapticClip.load_file(_write("once.haptic", CLIP % "0.5"))
	clip.trigger = HapticEffect.TRIGGER_MOVING
	clip.drive = HapticEffect.DRIVE_POSITION
	clip.gain = 0.25
	clip.highest_frequency = 300.0
	check_equal(ResourceSaver.save(clip, _path("saved.haptic")), OK, "saved")
	var again: HapticClip = ResourceLoader.load(_path("saved.haptic"), "HapticClip")
	check_equal(again.to_text(), clip.to_text(), "the same text")
	check_equal(again.trigger, HapticEffect.TRIGGER_MOVING, "its trigger")
	check_equal(again.gain, 0.25, "its gain")
	check_near(again.get_frequency_at(0.0), 300.0, 1e-9, "its range")
	check_equal((clip.duplicate() as HapticClip).to_text(), clip.to_text(), "a duplicate")
	check_equal(ResourceSaver.save(clip, _path("in_a.tres")), OK, "inside a resource")
	var inside: HapticClip = load(_path("in_a.tres"))
	check_equal(inside.to_text(), clip.to_text(), "the same there")


func test_an_empty_clip_is_not_saved() -> void:
	# expects error: empty.haptic: this HapticClip is empty; load or record one first
	check(ResourceSaver.save(HapticClip.new(), _path("empty.haptic")) != OK, "refused")
	check(not FileAccess.file_exists(_path("empty.haptic")), "no file is made")


func test_bad_ranges_are_refused() -> void:
	# expects error: HapticClip: lowest_frequency must be 1.0..1000.0
	var clip := HapticClip.new()
	for number: float in [0.0, 1e9, -1.0, INF, NAN]:
		clip.lowest_frequency = number
	check_equal(clip.lowest_frequency, 55.0, "it stays")
	clip.lowest_frequency = 300.0
	clip.highest_frequency = 400.0
	check_equal(clip.lowest_frequency, 300.0, "in any order")


func test_a_clip_is_played_at_the_contact() -> void:
	var clip := HapticClip.load_file(_write("contact.haptic", CLIP % "0.5"))
	clip.gain = 0.5
	var samples := _play(clip)
	var expected := clip.get_waveform(RATE_HZ)
	var first := 0
	while first < samples.size() and samples[first] == 0.0:
		first += 1
	# The first sample of a sine is 0.
	var worst := 0.0
	for i in expected.size() - 1:
		worst = maxf(worst, absf(samples[first - 1 + i] - 0.5 * expected[i]))
	check(worst < 1e-3, "every sample of the clip, within %s" % worst)
	check_equal(Waveform.peak(samples.slice(first + expected.size())), 0.0, "then silence")


func test_a_clip_is_played_at_the_start_of_a_gesture() -> void:
	var clip := HapticClip.load_file(_write("start.haptic", CLIP % "0.5"))
	clip.trigger = HapticEffect.TRIGGER_START
	var samples := _play(clip)
	var expected := clip.get_waveform(RATE_HZ)
	var first := roundi((_started_s - _began_s) * RATE_HZ)
	var worst := 0.0
	for i in expected.size():
		worst = maxf(worst, absf(samples[first + i] - expected[i]))
	check(worst < 1e-3, "every sample of the clip from gesture_started on, within %s" % worst)
	check_equal(Waveform.peak(samples.slice(0, first)), 0.0, "silence before it")
	check_equal(Waveform.peak(samples.slice(first + expected.size() + 1)), 0.0, "and after")
	var again: HapticClip = clip.duplicate()
	check_equal(again.trigger, HapticEffect.TRIGGER_START, "a copy is played at the start too")


func test_a_clip_at_the_start_is_played_live() -> void:
	var clip := HapticClip.load_file(_write("live.haptic", CLIP % "0.5"))
	clip.trigger = HapticEffect.TRIGGER_START
	var trials := Rig.write_trials(_folder.get_current_dir(), 1, "tap")
	var rig := Rig.new(trials.get_trial(0), trials.get_measured_path(0), root)
	var synth := HapticSynth.new()
	synth.gesture_hmm = rig.gesture_hmm
	synth.effects = [clip]
	root.add_child(synth)
	_watch_start(rig)
	rig.tracker.start()
	var heard_s := NAN
	var plays := 0
	for step in range(ceili(rig.tracker.get_start_time() / LIVE_STEP_S), LIVE_STEPS):
		rig.tracker.advance_to(step * LIVE_STEP_S)
		var is_loud := false
		for sample in synth.get_buffer(roundi(LIVE_STEP_S * RATE_HZ)):
			is_loud = is_loud or absf(sample.x) > 0.1
		if is_loud and is_nan(heard_s):
			heard_s = step * LIVE_STEP_S
		plays += int(is_loud)
	check(
		heard_s - _started_s < 0.05,
		"within 50 ms of the start at %s s: at %s s" % [_started_s, heard_s]
	)
	check_near(plays * LIVE_STEP_S, clip.duration, 2.0 * LIVE_STEP_S, "once")
	synth.free()
	rig.free_nodes()


func test_a_played_motion_becomes_a_clip() -> void:
	var spring := SpringEffect.new()
	spring.drive = HapticEffect.DRIVE_CONSTANT
	spring.trigger = HapticEffect.TRIGGER_ALWAYS
	spring.gain = 0.6
	_play(spring)
	var clip := HapticClip.from_wav(_path("tap.wav"))
	check_near(clip.get_amplitude_at(0.5 * clip.duration), 0.6, 0.021, "its amplitude")
	check_near(clip.get_frequency_at(0.5 * clip.duration), 180.0, 3.0, "its frequency")
	check_equal(ResourceSaver.save(clip, _path("played.haptic")), OK, "saved")
	var read := HapticClip.load_file(_path("played.haptic"))
	var middle := read.get_waveform(RATE_HZ).slice(RATE_HZ / 2, RATE_HZ)
	check_near(Waveform.peak(middle), 0.6, 0.021, "rendered again")


func test_an_effect_becomes_a_clip_and_a_wav() -> void:
	var impulse := ImpulseEffect.new()
	var clip := HapticClip.from_waveform(impulse.get_preview(RATE_HZ), RATE_HZ)
	check_equal(clip.get_transient_count(), 1, "an impulse is a transient")
	check_equal(impulse.save_preview_wav(_path("impulse.wav"), RATE_HZ), OK, "saved")
	var samples := Waveform.read_wav(_path("impulse.wav"), RATE_HZ)
	var preview := impulse.get_preview(RATE_HZ)
	check_equal(samples.size(), preview.size(), "all samples")
	check_near(Waveform.peak(samples), Waveform.peak(preview), 1e-4, "as strong")


func _path(name: String) -> String:
	return _folder.get_current_dir().path_join(name)


func _write(name: String, text: String) -> String:
	var file := FileAccess.open(_path(name), FileAccess.WRITE)
	file.store_string(text)
	file.close()
	return _path(name)


func _watch_start(rig: Rig) -> void:
	rig.gesture_hmm.gesture_started.connect(
		func(_gesture: StringName, _task: GestureTask) -> void: _started_s = rig.gesture_hmm.time
	)


## A tap through the nodes, into tap.wav.
func _play(effect: HapticEffect) -> PackedFloat32Array:
	var trials := Rig.write_trials(_folder.get_current_dir(), 1, "tap")
	var rig := Rig.new(trials.get_trial(0), trials.get_measured_path(0), root)
	var synth := HapticSynth.new()
	synth.gesture_hmm = rig.gesture_hmm
	synth.effects = [effect]
	synth.wav_path = _path("tap.wav")
	root.add_child(synth)
	_watch_start(rig)
	rig.tracker.start()
	var first_step := ceili(rig.tracker.get_start_time() / Rig.STEP_S)
	_began_s = first_step * Rig.STEP_S
	for step in range(first_step, LAST_STEP + 1):
		rig.tracker.advance_to(step * Rig.STEP_S)
	synth.stop_wav()
	synth.free()
	rig.free_nodes()
	return Waveform.read_wav(_path("tap.wav"), RATE_HZ)
