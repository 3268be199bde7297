extends "support/scene_test.gd"
## A HapticSynth without an output gives a warning; one with an output gives none.

const Rig := preload("support/rig.gd")

const BUS := &"Master"
const LATER_S := 0.5
const WATCHED_S := 1.5

var _folder := DirAccess.create_temp("steadyhand_silence")
var _trials := Rig.write_trials(_folder.get_current_dir())


func test_a_missing_output_is_warned_of_once() -> void:
	# expects one warning: /Mute': nothing is felt. Set its "bus"
	var rig := Rig.new(_trials.get_trial(0), _trials.get_measured_path(0), root)
	var mute := _make(rig, "Mute")
	var to_file := _make(rig, "ToFile")
	to_file.wav_path = _folder.get_current_dir().path_join("vibration.wav")
	var late := _make(rig, "Late")
	var read := _make(rig, "Read")
	var shown := _make(rig, "Shown")
	var gentle := _make(rig, "Still")
	gentle.gain = 0.0
	rig.tracker.start()
	rig.tracker.advance(rig.tracker.get_duration() * 0.5)
	check_equal(read.get_buffer(10).size(), 10, "a script reads samples")
	check(shown.get_amplitude() >= 0.0, "or their amplitude")
	await _wait(LATER_S)
	late.bus = BUS
	await _wait(WATCHED_S - LATER_S)
	rig.tracker.advance(rig.tracker.get_duration())
	await _wait(LATER_S)
	for synth: HapticSynth in [mute, to_file, late, read, shown, gentle]:
		synth.free()
	rig.free_nodes()


func test_a_bus_set_before_a_gesture_has_no_warning() -> void:
	var rig := Rig.new(_trials.get_trial(0), _trials.get_measured_path(0), root)
	var synth := _make(rig, "Idle")
	await _wait(WATCHED_S)
	synth.bus = BUS
	rig.tracker.start()
	rig.tracker.advance(rig.tracker.get_duration())
	await _wait(LATER_S)
	check_equal(String(rig.gesture_hmm.recognised), "horizontal_drag", "a bus that is set in time")
	synth.free()
	rig.free_nodes()


func _make(rig: Rig, name: String) -> HapticSynth:
	var synth := HapticSynth.new()
	synth.name = name
	synth.gesture_hmm = rig.gesture_hmm
	root.add_child(synth)
	return synth


func _wait(time_s: float) -> void:
	await create_timer(time_s).timeout
