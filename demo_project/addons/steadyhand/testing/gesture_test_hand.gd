@icon("../icons/hand_source.svg")
class_name GestureTestHand
extends HandSource
## A simulated hand that a test moves. Its methods last as long as the motion: call them with
## `await` to wait for the end, or without it to continue at once.
##
## The hand's time is the game's. Run tests with `godot --headless --fixed-fps 90`: they are
## repeatable then, and faster than real time.
## [codeblock]
## var hand := GestureTestHand.attach($Hand)
## await hand.make_gesture($Key/GestureTask)
## [/codeblock]

## A frame of the game is over, or the tracker has stopped: no method waits forever.
signal frame_passed

const HandPose := preload("../hands/hand_pose.gd")
const MinimumJerk := preload("../hands/minimum_jerk.gd")

## Default durations of make_gesture() from onset to end, s.
const DURATIONS_S: Dictionary[StringName, float] = {&"tap": 0.3}
const DURATION_S := 0.8
## Rest before and after a gesture, s. Without a rest at the start no gesture is recognised.
const REST_S := 0.7
const FINGERS_S := 0.15
## White noise of the tracker on each axis. Without it a freeze looks like a hand at rest.
const NOISE_M := 2e-4

## make_gesture() pinches at the start of a task and releases at the end.
var pinches := false
## make_gesture() is running.
var is_busy := false

var _tracker: HandTracker = null
var _tree: SceneTree = null
## When the hand was first seen, on the clock of live devices. NAN: not yet.
var _first_s := NAN
## The game's time since then. Live devices do not follow Engine.time_scale, but the hand does.
var _time_s := 0.0
var _place := MinimumJerk.new(Vector3.ZERO)
var _thumb_gap := MinimumJerk.new(HandPose.OPEN_M)
## Radius of the three tips' circle, m. 0: the hand points.
var _radius := MinimumJerk.new(0.0)
var _lost_until_s := -INF
var _frozen_until_s := -INF
var _jumped_until_s := -INF
var _jump := Vector3.ZERO
var _last_joints := {}
var _random := RandomNumberGenerator.new()
## Of make_gesture(). The last one is in effect.
var _calls := 0


func _init() -> void:
	_random.seed = 0


## Makes a hand the source of `tracker`, which must be in the tree, and starts it. `faults` spoil
## the tracking at random. For single faults see drop_out(), freeze() and jump().
static func attach(tracker: HandTracker, faults: DegradedSource = null) -> GestureTestHand:
	var hand := GestureTestHand.new()
	if tracker == null:
		push_error("GestureTestHand: attach() needs a HandTracker, is null.")
		return hand
	if faults != null:
		faults.source = hand
	tracker.source = hand if faults == null else faults
	tracker.start()
	return hand


## Where the tip of the index finger is, or the middle of a zoom's three tips; m, without tremor.
func get_place() -> Vector3:
	return _place.at(_time_s)


## Puts the hand somewhere at once, m. Only before it was first seen.
func place_at(place: Vector3) -> void:
	_place = MinimumJerk.new(place)


## Goes to the start of `task` and rests there. A hand that has not been seen yet appears there.
func reach(task: GestureTask) -> void:
	if task == null:
		push_error("GestureTestHand: reach() needs a GestureTask, is null.")
		return
	if is_nan(_first_s):
		place_at(task.get_start())
	_place.go(task.get_start(), _time_s, DURATION_S)
	_radius.go(task.start_radius, _time_s, DURATION_S)
	await rest(DURATION_S + REST_S)


## Goes to the start of `task`, rests, makes its gesture in `duration_s` (0: default) and rests
## again. `fraction`: of the task's amplitude, 0 to 1, where the hand stops. Farther: move_to().
## If another gesture is running, the hand leaves it and makes this one.
func make_gesture(task: GestureTask, duration_s := 0.0, fraction := 1.0) -> void:
	if task == null:
		push_error("GestureTestHand: make_gesture() needs a GestureTask, is null.")
		return
	if duration_s < 0.0 or fraction < 0.0 or fraction > 1.0:
		var rule := "duration_s must be 0 or more, and fraction 0..1"
		push_error("GestureTestHand: %s, are %s and %s." % [rule, duration_s, fraction])
		return
	if duration_s == 0.0:
		duration_s = DURATIONS_S.get(task.gesture, DURATION_S)
	var way := fraction * task.amplitude
	if is_busy and pinches:
		_thumb_gap.go(HandPose.OPEN_M, _time_s, FINGERS_S)
	is_busy = true
	_calls += 1
	var call_number := _calls
	await reach(task)
	if pinches and _calls == call_number:
		await pinch()
	# If the tracker has stopped, the scene has ended, and the task with it.
	if _tracker != null and _calls == call_number:
		if task.start_radius > 0.0:
			await spread(task.start_radius + way, duration_s)
		else:
			await move_to(task.get_start() + way * task.get_axis(), duration_s)
	if _calls == call_number:
		await rest(REST_S)
	if pinches and _calls == call_number:
		await release()
	if _calls == call_number:
		is_busy = false


## Moves to `place`, m, in `duration_s`.
func move_to(place: Vector3, duration_s: float) -> void:
	_place.go(place, _time_s, duration_s)
	await rest(duration_s)


## Opens or closes the circle of thumb, index and middle finger to `radius_m`.
func spread(radius_m: float, duration_s: float) -> void:
	_radius.go(radius_m, _time_s, duration_s)
	await rest(duration_s)


func pinch() -> void:
	_thumb_gap.go(HandPose.PINCHED_M, _time_s, FINGERS_S)
	await rest(FINGERS_S)


func release() -> void:
	_thumb_gap.go(HandPose.OPEN_M, _time_s, FINGERS_S)
	await rest(FINGERS_S)


## The tracker does not see the hand for `duration_s` from now on. Does not wait.
func drop_out(duration_s: float) -> void:
	_lost_until_s = _time_s + duration_s


## The tracker repeats its last position for `duration_s` from now on. Does not wait.
func freeze(duration_s: float) -> void:
	_frozen_until_s = _time_s + duration_s


## The tracker shows the hand `offset` (m) away from its place for `duration_s`. Does not wait.
func jump(offset: Vector3, duration_s: float) -> void:
	_jump = offset
	_jumped_until_s = _time_s + duration_s


## Waits for `duration_s` of the game's time. The hand continues its motion.
func rest(duration_s: float) -> void:
	var until_s := _time_s + duration_s
	while _time_s < until_s and _is_followed():
		await frame_passed


## Whether `awaited` is emitted within `timeout_s` of the game's time.
func wait_for(awaited: Signal, timeout_s: float) -> bool:
	var seen: Array[bool] = []
	_note(awaited, seen)
	var until_s := _time_s + timeout_s
	while seen.is_empty() and _time_s < until_s and _is_followed():
		await frame_passed
	return not seen.is_empty()


## `await` takes a signal with any number of arguments.
static func _note(awaited: Signal, seen: Array[bool]) -> void:
	await awaited
	seen.append(true)


func _start(tracker: HandTracker) -> String:
	if not tracker.is_inside_tree():
		return "add the HandTracker to the scene tree before GestureTestHand.attach()"
	_tracker = tracker
	_tree = tracker.get_tree()
	_tree.process_frame.connect(frame_passed.emit)
	return ""


func _poll(tracker: HandTracker, time_s: float) -> void:
	if is_nan(_first_s):
		_first_s = time_s
	elif Engine.is_in_physics_frame():
		_time_s += tracker.get_physics_process_delta_time()
	else:
		_time_s += tracker.get_process_delta_time()
	if _time_s >= _frozen_until_s:
		_last_joints = _joints()
	tracker.push_frame(_first_s + _time_s, {} if _time_s < _lost_until_s else _last_joints)


func _stop(_stopped: HandTracker) -> void:
	_tree.process_frame.disconnect(frame_passed.emit)
	_tracker = null
	frame_passed.emit()


## False once the tracker has stopped, as at the end of a scene: then no method waits.
func _is_followed() -> bool:
	if _tracker == null and is_nan(_first_s):
		push_error("GestureTestHand: no HandTracker follows it. Call attach() first.")
	if _tracker == null:
		return false
	var is_manual := _tracker.update_mode == HandTracker.UPDATE_MANUAL
	if is_manual or not _tracker.can_process():
		push_error(
			(
				"GestureTestHand: its time does not advance, because HandTracker '%s' is %s."
				% [
					_tracker.name,
					(
						"in UPDATE_MANUAL. Set another update_mode"
						if is_manual
						else "paused or disabled. Let it process"
					)
				]
			)
		)
		return false
	return true


func _joints() -> Dictionary:
	var noise := Vector3(_random.randfn(), _random.randfn(), _random.randfn())
	var place := get_place() + HandPose.tremor(_time_s) + NOISE_M * noise
	if _time_s < _jumped_until_s:
		place += _jump
	var radius: float = _radius.at(_time_s)
	if radius > 0.0:
		return HandPose.circle(place, radius)
	return HandPose.pointing(place, _thumb_gap.at(_time_s) as float)
