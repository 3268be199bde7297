extends RefCounted
## A hand whose frames a test pushes to a HandTracker, and the signals of its GestureHMM.


## The share of the amplitude after the share `passed` of the duration: minimum jerk (Flash & Hogan
## 1985), at rest before and after.
static func share(passed: float) -> float:
	var p := clampf(passed, 0.0, 1.0)
	return p * p * p * (10.0 + p * (6.0 * p - 15.0))


## A hand at rest is never exactly still.
static func tremor(time_s: float) -> Vector3:
	return 1e-4 * Vector3(sin(time_s * 777.0), cos(time_s * 555.0), 0.0)


## Clears `events`, and then appends "started", "aborted" and "ended".
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
