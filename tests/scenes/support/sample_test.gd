extends "scene_test.gd"
## A test of one of the add-on's samples.

const SampleHand := preload("res://addons/steadyhand/samples/sample_hand.gd")

const FOLDER := "res://addons/steadyhand/samples/%s.tscn"

var _scene: Node = null
var _hmm: GestureHMM = null
var _events: Array[String] = []


## Opens a sample with a simulated hand.
func _open(sample: String) -> GestureTestHand:
	_events.clear()
	_scene = (load(FOLDER % sample) as PackedScene).instantiate()
	root.add_child(_scene)
	_hmm = _scene.get_node("GestureHMM")
	var hand := GestureTestHand.attach(_scene.get_node("Hand") as HandTracker)
	return hand


func _close() -> void:
	_scene.free()


func _frames(count: int) -> void:
	for frame in count:
		await process_frame
