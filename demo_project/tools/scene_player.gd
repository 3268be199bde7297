extends RefCounted
## Steps a task scene at 1 kHz on the trials' clock, as fast as the machine can.

const TaskScene := preload("res://scripts/task_scene.gd")

const STEP_S := 1e-3
const SOON_S := 0.05
## Time after the track's end, because the vibration may end later.
const AFTER_TRACK_S := 0.5

## Wall-clock time that was spent on playing, s.
var taken_s := 0.0

var _scene: TaskScene = null


## `parent`: a node in the tree.
func _init(scene_path: String, log_folder: String, parent: Node) -> void:
	_scene = (load(scene_path) as PackedScene).instantiate()
	_scene.autoplay = false
	_scene.log_folder = log_folder
	var tracker: HandTracker = _scene.get_node("HandTracker")
	tracker.update_mode = HandTracker.UPDATE_MANUAL
	var haptic_synth: HapticSynth = _scene.get_node("HapticSynth")
	haptic_synth.bus = &""
	parent.add_child(_scene)


func free_scene() -> void:
	_scene.free()


## Plays all trials of the gesture except `left_out`. Returns their length on their own clocks, s.
func play_all(trial_set: TrialSet, gesture: String, left_out: Array[String] = []) -> float:
	var played_s := 0.0
	for index in trial_set.get_count():
		var trial := trial_set.get_trial(index)
		if trial["gesture"] == gesture and trial["trial"] not in left_out:
			played_s += _play(trial_set, index)
	return played_s


## The trial and, on its clock, s: its gesture's start_s and end_s, the WAV's first sample, and the
## begin of the end cue (null: never).
func play_to_wav(trial_set: TrialSet, trial_name: String, wav_path: String) -> Dictionary:
	var played := {}
	for index in trial_set.get_count():
		var trial := trial_set.get_trial(index)
		if trial["trial"] != trial_name:
			continue
		for key: String in ["trial", "gesture", "position", "start_s", "end_s"]:
			played[key] = trial[key]
		played["mode"] = "paper" if _scene.gesture_hmm.mode == GestureHMM.MODE_PAPER else "phase"
		# The WAV gets the motion at the instants of motion_updated.
		_scene.gesture_hmm.motion_updated.connect(
			func(time_s: float) -> void: played["wav_start_s"] = time_s, CONNECT_ONE_SHOT
		)
		_scene.haptic_synth.wav_path = wav_path
		_play(trial_set, index)
		for step in roundi(AFTER_TRACK_S / STEP_S):
			_scene.tracker.advance(STEP_S)
		_scene.haptic_synth.stop_wav()
		played["cue_s"] = _cue_s()
	return played


## As in HapticSynth: at 95 % of the amplitude, or at the gesture's end if it misses that.
func _cue_s() -> Variant:
	var arrived_s := _scene.course.end_s
	var ended_s := _scene.course.gesture_end_s
	if is_nan(arrived_s) or arrived_s > ended_s + SOON_S:
		arrived_s = ended_s
	return null if is_nan(arrived_s) else arrived_s


func _play(trial_set: TrialSet, index: int) -> float:
	var began_us := Time.get_ticks_usec()
	var trial := trial_set.get_trial(index)
	if _scene.play(trial, trial_set.get_measured_path(index)) != OK:
		return 0.0
	while not _scene.tracker.is_finished():
		_scene.tracker.advance(STEP_S)
	taken_s += 1e-6 * (Time.get_ticks_usec() - began_us)
	return _scene.tracker.get_duration()
