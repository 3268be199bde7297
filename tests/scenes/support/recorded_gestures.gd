extends RefCounted
## Hands for the editor's panel: the index tip repeats a gesture, and returns between two of them.
## Frames are pushed, as by a device.

const PushedHand := preload("pushed_hand.gd")

const FRAME_S := 1.0 / 90.0
const REST_S := 0.6
const NOISE_M := 2e-4

var time_s := 0.0
var place := Vector3(0.1, 1.1, -0.3)

var _random := RandomNumberGenerator.new()
var _tracker: HandTracker


func _init(tracker: HandTracker) -> void:
	_tracker = tracker
	_random.seed = 1


func rest(seconds: float) -> void:
	move(Vector3.ZERO, seconds)


## Moves by `way` (m) in `seconds` on a minimum-jerk curve.
func move(way: Vector3, seconds: float) -> void:
	var from := place
	var frames := roundi(seconds / FRAME_S)
	for frame in range(1, frames + 1):
		_push(from + way * PushedHand.share(float(frame) / frames))
	place = from + way


## Counterclockwise for `turns` above 0. Starts to the right.
func circle(radius_m: float, seconds: float, turns: float = 1.0) -> void:
	var centre := place + Vector3(0.0, radius_m, 0.0)
	var frames := roundi(seconds / FRAME_S)
	for frame in range(1, frames + 1):
		var angle := TAU * turns * PushedHand.share(float(frame) / frames) - 0.5 * PI
		_push(centre + radius_m * Vector3(cos(angle), sin(angle), 0.0))


func repeat(way: Vector3, times: int) -> void:
	rest(REST_S)
	for i in times:
		move(way, 0.5 + 0.05 * i)
		rest(REST_S)
		move(-way, 0.8)
		rest(REST_S)


func _push(at: Vector3) -> void:
	time_s += FRAME_S
	var noise := Vector3(_random.randfn(), _random.randfn(), _random.randfn())
	_tracker.push_frame(time_s, {HandTracker.JOINT_INDEX: at + NOISE_M * noise})
