extends "tool.gd"
## godot --headless --path demo_project --script res://tools/vibrate_trials.gd -- --trials DIR
##     --out DIR
##
## Writes the vibration of each trial, for each condition and the reference, on the motion's own
## clock: the spring by the position, and the cue at the end. Files:
## TRIAL.CONDITION.{spring,cue}.wav, TRIAL.reference.f64 (the reference's curve at 1 kHz) and
## vibrations.json.

const Conditions := preload("res://scripts/conditions.gd")
const RecordedHand := preload("recorded_hand.gd")
const Stored := preload("res://scripts/stored.gd")
const TrialTask := preload("res://scripts/trial_task.gd")

const MODEL := "res://addons/steadyhand/models/%s.gesture"
const CURVE_HZ := 1000.0
## Enough for the carriers: envelopes are slow, and cues are measured to 1 ms.
const WAV_HZ := 8000
const PAPER := "paper"
const REFERENCE := "reference"

var _out := ""
var _rows: Array[Dictionary] = []


func work(arguments: PackedStringArray) -> void:
	var options := CommandLine.new(arguments, {trials = "", out = ""})
	var folder := options.path("trials")
	_out = options.path("out")
	var trials: TrialSet = TrialSet.load_folder(folder) if options.error.is_empty() else null
	if trials == null:
		fail(options.error, EXIT_BAD_INPUT)
		return
	for i in trials.get_count():
		_vibrate(trials.get_trial(i), trials.get_measured_path(i), trials.get_reference_path(i))
	var file := FileAccess.open(_out.path_join("vibrations.json"), FileAccess.WRITE)
	file.store_string(JSON.stringify({wav_rate = WAV_HZ, curve_rate = CURVE_HZ, trials = _rows}))
	exit_code = 0 if Stored.is_written(file) else EXIT_BAD_INPUT


func _vibrate(trial: Dictionary, measured_path: String, reference_path: String) -> void:
	var measured := _make_tracker(measured_path)
	var reference := _make_tracker(reference_path)
	var task := GestureTask.new()
	root.add_child(task)
	TrialTask.apply(trial, task)
	var nodes: Array[Node] = [measured, reference, task]
	var names := Conditions.NAMES.duplicate()
	names.append_array([PAPER, REFERENCE])
	for name: String in names:
		nodes.append_array(
			_condition(trial, name, reference if name == REFERENCE else measured, task)
		)
	measured.start()
	reference.start()
	# Both tracks are on one clock: skip the part that only one of them has.
	var first := ceili(maxf(measured.get_start_time(), reference.get_start_time()) * CURVE_HZ)
	var end_s := minf(
		measured.get_start_time() + measured.get_duration(),
		reference.get_start_time() + reference.get_duration()
	)
	var firsts := {}
	for name: String in names:
		var tracker := reference if name == REFERENCE else measured
		firsts[name] = ceili(tracker.get_start_time() * CURVE_HZ) / CURVE_HZ
	var last := floori(end_s * CURVE_HZ)
	for step in range(mini(first, _first_step(firsts)), last + 1):
		measured.advance_to(step / CURVE_HZ)
		reference.advance_to(step / CURVE_HZ)
	nodes.reverse()
	for node in nodes:
		node.free()
	_add_row(trial, reference_path, firsts, first, last)


func _first_step(firsts: Dictionary) -> int:
	var earliest := INF
	for name: String in firsts:
		earliest = minf(earliest, firsts[name])
	return roundi(earliest * CURVE_HZ)


func _make_tracker(path: String) -> HandTracker:
	var tracker := RecordedHand.make(path)
	root.add_child(tracker)
	return tracker


func _condition(
	trial: Dictionary, name: String, tracker: HandTracker, task: GestureTask
) -> Array[Node]:
	var is_tap: bool = trial["gesture"] == "tap"
	var hmm := GestureHMM.new()
	hmm.models = [load(MODEL % trial["gesture"]) as GestureModel]
	hmm.tracker = tracker
	hmm.task = task
	hmm.mode = GestureHMM.MODE_PAPER if name == PAPER else GestureHMM.MODE_PHASE
	match name:
		PAPER:
			hmm.motion = GestureHMM.MOTION_SYNTHESISED
		REFERENCE:
			hmm.motion = GestureHMM.MOTION_MEASURED
		_:
			hmm.motion = Conditions.MOTIONS[Conditions.NAMES.find(name)]
	root.add_child(hmm)
	var nodes: Array[Node] = [hmm]
	var spring := SpringEffect.new()
	spring.trigger = HapticEffect.TRIGGER_ALWAYS
	var effects: Dictionary[String, HapticEffect] = {
		spring = spring,
		cue = ImpulseEffect.new() if is_tap else InertialViscousEffect.new(),
	}
	for what in effects:
		var synth := HapticSynth.new()
		synth.gesture_hmm = hmm
		synth.effects = [effects[what]]
		synth.wav_sample_rate = WAV_HZ
		synth.wav_path = _out.path_join("%s.%s.%s.wav" % [trial["trial"], name, what])
		root.add_child(synth)
		nodes.append(synth)
	return nodes


func _add_row(
	trial: Dictionary, reference_path: String, firsts: Dictionary, first: int, last: int
) -> void:
	var model: GestureModel = load(MODEL % trial["gesture"])
	var count := last - first + 1
	var t0_s := first / CURVE_HZ
	var reference := MotionMetrics.feature_curve(
		RecordedTrack.load_file(reference_path), model.feature, trial, t0_s, CURVE_HZ, count
	)
	var file := FileAccess.open(
		_out.path_join("%s.reference.f64" % trial["trial"]), FileAccess.WRITE
	)
	file.store_buffer(reference.to_byte_array())
	# A curve that is at the end when the gesture starts, ends at that instant.
	var there := PackedFloat64Array()
	there.resize(count)
	there.fill(2.0)
	var start_s: float = trial["start_s"]
	var early: Dictionary = MotionMetrics.compare(
		reference, there, CURVE_HZ, t0_s, start_s, trial["end_s"]
	)
	(
		_rows
		. append(
			{
				trial = trial["trial"],
				gesture = trial["gesture"],
				position = trial["position"],
				start_s = start_s,
				end_s = trial["end_s"],
				first_s = t0_s,
				reference_end_s = start_s + (early["t_diff"] as float),
				conditions = firsts,
			}
		)
	)
