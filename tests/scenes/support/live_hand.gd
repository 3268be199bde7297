extends RefCounted
## An index finger whose frames a test pushes to a scene's tracker.

const PushedHand := preload("pushed_hand.gd")
const TaskScene := preload("res://scripts/task_scene.gd")

const FRAME_S := 0.01

## Time of the last frame.
var time_s := 0.0
var place := Vector3.ZERO


## Pushes the next frame: at `to` with tremor, or without a tracked joint.
func push(scene: TaskScene, to: Vector3, is_tracked: bool = true) -> void:
	time_s += FRAME_S
	place = to
	var tremor := 1e-4 * Vector3(sin(55.0 * time_s), sin(62.0 * time_s), sin(71.0 * time_s))
	var joints := {HandTracker.JOINT_INDEX: place + tremor} if is_tracked else {}
	scene.tracker.push_frame(time_s, joints)


## Moves in 1 s on a minimum-jerk curve.
func move(scene: TaskScene, to: Vector3) -> void:
	var from := place
	for frame in range(1, 101):
		push(scene, from.lerp(to, PushedHand.share(frame / 100.0)))


## Moves to the task's start, rests, makes the gesture to `way` (m), and rests.
func make_gesture(scene: TaskScene, way: float) -> void:
	var start := scene.task.get_start()
	var end := start + scene.task.get_axis() * way
	for to: Vector3 in [start, start, end, end]:
		move(scene, to)
