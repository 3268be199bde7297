extends Node3D
## The surroundings of the samples: a desk, a camera or a headset, the fingertips, and the
## vibration. Your own game needs none of it.

const SampleHand := preload("sample_hand.gd")

const Key := preload("key.tscn")
const Tap := preload("../models/tap.gesture")
const CHOOSER := "res://addons/steadyhand/samples/samples.tscn"
const TIPS: Array[HandTracker.Joint] = [
	HandTracker.JOINT_INDEX, HandTracker.JOINT_THUMB, HandTracker.JOINT_MIDDLE
]

@export var hand: HandTracker
@export var haptic_synth: HapticSynth
## Place of the camera, or of the seated player's head.
@export var eye := Vector3(0.0, 1.3, 0.05)
@export var looks_at := Vector3(0.0, 1.03, -0.45)

@onready var _tips: Array[Node] = $Fingertips.get_children()
@onready var _tip_material: StandardMaterial3D = (_tips[0] as MeshInstance3D).material_override


func _ready() -> void:
	($Camera3D as Camera3D).look_at_from_position(eye, looks_at)
	($Screen/Vibration as HapticStrip).synth = haptic_synth
	if not SampleHand.is_xr_running():
		($Camera3D as Camera3D).make_current()
		return
	get_viewport().use_xr = true
	($XROrigin3D/XRCamera3D as XRCamera3D).make_current()
	($XROrigin3D as Node3D).position = eye
	# The head has no pose in the first frames.
	await get_tree().create_timer(1.0).timeout
	XRServer.center_on_hmd(XRServer.RESET_BUT_KEEP_TILT, false)
	add_back_key()


## A key in place of Esc, for players without a keyboard.
func add_back_key() -> GestureTask:
	var key := Key.instantiate() as Node3D
	key.position = Vector3(-0.28, 1.0, -0.4)
	(key.get_node(^"Cap/Label") as Label3D).text = "<"
	add_child(key)
	var hmm := GestureHMM.new()
	hmm.models = [Tap]
	hmm.task = key.get_node(^"GestureTask")
	hmm.tracker = hand
	hmm.gesture_ended.connect(
		func(_g: StringName, _time_s: float, _t: GestureTask, _f: float) -> void: leave()
	)
	add_child(hmm)
	return hmm.task


## To the chooser, or from there to the project's main scene.
func leave() -> void:
	var main: String = ProjectSettings.get_setting("application/run/main_scene")
	var is_chooser := get_tree().current_scene.scene_file_path == CHOOSER
	get_tree().change_scene_to_file(main if is_chooser and not main.is_empty() else CHOOSER)


func _unhandled_key_input(event: InputEvent) -> void:
	if event.is_action_pressed(&"ui_cancel") and get_tree().current_scene != null:
		leave()


func _process(_delta: float) -> void:
	for i in TIPS.size():
		var tip := _tips[i] as MeshInstance3D
		tip.visible = hand.is_joint_tracked(TIPS[i])
		tip.global_position = hand.get_joint_position(TIPS[i])
		_show_finger(tip)
	_tip_material.emission_energy_multiplier = 2.0 * haptic_synth.get_amplitude()


## From the tip to the palm, if the palm is tracked.
func _show_finger(tip: Node3D) -> void:
	var finger := tip.get_node(^"Finger") as Node3D
	finger.visible = hand.is_joint_tracked(HandTracker.JOINT_PALM)
	var way := hand.get_joint_position(HandTracker.JOINT_PALM) - tip.global_position
	if finger.visible and not way.is_zero_approx():
		tip.quaternion = Quaternion(Vector3.UP, way.normalized())
		finger.position.y = 0.5 * way.length()
		finger.scale.y = way.length()
