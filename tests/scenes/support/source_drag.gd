extends RefCounted
## The demo's horizontal drag with a live hand of a source: one trial, from the box's start
## marker to its stop marker.

const DragStage := preload("res://scripts/drag_stage.gd")
const SceneTest := preload("scene_test.gd")
const TaskPlayer := preload("task_player.gd")

const STEP_S := 1.0 / 90.0

var player: TaskPlayer = null
var tracker: HandTracker = null
## Failures that the tracker and the GestureHMM reported.
var failures: Array[String] = []
var losses := 0
var ends := 0


## The task starts at `start`.
func _init(tree: SceneTree, log_folder: String, start: Vector3) -> void:
	player = TaskPlayer.new("horizontal_drag", log_folder, tree)
	player.scene.task.global_position = start
	tracker = player.scene.tracker
	tracker.failed.connect(func(reason: String) -> void: failures.append(reason))
	tracker.tracking_lost.connect(func() -> void: losses += 1)
	player.scene.gesture_hmm.gesture_ended.connect(
		func(_gesture: StringName, _time_s: float, _task: GestureTask, _fraction: float) -> void:
			ends += 1
	)


func begin(source: HandSource) -> void:
	player.scene.follow_live(source)
	var stage := player.scene.get_node("Stage") as DragStage
	stage.place(player.scene.task, "")


## Steps the tracker of a source with its own frames. `move` is called with the time before each
## step.
func step_for(seconds: float, move: Callable = Callable()) -> void:
	for step in int(seconds / STEP_S):
		if move.is_valid():
			move.call(step * STEP_S)
		if tracker.source is not ScriptSource and not tracker.is_finished():
			tracker.advance(STEP_S)


## Runs in real time until a gesture has ended or `patience_s` is over.
func wait(tree: SceneTree, patience_s: float) -> void:
	await wait_until(tree, patience_s, func() -> bool: return ends > 0)


## The same, until `is_over` is true.
func wait_until(tree: SceneTree, patience_s: float, is_over: Callable) -> void:
	tracker.update_mode = HandTracker.UPDATE_IDLE
	Engine.max_fps = 120
	var began_ms := Time.get_ticks_msec()
	while not is_over.call() and Time.get_ticks_msec() - began_ms < 1e3 * patience_s:
		await tree.process_frame
	Engine.max_fps = 0


func check(test: SceneTest, what: String, tolerance_m: float = 0.01) -> void:
	test.check_equal(ends, 1, "%s: one drag" % what)
	test.check_near(player.scene.course.end_value_m, 0.2, tolerance_m, "%s: of 20 cm" % what)
	test.check_equal(player.colour("StopMarker"), DragStage.ARRIVED, "%s: the stop is red" % what)


func free_scene() -> void:
	player.scene.free()
