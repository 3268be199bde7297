extends "support/scene_test.gd"
## The vibration as a WAV file, on the motion's own clock at any speed.

const Rig := preload("support/rig.gd")
const ScenePlayer := preload("res://tools/scene_player.gd")
const Tasks := preload("res://scripts/tasks.gd")
const Waveform := preload("support/waveform.gd")

const RATE_HZ := 48000
const FREQUENCY_HZ := 180.0
## Whole periods of the vibration and whole milliseconds.
const WINDOW_STEPS := 50
const LAST_STEP := 2400
## Between switches of the condition: not a whole number of periods.
const SWITCH_STEPS := 41

var _folder := DirAccess.create_temp("steadyhand_wav")
var _trials := Rig.write_trials(_folder.get_current_dir())


func test_vibration_follows_the_motion() -> void:
	var wav_path := _folder.get_current_dir().path_join("vibration.wav")
	var rig := Rig.new(_trials.get_trial(0), _trials.get_measured_path(0), root)
	var synth := _make_synth(rig, wav_path)
	var values := rig.record(_first_step(rig), LAST_STEP)
	check_near(synth.get_amplitude(), 1.0, 0.1, "the amplitude at the end of the drag")
	synth.stop_wav()
	synth.free()
	var amplitude_m := rig.task.amplitude
	rig.free_nodes()

	var samples := Waveform.read_wav(wav_path, RATE_HZ)
	var per_step := RATE_HZ * Rig.STEP_S
	var steps := values.size() / Rig.MOTIONS.size() - 1
	check_near(samples.size() / per_step, steps, 1.0, "length in ms")
	var greatest := TAU * FREQUENCY_HZ / RATE_HZ
	check(Waveform.greatest_step(samples) < 1.02 * greatest, "no step above the waveform's own")
	_check_spectrum(samples.slice(samples.size() - int(WINDOW_STEPS * per_step)))
	_check_envelope(samples, values, amplitude_m)


func test_a_scene_gives_the_times_of_its_wav_and_cue() -> void:
	var logs := _folder.get_current_dir().path_join("logs")
	var wav_path := _folder.get_current_dir().path_join("played.wav")
	var player := ScenePlayer.new(Tasks.SCENES["horizontal_drag"], logs, root)
	var trial := _trials.get_trial(0)
	var played := player.play_to_wav(_trials, trial["trial"], wav_path)
	player.free_scene()
	for key: String in ["trial", "gesture", "position", "start_s", "end_s"]:
		check_equal(played[key], trial[key], key)
	check_equal(played["mode"], "phase", "mode")
	var session := logs.path_join(DirAccess.get_directories_at(logs)[0])
	var log_path := session.path_join("%s.log.csv" % trial["trial"])
	var rows := FileAccess.get_file_as_string(log_path).split("\n", false)
	var header := 0
	while not rows[header].begins_with("t,"):
		header += 1
	check_near(played["wav_start_s"], rows[header + 1].to_float(), 1e-6, "the log's first row")
	# At the cue the amplitude leaps from one instant to the next.
	var amplitudes: Array[float] = []
	for row in rows.slice(header + 1):
		amplitudes.append(row.get_slice(",", 10).to_float())
	var leap := 1
	for i in range(1, amplitudes.size()):
		if absf(amplitudes[i] - amplitudes[i - 1]) > absf(amplitudes[leap] - amplitudes[leap - 1]):
			leap = i
	var leap_s := rows[header + 1 + leap].to_float()
	var is_cue: bool = absf(leap_s - played["cue_s"]) < 0.062
	check(is_cue, "the cue at %.3f s is the leap at %.3f s" % [played["cue_s"], leap_s])
	var samples := Waveform.read_wav(wav_path, RATE_HZ)
	var wav_end_s: float = played["wav_start_s"] + float(samples.size()) / RATE_HZ
	check(
		wav_end_s > played["cue_s"] + 0.4, "the file continues after the cue, to %.2f s" % wav_end_s
	)
	check_near(Array(samples.slice(-RATE_HZ / 10)).max(), 0.0, 1e-3, "the vibration has stopped")


func test_switching_the_condition_does_not_click() -> void:
	var wav_path := _folder.get_current_dir().path_join("switched.wav")
	# At the unstable position the conditions differ most.
	var rig := Rig.new(_trials.get_trial(1), _trials.get_measured_path(1), root)
	var synth := _make_synth(rig, wav_path)
	rig.tracker.start()
	var greatest_change := 0.0
	for step in range(_first_step(rig), LAST_STEP + 1):
		if step % SWITCH_STEPS == 0:
			var before := rig.gesture_hmm.value
			rig.gesture_hmm.motion = Rig.MOTIONS[step / SWITCH_STEPS % Rig.MOTIONS.size()]
			greatest_change = maxf(greatest_change, absf(rig.gesture_hmm.value - before))
		rig.tracker.advance_to(step * Rig.STEP_S)
	synth.stop_wav()
	synth.free()
	greatest_change /= rig.task.amplitude
	rig.free_nodes()

	check(greatest_change > 0.2, "a switch changes the level by %.2f" % greatest_change)
	var samples := Waveform.read_wav(wav_path, RATE_HZ)
	var greatest := Waveform.greatest_step(samples) / (TAU * FREQUENCY_HZ / RATE_HZ)
	check(greatest < 1.02, "greatest step: %.3f of the waveform's own" % greatest)


func test_equal_runs_give_equal_files() -> void:
	var texts: Array[PackedByteArray] = []
	for name: String in ["a.wav", "b.wav"]:
		var wav_path := _folder.get_current_dir().path_join(name)
		var rig := Rig.new(_trials.get_trial(0), _trials.get_measured_path(0), root)
		var synth := _make_synth(rig, wav_path)
		rig.record(_first_step(rig), LAST_STEP)
		synth.stop_wav()
		synth.free()
		rig.free_nodes()
		texts.append(FileAccess.get_file_as_bytes(wav_path))
	check(texts[0].size() > 100000 and texts[0] == texts[1], "the same bytes")


func test_an_unfinished_file_can_be_read() -> void:
	var wav_path := _folder.get_current_dir().path_join("under_way.wav")
	var rig := Rig.new(_trials.get_trial(0), _trials.get_measured_path(0), root)
	var synth := _make_synth(rig, wav_path)
	rig.record(_first_step(rig), LAST_STEP)
	var samples := Waveform.read_wav(wav_path, RATE_HZ)
	check(samples.size() > RATE_HZ, "%d samples are there" % samples.size())
	synth.stop_wav()
	var whole := Waveform.read_wav(wav_path, RATE_HZ)
	check(whole.size() > samples.size(), "the complete file has more")
	check_equal(whole.slice(0, samples.size()), samples, "after those")
	synth.free()
	rig.free_nodes()


func test_two_synths_do_not_write_one_file() -> void:
	var alone_path := _folder.get_current_dir().path_join("alone.wav")
	var wav_path := _folder.get_current_dir().path_join("both.wav")
	var rig := Rig.new(_trials.get_trial(0), _trials.get_measured_path(0), root)
	var synths: Array[HapticSynth] = []
	for path: String in [wav_path, wav_path, alone_path]:
		synths.append(_make_synth(rig, path))
	synths[1].name = &"Other"
	# expects one error: /Other':
	# expects one error: both.wav is being written by HapticSynth
	rig.record(_first_step(rig), LAST_STEP)
	for synth in synths:
		synth.free()
	rig.free_nodes()
	var bytes := FileAccess.get_file_as_bytes(wav_path)
	check_equal(
		bytes, FileAccess.get_file_as_bytes(alone_path), "the file of the first one is complete"
	)


func test_an_invalid_wav_path_is_refused() -> void:
	# expects one error: wav_path must end with .wav, is user://precious.txt
	# expects one error: there is no folder
	# expects one error: HapticSynth '/root/Lost': cannot write to
	# expects one warning: "effects"[0] is null and plays nothing
	var rig := Rig.new(_trials.get_trial(0), _trials.get_measured_path(0), root)
	var synth := _make_synth(rig, _folder.get_current_dir().path_join("no_folder/a.wav"))
	synth.name = &"Lost"
	synth.effects = [null]
	synth.wav_path = "user://precious.txt"
	check(synth.wav_path.ends_with("a.wav"), "the path is kept")
	rig.record(_first_step(rig), 10)
	synth.free()
	rig.free_nodes()


## The vibration begins with the first control instant after the first frame.
func _first_step(rig: Rig) -> int:
	rig.tracker.start()
	return ceili(rig.tracker.get_start_time() / Rig.STEP_S)


func _make_synth(rig: Rig, wav_path: String) -> HapticSynth:
	var synth := HapticSynth.new()
	synth.gesture_hmm = rig.gesture_hmm
	var spring := SpringEffect.new()
	spring.frequency = FREQUENCY_HZ
	spring.trigger = HapticEffect.TRIGGER_ALWAYS
	synth.effects = [spring]
	synth.wav_sample_rate = RATE_HZ
	synth.wav_path = wav_path
	root.add_child(synth)
	return synth


func _check_spectrum(samples: PackedFloat32Array) -> void:
	var at_peak := Waveform.amplitude_at(samples, RATE_HZ, FREQUENCY_HZ)
	check(at_peak > 0.8, "180 Hz is there: %s" % at_peak)
	for frequency_hz: float in [60.0, 120.0, 160.0, 200.0, 360.0, 540.0]:
		var other := Waveform.amplitude_at(samples, RATE_HZ, frequency_hz)
		check(other < 0.01 * at_peak, "nothing at %s Hz: %s" % [frequency_hz, other])


## The amplitude of each window against the synthesised motion in its middle.
func _check_envelope(
	samples: PackedFloat32Array, values: PackedFloat64Array, amplitude_m: float
) -> void:
	var width := Rig.MOTIONS.size()
	var window := int(WINDOW_STEPS * RATE_HZ * Rig.STEP_S)
	var worst := 0.0
	for step in range(0, samples.size() / (RATE_HZ / 1000) - WINDOW_STEPS, WINDOW_STEPS):
		var first := step * RATE_HZ / 1000
		var heard := Waveform.amplitude_at(
			samples.slice(first, first + window), RATE_HZ, FREQUENCY_HZ
		)
		var value := values[(step + WINDOW_STEPS / 2) * width + width - 1]
		worst = maxf(worst, absf(heard - clampf(value / amplitude_m, 0.0, 1.0)))
	check(worst < 0.06, "the envelope follows the motion, within %s" % worst)
