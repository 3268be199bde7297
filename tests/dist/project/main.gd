extends Node3D
## A game with the add-on: a simulated hand drags, and what the bus carries is saved.
##
## Its own argument is a folder. It gets bus.raw (32-bit floats, left and right in turn) and
## vibration.wav.

const LONGEST_S := 10.0

var _capture := AudioEffectCapture.new()


func _ready() -> void:
	_capture.buffer_length = LONGEST_S
	AudioServer.add_bus_effect(0, _capture)
	var folder := OS.get_cmdline_user_args()[0]
	var task := GestureTask.new()
	task.gesture = &"horizontal_drag"
	var source := SyntheticSource.new()
	source.place_at(task)
	var tracker := HandTracker.new()
	tracker.source = source
	var hmm := GestureHMM.new()
	hmm.models = [load("res://addons/steadyhand/models/horizontal_drag.gesture")]
	hmm.tracker = tracker
	hmm.task = task
	hmm.gesture_ended.connect(_end.bind(folder))
	var synth := HapticSynth.new()
	synth.gesture_hmm = hmm
	synth.bus = &"Master"
	synth.wav_path = folder.path_join("vibration.wav")
	for node: Node in [task, tracker, hmm, synth]:
		add_child(node)
	var kind := "debug" if OS.is_debug_build() else "release"
	print("%s build, exported: %s" % [kind, OS.has_feature("template")])
	get_tree().create_timer(LONGEST_S).timeout.connect(get_tree().quit.bind(1))


func _end(
	gesture: StringName, _time_s: float, _task: GestureTask, _fraction: float, folder: String
) -> void:
	await get_tree().create_timer(0.2).timeout
	var file := FileAccess.open(folder.path_join("bus.raw"), FileAccess.WRITE)
	file.store_buffer(_capture.get_buffer(_capture.get_frames_available()).to_byte_array())
	file.close()
	print("END %s, %s Hz" % [gesture, AudioServer.get_mix_rate()])
	get_tree().quit()
