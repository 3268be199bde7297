extends "tool.gd"
## xvfb-run -a godot --rendering-method gl_compatibility --rendering-driver opengl3
##     --audio-driver Dummy --path demo_project --script res://tools/screenshot.gd --
##     --out FILE.png [--trials DIR]
##
## A picture of the drag scene in the middle of a trial of --trials (default: a synthetic person).

const TaskScene := preload("res://scripts/task_scene.gd")

const SCENE := "res://scenes/horizontal_drag.tscn"
const STEP_S := 1e-3
## Share of the way at which the picture is taken.
const MOMENT := 0.6
## The trial's task is in its place, and shaders are compiled and labels laid out, in these frames.
const PLACED_FRAME := 3
const SETTLED_FRAME := 8

var _frame := 0
var _out_file := ""
var _scene: TaskScene = null


func _process(_delta: float) -> bool:
	_frame += 1
	if _frame == 1:
		work(OS.get_cmdline_user_args())
	elif _frame == PLACED_FRAME:
		_play_half()
	elif _frame == SETTLED_FRAME:
		_save()
	if _frame == SETTLED_FRAME or _scene == null:
		quit(exit_code)
	return false


func work(arguments: PackedStringArray) -> void:
	var options := CommandLine.new(arguments, {out = "", trials = ""})
	_out_file = options.path("out")
	var trials_folder := options.optional_path("trials")
	if not options.error.is_empty():
		fail(options.error, EXIT_BAD_INPUT)
		return
	var scene: TaskScene = (load(SCENE) as PackedScene).instantiate()
	scene.autoplay = false
	scene.trial_folder = trials_folder
	scene.log_folder = _out_file.get_base_dir().path_join("logs/screenshot")
	var tracker: HandTracker = scene.get_node("HandTracker")
	tracker.update_mode = HandTracker.UPDATE_MANUAL
	root.add_child(scene)
	scene.play_next()
	_scene = scene


func _play_half() -> void:
	var moment_m := MOMENT * _scene.task.amplitude
	while _scene.gesture_hmm.value < moment_m and not _scene.tracker.is_finished():
		_scene.tracker.advance(STEP_S)


func _save() -> void:
	var saved := root.get_texture().get_image().save_png(_out_file)
	if saved == OK:
		print("wrote %s" % _out_file)
		exit_code = 0
	else:
		fail("cannot write %s: %s" % [_out_file, error_string(saved)], EXIT_BAD_INPUT)
