extends RefCounted
## A spring on an audio bus while a hand is held, and what a bus carries of it: the audio thread
## mixes in real time.

const Rig := preload("rig.gd")

const BUS := &"Wristband"
const PATIENCE_S := 10.0

var task := GestureTask.new()
var synth := HapticSynth.new()
var capture := AudioEffectCapture.new()

var _tracker := HandTracker.new()
var _gesture_hmm := GestureHMM.new()
var _tree: SceneTree


## `listened_to`: the index of the bus that is heard.
func _init(tree: SceneTree, listened_to: int) -> void:
	_tree = tree
	capture.buffer_length = 2.0
	AudioServer.add_bus_effect(listened_to, capture)
	_tracker.source = ScriptSource.new()
	_tracker.update_mode = HandTracker.UPDATE_MANUAL
	task.gesture = &"horizontal_drag"
	_gesture_hmm.models = [load(Rig.MODEL % "horizontal_drag") as GestureModel]
	_gesture_hmm.tracker = _tracker
	_gesture_hmm.task = task
	_gesture_hmm.motion = GestureHMM.MOTION_MEASURED
	synth.gesture_hmm = _gesture_hmm
	var spring := SpringEffect.new()
	spring.trigger = HapticEffect.TRIGGER_ALWAYS
	synth.effects = [spring]
	synth.bus = BUS
	for node: Node in [_tracker, task, _gesture_hmm, synth]:
		tree.root.add_child(node)
	_tracker.start()


func free_nodes() -> void:
	for node: Node in [synth, _gesture_hmm, task, _tracker]:
		node.free()


## The hand is held at `level`, a share of the task's amplitude; what was heard is forgotten.
func settle(level: float, duration_s: float) -> void:
	var began_s := _now_s()
	while _now_s() - began_s < duration_s:
		await _hold(level)
	capture.clear_buffer()


## Left channel since the last call, or settle(), of `duration_s` at least, with the hand held on;
## shorter where the bus is not mixed in time.
func hear(level: float, duration_s: float) -> PackedFloat32Array:
	var began_s := _now_s()
	var wanted := int(duration_s * AudioServer.get_mix_rate())
	while capture.get_frames_available() < wanted and _now_s() - began_s < PATIENCE_S:
		await _hold(level)
	return _heard()


## Left channel from one frame to the next, with the hand held on.
func hear_news(level: float) -> PackedFloat32Array:
	_tell(level)
	capture.clear_buffer()
	await _tree.process_frame
	return _heard()


func _heard() -> PackedFloat32Array:
	var samples := PackedFloat32Array()
	for frame in capture.get_buffer(capture.get_frames_available()):
		samples.append(frame.x)
	return samples


func _hold(level: float) -> void:
	_tell(level)
	await _tree.process_frame


func _tell(level: float) -> void:
	var tip := Vector3(level * task.amplitude, 0, 0)
	_tracker.push_frame(_now_s(), {HandTracker.JOINT_INDEX: tip})


static func _now_s() -> float:
	return 1e-6 * Time.get_ticks_usec()
