extends "../scenes/support/scene_test.gd"
## XRSource on the hands of an OpenXR runtime: Monado, whose simulated devices the test moves.

const MonadoHands := preload("monado_hands.gd")
const PushedHand := preload("../scenes/support/pushed_hand.gd")

const LEFT := MonadoHands.Hand.LEFT
const RIGHT := MonadoHands.Hand.RIGHT
const INDEX := HandTracker.JOINT_INDEX
const SESSION_S := 15.0
const REST_S := 1.0
const DRAG_M := 0.2
const DRAG_S := 0.8
const TOLERANCE_M := 0.003
## Beyond the end while the hand still moves: a late frame makes the motion go too far for a moment.
const OVERSHOOT_M := 0.01
const LOSS_S := 0.6

var _hands := MonadoHands.new()
var _scene: Node
var _right: HandTracker
var _left: HandTracker
var _hmm: GestureHMM
var _start := Vector3.ZERO
var _said: Array[String] = []
var _most := 0.0
var _farthest_m := 0.0


func _run() -> void:
	var reason := await _begin()
	check_equal(reason, "", "hands of an OpenXR runtime")
	if reason == "":
		process_frame.connect(_watch)
		await super()
	else:
		await _finish()


## Godot 4.6.3 crashes where it ends an OpenXR session.
func _end(_status: int) -> void:
	_hands.stop()
	OS.kill(OS.get_process_id())


func test_a_drag_starts_and_ends_once() -> void:
	for way: String in ["first", "second"]:
		await _rest_at_start()
		_said.clear()
		_most = 0.0
		_farthest_m = 0.0
		await _drag()
		check_equal(_said, ["started", "ended"] as Array[String], "the %s drag" % way)
		check_near(_hmm.value, DRAG_M, TOLERANCE_M, "its amplitude in m")
		check(_farthest_m < DRAG_M + OVERSHOOT_M, "no further than %s m" % _farthest_m)
		check(_most > 0.1, "it vibrates: %s" % _most)


func test_both_hands_at_once() -> void:
	await _rest_at_start()
	var right_from := _right.get_joint_position(INDEX)
	var left_from := _left.get_joint_position(INDEX)
	_hands.move(LEFT, _hands.position(LEFT) + Vector3(0.0, 0.1, 0.0), DRAG_S)
	await _drag()
	var right_way := _right.get_joint_position(INDEX) - right_from
	var left_way := _left.get_joint_position(INDEX) - left_from
	check(right_way.distance_to(Vector3(DRAG_M, 0.0, 0.0)) < TOLERANCE_M, "right: %s" % right_way)
	check(left_way.distance_to(Vector3(0.0, 0.1, 0.0)) < TOLERANCE_M, "left: %s" % left_way)


func test_a_dropout_of_one_hand_is_told_once() -> void:
	await _rest_at_start()
	var told: Array[String] = []
	_right.tracking_lost.connect(func() -> void: told.append("right lost"))
	_right.tracking_restored.connect(func() -> void: told.append("right restored"))
	_left.tracking_lost.connect(func() -> void: told.append("left lost"))
	_hands.set_tracked(RIGHT, false)
	await _wait(LOSS_S)
	_hands.set_tracked(RIGHT, true)
	await _wait(REST_S)
	check_equal(told, ["right lost", "right restored"] as Array[String], "of %s s" % LOSS_S)


## Opens the session and finds where the right hand must be for its index tip to be at the task's
## start. Returns what failed, or nothing.
func _begin() -> String:
	var xr := XRServer.find_interface("OpenXR") as OpenXRInterface
	if xr == null or not xr.is_initialized():
		return "Godot opened no OpenXR session"
	root.use_xr = true
	xr.render_target_size_multiplier = 0.1
	var reason := _hands.start()
	if reason != "":
		return reason
	var folder := (get_script() as Script).resource_path.get_base_dir()
	var packed := load(folder.path_join("../scenes/support/no_script.tscn")) as PackedScene
	_scene = packed.instantiate()
	root.add_child(_scene)
	_right = _scene.get_node("HandTracker") as HandTracker
	_hmm = _scene.get_node("GestureHMM") as GestureHMM
	var source := XRSource.new()
	source.hand = HandTracker.HAND_LEFT
	_left = HandTracker.new()
	_left.source = source
	_scene.add_child(_left)
	for tracker: HandTracker in [_right, _left]:
		var waited_s := await _wait(SESSION_S, tracker.is_hand_tracked)
		if not tracker.is_hand_tracked():
			return "no hand in %s s" % waited_s
	await _wait(0.5)
	var task := _scene.get_node("GestureTask") as GestureTask
	_start = _hands.position(RIGHT) + task.get_start() - _right.get_joint_position(INDEX)
	PushedHand.listen(_hmm, _said)
	return ""


func _watch() -> void:
	_most = maxf(_most, (_scene.get_node("HapticSynth") as HapticSynth).get_amplitude())
	_farthest_m = maxf(_farthest_m, _hmm.value)


func _rest_at_start() -> void:
	_hands.move(RIGHT, _start, 0.5)
	await _wait(0.5 + REST_S)


func _drag() -> void:
	_hands.move(RIGHT, _start + Vector3(DRAG_M, 0.0, 0.0), DRAG_S)
	await _wait(DRAG_S + REST_S)


## Waits until it is so, for as long as that at most; the time that it took, s.
func _wait(seconds: float, is_so := Callable()) -> float:
	var begin_us := Time.get_ticks_usec()
	var waited_s := 0.0
	while waited_s < seconds and not (is_so.is_valid() and is_so.call()):
		await process_frame
		waited_s = 1e-6 * (Time.get_ticks_usec() - begin_us)
	return waited_s
