extends RefCounted
## A spring on an audio bus while a hand is held, and a recording of a bus. The audio thread mixes
## in real time.

const Rig := preload("rig.gd")

const BUS := &"Wristband"
const PATIENCE_S := 10.0

var task := GestureTask.new()
var synth := HapticSynth.new()
var capture := AudioEffectCapture.new()

var _tracker := HandTracker.new()
var _gesture_hmm := GestureHMM.new()
var _tree: SceneTree


## `recorded_bus`: the index of the recorded bus.
func _init(tree: SceneTree, recorded_bus: int) -> void:
	_tree = tree
	capture.buffer_length = 2.0
	AudioServer.add_bus_effect(recorded_bus, capture)
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


## Holds the hand at `level`, a share of the task's amplitude, and clears the recording.
func settle(level: float, duration_s: float) -> void:
	var began_s := _now_s()
	while _now_s() - began_s < duration_s:
		await _hold(level)
	capture.clear_buffer()


## The left channel since the last call or settle(), at least `duration_s` long, while the hand is
## held. It is shorter if the bus is not mixed in time.
func record(level: float, duration_s: float) -> PackedFloat32Array:
	var began_s := _now_s()
	var wanted := int(duration_s * AudioServer.get_mix_rate())
	while capture.get_frames_available() < wanted and _now_s() - began_s < PATIENCE_S:
		await _hold(level)
	return _recorded()


## The left channel from one frame to the next, while the hand is held.
func record_frame(level: float) -> PackedFloat32Array:
	_push(level)
	capture.clear_buffer()
	await _tree.process_frame
	return _recorded()


func _recorded() -> PackedFloat32Array:
	var samples := PackedFloat32Array()
	for frame in capture.get_buffer(capture.get_frames_available()):
		samples.append(frame.x)
	return samples


func _hold(level: float) -> void:
	_push(level)
	await _tree.process_frame


func _push(level: float) -> void:
	var tip := Vector3(level * task.amplitude, 0, 0)
	_tracker.push_frame(_now_s(), {HandTracker.JOINT_INDEX: tip})


static func _now_s() -> float:
	return 1e-6 * Time.get_ticks_usec()
