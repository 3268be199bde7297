extends "tool.gd"
## xvfb-run -a godot --rendering-method gl_compatibility --rendering-driver opengl3
##     --audio-driver Dummy --path demo_project --script res://tools/screenshot.gd --
##     --out DIR [--trials DIR]
##
## A picture of each task's scene, DIR/scene_GESTURE.png, in the middle of the first trial of
## --trials (default: a synthetic person's), and of the inspector's previews of the effects,
## DIR/effects.png.

const Tasks := preload("res://scripts/tasks.gd")
const TaskScene := preload("res://scripts/task_scene.gd")

const EffectPreview := preload("res://addons/steadyhand/editor/effect_preview.gd")

const STEP_S := 1e-3
## Share of the way at which the picture is taken.
const MOMENT := 0.6
## Until the trial's task is in its place; until shaders are compiled and labels laid out.
const PLACING_FRAMES := 2
const SETTLING_FRAMES := 5
const PREVIEW_WIDTH := 320
const SPACE := 16

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
		await _draw_effects(out_folder)
		for gesture in Tasks.SCENES:
			await _draw(gesture, trials_folder, out_folder)
	quit(exit_code)


func _draw(gesture: String, trials_folder: String, out_folder: String) -> void:
	var scene: TaskScene = (load(Tasks.SCENES[gesture]) as PackedScene).instantiate()
	scene.autoplay = false
	scene.trial_folder = trials_folder
	scene.log_folder = out_folder.path_join("replays")
	var tracker: HandTracker = scene.get_node("HandTracker")
	tracker.update_mode = HandTracker.UPDATE_MANUAL
	root.add_child(scene)
	scene.play_next()
	for i in PLACING_FRAMES:
		await process_frame
	var strip: HapticStrip = scene.get_node("Readout/Panel/Rows/Vibration")
	var moment_m := MOMENT * scene.task.amplitude
	while scene.gesture_hmm.value < moment_m and tracker.is_running() and not tracker.is_finished():
		tracker.advance(STEP_S)
		strip.note()
	for i in SETTLING_FRAMES:
		await process_frame
	_save(out_folder.path_join("scene_%s.png" % gesture), root.get_texture().get_image())
	scene.free()


func _draw_effects(out_folder: String) -> void:
	var grid := GridContainer.new()
	grid.columns = 3
	grid.add_theme_constant_override("h_separation", SPACE)
	var effects: Array[HapticEffect] = [
		SpringEffect.new(), InertialViscousEffect.new(), ImpulseEffect.new()
	]
	for effect in effects:
		var title := Label.new()
		title.text = effect.get_class()
		grid.add_child(title)
	for effect in effects:
		var preview := EffectPreview.new()
		preview.effect = effect
		preview.custom_minimum_size.x = PREVIEW_WIDTH
		grid.add_child(preview)
	grid.position = Vector2(SPACE, SPACE)
	root.add_child(grid)
	for i in SETTLING_FRAMES:
		await process_frame
	var shown := Rect2i(0, 0, ceili(grid.size.x) + 2 * SPACE, ceili(grid.size.y) + 2 * SPACE)
	_save(out_folder.path_join("effects.png"), root.get_texture().get_image().get_region(shown))
	grid.free()


func _save(path: String, image: Image) -> void:
	var saved := image.save_png(path)
	if saved == OK:
		print("wrote %s" % path)
	else:
		fail("cannot write %s: %s" % [path, error_string(saved)], EXIT_BAD_INPUT)
