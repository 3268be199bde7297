extends "tool.gd"
## godot --headless --path demo_project --script res://tools/measure_live.gd -- --out DIR
##     [--trials DIR]
##
## Records the live vibration on an audio bus, at the engine's mix rate: with a hand held still,
## with changes of all kinds, and for the first trial of each gesture of --trials. Writes the
## samples (NAME.f32) and live.json, which has the time of each action.

const BusRecorder := preload("bus_recorder.gd")
const Stored := preload("res://scripts/stored.gd")
const TrialTask := preload("res://scripts/trial_task.gd")

const MODEL := "res://addons/steadyhand/models/%s.gesture"
const FRAMES_PER_S := 90
const FREQUENCY_HZ := 180.0
const AMPLITUDE_M := 0.2
const HELD_S := 2.5
const SETTLING_S := 0.4  ## or two blocks, if that is longer
const CHANGE_S := 0.5
const STALL_S := 0.4
## Frames per mix of headless Godot, at any mix rate.
const MIXED_AT_ONCE := 4096
const LEFT := 1
const RIGHT := 2

var _out := ""
var _is_begun := false
var _report := {}
var _bus := BusRecorder.new(&"Measured")
var _other_bus := BusRecorder.new(&"Other")
var _tracker: HandTracker
var _task: GestureTask
var _hmm: GestureHMM
var _synth: HapticSynth
var _spring: SpringEffect


func _process(_delta: float) -> bool:
	if not _is_begun:
		_is_begun = true
		_measure(OS.get_cmdline_user_args())
	return false


func _measure(arguments: PackedStringArray) -> void:
	var options := CommandLine.new(arguments, {out = "", trials = ""})
	_out = options.path("out")
	var trials_folder := options.optional_path("trials")
	if not options.error.is_empty():
		fail(options.error, EXIT_BAD_INPUT)
		quit(exit_code)
		return
	Engine.max_fps = FRAMES_PER_S
	_report = {
		mix_rate = AudioServer.get_mix_rate(),
		output_latency = AudioServer.get_output_latency(),
		frequency = FREQUENCY_HZ,
		held = {},
		changes = {},
		trials = [],
	}
	await _measure_held()
	await _measure_changes()
	if not trials_folder.is_empty():
		await _measure_trials(TrialSet.load_folder(trials_folder))
	# The engine releases a playback in the frame after its next mix.
	await create_timer(_two_blocks_s()).timeout
	var file := FileAccess.open(_out.path_join("live.json"), FileAccess.WRITE)
	file.store_string(JSON.stringify(_report, "\t", false))
	exit_code = 0 if Stored.is_written(file) else EXIT_BAD_INPUT
	file.close()
	quit(exit_code)


## A block that is mixed before the vibration has begun is silent.
func _settling_s() -> float:
	return maxf(SETTLING_S, _two_blocks_s())


func _two_blocks_s() -> float:
	return 2.0 * MIXED_AT_ONCE / AudioServer.get_mix_rate()


func _measure_held() -> void:
	_build_held()
	await _hold_for(_settling_s(), 0.5)
	_bus.begin()
	await _hold_for(HELD_S, 0.5)
	_bus.end()
	_bus.save(_out.path_join("held.f32"))
	_report["held"] = {level = 0.5}
	_free_held()


## Makes each change in the middle of 0.5 s, while a hand is held at full amplitude.
func _measure_changes() -> void:
	_build_held()
	await _hold_for(_settling_s(), 1.0)
	await _change("condition", func() -> void: _hmm.motion = GestureHMM.MOTION_AVERAGE)
	await _change("condition back", func() -> void: _hmm.motion = GestureHMM.MOTION_MEASURED)
	await _change("gain", func() -> void: _synth.gain = 0.25)
	await _change("gain back", func() -> void: _synth.gain = 1.0)
	await _change("frequency", func() -> void: _spring.frequency = 150.0)
	await _change("frequency back", func() -> void: _spring.frequency = FREQUENCY_HZ)
	await _change("effects", func() -> void: _synth.effects = [_other_spring()])
	await _change("effects back", func() -> void: _synth.effects = [_spring])
	await _change("gesture", _wait_for.bind("zoom"))
	await _change("gesture back", _wait_for.bind("horizontal_drag"))
	await _change("pause", func() -> void: paused = true)
	await _change("after the pause", func() -> void: paused = false)
	await _change("game stops for 0.4 s", func() -> void: OS.delay_usec(int(1e6 * STALL_S)))
	await _change("another bus", func() -> void: _synth.bus = _other_bus.name)
	await _change("bus back", func() -> void: _synth.bus = _bus.name)
	await _change("bus taken away", func() -> void: _synth.bus = &"")
	await _change("bus given again", func() -> void: _synth.bus = _bus.name)
	await _change("HapticSynth freed, as with its scene", _synth.free)
	_synth = null
	_free_held()


func _change(what: String, action: Callable) -> void:
	_bus.begin()
	_other_bus.begin()
	await _hold_for(CHANGE_S, 1.0)
	action.call()
	await _hold_for(CHANGE_S, 1.0)
	_bus.end()
	_other_bus.end()
	var name := "change_%02d" % (_report["changes"] as Dictionary).size()
	_bus.save(_out.path_join("%s.f32" % name))
	_other_bus.save(_out.path_join("%s_other.f32" % name))
	_report["changes"][what] = name


func _build_held() -> void:
	_tracker = HandTracker.new()
	_tracker.source = ScriptSource.new()
	_tracker.update_mode = HandTracker.UPDATE_MANUAL
	_task = GestureTask.new()
	_task.gesture = &"horizontal_drag"
	_task.amplitude = AMPLITUDE_M
	_hmm = GestureHMM.new()
	_hmm.models = [load(MODEL % "horizontal_drag"), load(MODEL % "zoom")]
	_hmm.tracker = _tracker
	_hmm.task = _task
	_hmm.motion = GestureHMM.MOTION_MEASURED
	_spring = SpringEffect.new()
	_spring.frequency = FREQUENCY_HZ
	_spring.trigger = HapticEffect.TRIGGER_ALWAYS
	_synth = HapticSynth.new()
	_synth.gesture_hmm = _hmm
	_synth.effects = [_spring]
	_synth.bus = _bus.name
	for node: Node in [_tracker, _task, _hmm, _synth]:
		root.add_child(node)
	_tracker.start()


func _free_held() -> void:
	for node: Node in [_synth, _hmm, _task, _tracker]:
		if node != null:
			node.free()


func _other_spring() -> SpringEffect:
	var other := SpringEffect.new()
	other.trigger = HapticEffect.TRIGGER_ALWAYS
	other.gain = 0.4
	return other


func _wait_for(gesture: StringName) -> void:
	_task.gesture = gesture


func _hold_for(seconds: float, level: float) -> void:
	var until_s := BusRecorder.now_s() + seconds
	while BusRecorder.now_s() < until_s:
		var tip := Vector3(level * AMPLITUDE_M, 0, 0)
		_tracker.push_frame(BusRecorder.now_s(), {HandTracker.JOINT_INDEX: tip})
		_bus.note()
		await process_frame


func _measure_trials(trials: TrialSet) -> void:
	var done := {}
	for i in trials.get_count():
		var trial := trials.get_trial(i)
		if trial["position"] == "stable" and not done.has(trial["gesture"]):
			done[trial["gesture"]] = true
			await _measure_trial(trial, trials.get_measured_path(i))


## Plays the trial in real time: sustained effects on the left, cues on the right. Also writes one
## file of each on the motion's own clock, exact to the sample.
func _measure_trial(trial: Dictionary, track_path: String) -> void:
	var gesture: String = trial["gesture"]
	_tracker = HandTracker.new()
	var source := RecordedSource.new()
	source.track = track_path
	_tracker.source = source
	_tracker.autostart = false
	_task = GestureTask.new()
	_hmm = GestureHMM.new()
	_hmm.models = [load(MODEL % gesture)]
	_hmm.tracker = _tracker
	_hmm.task = _task
	var spring := SpringEffect.new()
	spring.trigger = HapticEffect.TRIGGER_ALWAYS
	var cue: HapticEffect = ImpulseEffect.new() if gesture == "tap" else InertialViscousEffect.new()
	var paths: Array[String] = []
	var synths: Array[HapticSynth] = [HapticSynth.new(), HapticSynth.new(), HapticSynth.new()]
	spring.channels = LEFT
	cue.channels = RIGHT
	synths[0].effects = [spring, cue]
	synths[0].bus = _bus.name
	for place in 2:
		paths.append(_out.path_join("%s_%s.wav" % [gesture, ["spring", "cue"][place]]))
		synths[1 + place].effects = [[spring, cue][place]]
		synths[1 + place].wav_path = paths[place]
	for node: Node in [_tracker, _task, _hmm]:
		root.add_child(node)
	TrialTask.apply(trial, _task)
	for synth in synths:
		synth.gesture_hmm = _hmm
		root.add_child(synth)
	await create_timer(_settling_s()).timeout
	_bus.begin()
	_tracker.start()
	var clock := PackedFloat64Array()
	var start_s := _tracker.get_start_time()
	var frame_began_s := BusRecorder.now_s()
	while not _tracker.is_finished():
		await process_frame
		# The signal is emitted before _process(): the tracker still has the time of the last frame.
		clock.append(frame_began_s)
		clock.append(_tracker.get_time())
		frame_began_s = BusRecorder.now_s()
		_bus.note()
	_bus.end()
	_bus.save(_out.path_join("%s.f32" % gesture))
	for synth in synths:
		synth.free()
	_synth = null
	_free_held()
	(
		_report["trials"]
		. append(
			{
				gesture = gesture,
				start_s = start_s,
				moments = Array(_bus.moments),
				clock = Array(clock),
				spring = paths[0],
				cue = paths[1],
			}
		)
	)
