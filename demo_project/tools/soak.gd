extends "tool.gd"
## godot --headless --path demo_project --script res://tools/soak.gd -- --trials DIR
##     [--minutes N]
##
## Plays one hour of trials through the nodes, as fast as possible. Each trial has a scene of its
## own, and a script takes the vibration's samples at 48 kHz. Prints memory and time of the first
## and the last tenth, after a warm-up as long as a tenth.

const RecordedHand := preload("recorded_hand.gd")
const TrialTask := preload("res://scripts/trial_task.gd")

const MODEL := "res://addons/steadyhand/models/%s.gesture"
const RATE_HZ := 48000
const FRAME_S := 1.0 / 90.0
const TENTHS := 10

var _played_s := 0.0
var _samples := 0
var _trial := 0


func work(arguments: PackedStringArray) -> void:
	var options := CommandLine.new(arguments, {trials = "", minutes = "60"})
	var folder := options.path("trials")
	var trials: TrialSet = TrialSet.load_folder(folder) if options.error.is_empty() else null
	if trials == null:
		fail(options.error, EXIT_BAD_INPUT)
		return
	var tenth_s := 60.0 * options.text("minutes").to_float() / TENTHS
	_play_for(trials, tenth_s)
	_samples = 0
	var took_us: Array[float] = []
	var bytes: Array[int] = []
	for tenth in TENTHS:
		var began_us := Time.get_ticks_usec()
		var before_s := _played_s
		_play_for(trials, tenth_s)
		took_us.append((Time.get_ticks_usec() - began_us) / (_played_s - before_s))
		bytes.append(OS.get_static_memory_usage())
	print("%d samples through the nodes" % _samples)
	var grown := bytes[-1] - bytes[0]
	print("  memory           %+d bytes from the first tenth's end to the last's" % grown)
	print(
		"  us a second      %.0f in the first tenth, %.0f in the last" % [took_us[0], took_us[-1]]
	)
	exit_code = 0


func _play_for(trials: TrialSet, seconds: float) -> void:
	var until_s := _played_s + seconds
	while _played_s < until_s:
		_play(trials.get_trial(_trial), trials.get_measured_path(_trial))
		_trial = (_trial + 1) % trials.get_count()


func _play(trial: Dictionary, track_path: String) -> void:
	var tracker := RecordedHand.make(track_path)
	var task := GestureTask.new()
	var hmm := GestureHMM.new()
	hmm.models = [load(MODEL % trial["gesture"]) as GestureModel]
	hmm.tracker = tracker
	hmm.task = task
	var synth := HapticSynth.new()
	synth.gesture_hmm = hmm
	synth.buffer_sample_rate = RATE_HZ
	var nodes: Array[Node] = [tracker, task, hmm, synth]
	for node in nodes:
		root.add_child(node)
	TrialTask.apply(trial, task)
	tracker.start()
	var begin_s := tracker.get_start_time()
	var frames := floori(tracker.get_duration() / FRAME_S)
	for frame in frames:
		tracker.advance_to(begin_s + frame * FRAME_S)
		_samples += synth.get_buffer(roundi(RATE_HZ * FRAME_S)).size()
	_played_s += frames * FRAME_S
	nodes.reverse()
	for node in nodes:
		node.free()
