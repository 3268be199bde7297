extends RefCounted
## A hand whose frames a test pushes to a HandTracker, and what a GestureHMM says of it.


## The share of its way that a hand has gone after `passed` of its time, as smoothly as hands go
## (Flash & Hogan 1985); at rest before and after.
static func share(passed: float) -> float:
	var p := clampf(passed, 0.0, 1.0)
	return p * p * p * (10.0 + p * (6.0 * p - 15.0))


## A hand at rest is never exactly still.
static func tremor(time_s: float) -> Vector3:
	return 1e-4 * Vector3(sin(time_s * 777.0), cos(time_s * 555.0), 0.0)


## Empties `events`, and from then on appends "started", "aborted" and "ended".
static func listen(hmm: GestureHMM, events: Array[String]) -> void:
	events.clear()
	hmm.gesture_started.connect(
		func(_gesture: StringName, _task: GestureTask) -> void: events.append("started")
	)
	hmm.gesture_aborted.connect(
		func(_gesture: StringName, _task: GestureTask) -> void: events.append("aborted")
	)
	hmm.gesture_ended.connect(
		func(_gesture: StringName, _time_s: float, _task: GestureTask, _fraction: float) -> void:
			events.append("ended")
	)
