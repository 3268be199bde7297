extends RefCounted
## An index finger whose frames a test pushes to a scene's tracker.

const TaskScene := preload("res://scripts/task_scene.gd")

const FRAME_S := 0.01

## Of the last frame.
var time_s := 0.0
var place := Vector3.ZERO


## The next frame: at `to`, trembling, or with nothing tracked.
func push(scene: TaskScene, to: Vector3, is_tracked: bool = true) -> void:
	time_s += FRAME_S
	place = to
	var tremor := 1e-4 * Vector3(sin(55.0 * time_s), sin(62.0 * time_s), sin(71.0 * time_s))
	var joints := {HandTracker.JOINT_INDEX: place + tremor} if is_tracked else {}
	scene.tracker.push_frame(time_s, joints)


## In a second, as smoothly as a hand does (Flash & Hogan 1985).
func move(scene: TaskScene, to: Vector3) -> void:
	var from := place
	for frame in range(1, 101):
		var s := frame / 100.0
		push(scene, from.lerp(to, s * s * s * (10.0 - 15.0 * s + 6.0 * s * s)))


## From wherever the hand is to the task's start, a rest, the gesture to `way` (m), a rest.
func make_gesture(scene: TaskScene, way: float) -> void:
	var start := scene.task.get_start()
	var end := start + scene.task.get_axis() * way
	for to: Vector3 in [start, start, end, end]:
		move(scene, to)
