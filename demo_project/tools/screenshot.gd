extends "tool.gd"
## xvfb-run -a godot --rendering-method gl_compatibility --rendering-driver opengl3
##     --audio-driver Dummy --path demo_project --script res://tools/screenshot.gd --
##     --out DIR [--trials DIR]
##
## A picture of each task's scene, DIR/scene_GESTURE.png, in the middle of the first trial of
## --trials (default: a synthetic person's); one with the debug overlay, DIR/overlay.png; and the
## inspector's previews of the effects, DIR/effects.png. Of the study, DIR/study_*.png: a trial of
## each gesture, the questionnaire, a rest, the operator's panel, and what the headset shows.

const Tasks := preload("res://scripts/tasks.gd")
const TaskScene := preload("res://scripts/task_scene.gd")

const StudyScene := preload("res://study/study_scene.gd")

const DebugOverlay := preload("res://addons/steadyhand/debug_overlay.gd")
const EffectPreview := preload("res://addons/steadyhand/editor/effect_preview.gd")

const STEP_S := 1e-3
## Share of the amplitude at which the picture is taken.
const MOMENT := 0.6
## Frames until the trial's task is placed; until shaders are compiled and labels laid out.
const PLACING_FRAMES := 2
const SETTLING_FRAMES := 5
const OVERLAY := "res://addons/steadyhand/debug_overlay.tscn"
## Steps of the motion between two pictures.
const OVERLAY_STEPS := 16
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
		await _draw_overlay(out_folder)
		for gesture in Tasks.SCENES:
			await _draw(gesture, trials_folder, out_folder)
		for gesture in Tasks.SCENES:
			await _draw_study(gesture, out_folder)
		await _draw_headset(out_folder)
	quit(exit_code)


func _draw(gesture: String, trials_folder: String, out_folder: String) -> void:
	var scene := _open_task(gesture, trials_folder, out_folder)
	for i in PLACING_FRAMES:
		await process_frame
	var strip: HapticStrip = scene.get_node("Readout/Panel/Rows/Vibration")
	var moment_m := MOMENT * scene.task.amplitude
	while scene.gesture_hmm.value < moment_m and not scene.tracker.is_finished():
		scene.tracker.advance(STEP_S)
		strip.note()
	for i in SETTLING_FRAMES:
		await process_frame
	_save(out_folder.path_join("scene_%s.png" % gesture), root.get_texture().get_image())
	scene.free()


## A simulated hand and an inaccurate tracker, so that the two points differ.
func _draw_overlay(out_folder: String) -> void:
	var scene := _open_task(Tasks.SCENES.keys()[0], "", out_folder)
	(scene.get_node("Readout") as CanvasLayer).visible = false
	var overlay := (load(OVERLAY) as PackedScene).instantiate() as DebugOverlay
	overlay.gesture_hmm = scene.gesture_hmm
	scene.add_child(overlay)
	for i in PLACING_FRAMES:
		await process_frame
	var moment_m := MOMENT * scene.task.amplitude
	while scene.gesture_hmm.value < moment_m and not scene.tracker.is_finished():
		for step in OVERLAY_STEPS:
			scene.tracker.advance(STEP_S)
		await process_frame
	for i in SETTLING_FRAMES:
		await process_frame
	_save(out_folder.path_join("overlay.png"), root.get_texture().get_image())
	scene.free()


## Opens the scene and begins its first trial.
func _open_task(gesture: String, trials_folder: String, out_folder: String) -> TaskScene:
	var scene: TaskScene = (load(Tasks.SCENES[gesture]) as PackedScene).instantiate()
	scene.autoplay = false
	scene.trial_folder = trials_folder
	scene.log_folder = out_folder.path_join("replays")
	var tracker: HandTracker = scene.get_node("HandTracker")
	tracker.update_mode = HandTracker.UPDATE_MANUAL
	root.add_child(scene)
	scene.play_next()
	return scene


## Draws a trial; for the first gesture also the questionnaire and the rest.
func _draw_study(gesture: String, out_folder: String) -> void:
	var scene := _open_study(gesture)
	await _begin_trial(scene, "study_%s" % gesture, out_folder)
	if gesture == Tasks.SCENES.keys()[0]:
		scene.operator_window.visible = true
		for i in SETTLING_FRAMES:
			await process_frame
		var image := scene.operator_window.get_texture().get_image()
		_save(out_folder.path_join("study_operator.png"), image)
		scene.operator_window.visible = false
		await _draw_questionnaire_and_rest(scene, "study", out_folder)
	scene.free()


func _draw_headset(out_folder: String) -> void:
	var scene := _open_study("horizontal_drag")
	scene.make_display()
	var camera := Camera3D.new()
	camera.fov = 75.0
	camera.near = 0.01
	scene.add_child(camera)
	camera.look_at_from_position(StudyScene.SEAT, Vector3(0.0, 0.05, -0.25))
	camera.current = true
	await _begin_trial(scene, "study_headset", out_folder)
	await _draw_questionnaire_and_rest(scene, "study_headset", out_folder)
	scene.free()


## Skips the trial under way, and answers.
func _draw_questionnaire_and_rest(scene: StudyScene, name: String, out_folder: String) -> void:
	scene.skip()
	for i in SETTLING_FRAMES:
		await process_frame
	var panel: QuestionnairePanel = scene.runner.panel
	panel.call("choose", 3)
	for i in SETTLING_FRAMES:
		await process_frame
	_save(out_folder.path_join("%s_questionnaire.png" % name), root.get_texture().get_image())
	while scene.runner.state == StudyRunner.State.ASKING:
		panel.call("skip_item")
	for i in SETTLING_FRAMES:
		await process_frame
	_save(out_folder.path_join("%s_rest.png" % name), root.get_texture().get_image())


## A study with one participant, who makes one gesture and then rests.
func _open_study(gesture: String) -> StudyScene:
	var protocol := StudyProtocol.paper()
	protocol.gestures = [gesture]
	protocol.practice_trials = 0
	protocol.rest_after_trials = 1
	protocol.questionnaires[0] = protocol.questionnaires[0].duplicate()
	protocol.questionnaires[0].after_trials = 1
	var source := SyntheticSource.new()
	source.gesture = gesture
	var scene := (load(Tasks.STUDY) as PackedScene).instantiate() as StudyScene
	scene.protocol = protocol
	scene.source = source
	scene.study_folder = DirAccess.create_temp("steadyhand_screenshot").get_current_dir()
	root.add_child(scene)
	return scene


## A simulated hand makes the first trial up to MOMENT.
func _begin_trial(scene: StudyScene, name: String, out_folder: String) -> void:
	scene.run_session("p01")
	while scene.runner.task_scene == null:
		await process_frame
	var task := scene.runner.task_scene.task
	var tracker: HandTracker = scene.runner.hand.tracker
	var hmm := scene.runner.task_scene.gesture_hmm
	(scene.source as SyntheticSource).place_at(task)
	tracker.update_mode = HandTracker.UPDATE_MANUAL
	# The hand starts again, so the trial does too.
	scene.pause_or_continue()
	tracker.start()
	scene.pause_or_continue()
	while hmm.value < MOMENT * task.amplitude and not tracker.is_finished():
		tracker.advance(STEP_S)
	for i in SETTLING_FRAMES:
		await process_frame
	_save(out_folder.path_join("%s.png" % name), root.get_texture().get_image())


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
