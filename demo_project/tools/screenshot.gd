extends "tool.gd"
## xvfb-run -a godot --rendering-method gl_compatibility --rendering-driver opengl3
##     --audio-driver Dummy --path demo_project --script res://tools/screenshot.gd --
##     --out DIR [--trials DIR]
##
## A picture of each task's scene, DIR/scene_GESTURE.png, in the middle of the first trial of
## --trials (default: a synthetic person's).

const Tasks := preload("res://scripts/tasks.gd")
const TaskScene := preload("res://scripts/task_scene.gd")

const STEP_S := 1e-3
## Share of the way at which the picture is taken.
const MOMENT := 0.6
## Until the trial's task is in its place; until shaders are compiled and labels laid out.
const PLACING_FRAMES := 2
const SETTLING_FRAMES := 5

var _is_begun := false


func _process(_delta: float) -> bool:
	if not _is_begun:
		_is_begun = true
		_draw_all(OS.get_cmdline_user_args())
	return false


func _draw_all(arguments: PackedStringArray) -> void:
	var options := CommandLine.new(arguments, {out = "", trials = ""})
	var out_folder := options.path("out")
	var trials_folder := options.optional_path("trials")
	if not options.error.is_empty():
		fail(options.error, EXIT_BAD_INPUT)
	else:
		exit_code = 0
		for gesture in Tasks.SCENES:
			await _draw(gesture, trials_folder, out_folder)
	quit(exit_code)


func _draw(gesture: String, trials_folder: String, out_folder: String) -> void:
	var scene: TaskScene = (load(Tasks.SCENES[gesture]) as PackedScene).instantiate()
	scene.autoplay = false
	scene.trial_folder = trials_folder
	scene.log_folder = out_folder.path_join("logs/screenshot")
	var tracker: HandTracker = scene.get_node("HandTracker")
	tracker.update_mode = HandTracker.UPDATE_MANUAL
	root.add_child(scene)
	scene.play_next()
	for i in PLACING_FRAMES:
		await process_frame
	var moment_m := MOMENT * scene.task.amplitude
	while scene.gesture_hmm.value < moment_m and tracker.is_running() and not tracker.is_finished():
		tracker.advance(STEP_S)
	for i in SETTLING_FRAMES:
		await process_frame
	var path := out_folder.path_join("scene_%s.png" % gesture)
	var saved := root.get_texture().get_image().save_png(path)
	if saved == OK:
		print("wrote %s" % path)
	else:
		fail("cannot write %s: %s" % [path, error_string(saved)], EXIT_BAD_INPUT)
	scene.free()
