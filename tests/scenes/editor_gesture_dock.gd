extends "support/editor_test.gd"
## The editor's "Gestures" panel, from a recording to a model that recognises the gesture.

const ModelComparison := preload("res://addons/steadyhand/editor/gestures/model_comparison.gd")
const TakeView := preload("res://addons/steadyhand/editor/gestures/take_view.gd")
const RecordedGestures := preload("support/recorded_gestures.gd")

const WAY := Vector3(0.15, 0.2, 0.0)
const GESTURE := "shelf"

var _folder := DirAccess.create_temp("steadyhand_takes")


func test_a_gesture_of_ones_own() -> void:
	await _open_scene(ScriptSource.new())
	check_equal(dock.takes, null, "no gesture is open")
	check(dock.hint().begins_with("Name the gesture"), "the hint is the first step")
	dock.open_gesture("my gesture")
	check(dock.get_message().contains("letters, digits and _"), "an invalid name is refused")

	dock.open_gesture(GESTURE)
	check(dock.hint().begins_with("Press Record"), "the hint is the next step")
	check(dock.start_recording(), "it records: %s" % dock.get_message())
	var hand := RecordedGestures.new(dock.get_recorder().get_tracker())
	hand.repeat(WAY, 8)
	check(dock.get_recorder().describe(null).begins_with("Hand tracked, 90 Hz"), "live state")
	dock.stop_recording()
	check_equal(dock.takes.rows.size(), 8, "each movement is a take, but not the way back")
	for row in dock.takes.rows:
		check_near(row["amplitude_m"], WAY.length(), 0.005, "amplitude of %s" % row["trial"])
	var files := DirAccess.get_files_at(dock.takes.folder)
	check("trials.csv" in files and "001_8.measured.csv" in files, "a trial set in the project")
	check("recording_001.csv" in files, "the whole recording is kept")

	dock.train()
	await dock.training_finished
	check_equal(dock.get_message(), "", "the training has no error")
	check(dock.model != null and dock.model.gesture == GESTURE, "a model of the gesture")
	check_near(dock.model.duration_mean, 0.6, 0.15, "its duration is that of the takes")

	dock.compare()
	await dock.comparison_finished
	check_equal(_row(GESTURE), {GESTURE: 8}, "all takes are recognised among all models")

	_press("Save...")
	var dialog := dock.find_children("*", "EditorFileDialog", true, false)[0] as EditorFileDialog
	check(dialog.visible and dialog.current_file == "shelf.gesture", "it asks where to save")
	dialog.hide()
	var path := _folder.get_current_dir().path_join("shelf.gesture")
	check_equal(dock.save(path), OK, "saved")
	_check_recognises(load(path) as GestureModel)


func test_trim_and_delete_are_undone() -> void:
	await _open_scene(ScriptSource.new())
	dock.open_gesture("undone")
	dock.start_recording()
	RecordedGestures.new(dock.get_recorder().get_tracker()).repeat(WAY, 3)
	dock.stop_recording()
	var recorded := dock.takes.rows.duplicate(true)
	var undo := dock.undo_redo.get_history_undo_redo(EditorUndoRedoManager.GLOBAL_HISTORY)
	dock.trim_take(1, recorded[1]["start_s"] + 0.1, recorded[1]["end_s"])
	check(dock.takes.rows[1]["amplitude_m"] < recorded[1]["amplitude_m"], "trimmed")
	dock.propose_trim(1)
	check_near(dock.takes.rows[1]["start_s"], recorded[1]["start_s"], 0.01, "trimmed as proposed")
	dock.delete_takes([0, 2])
	check_equal(dock.takes.rows.size(), 1, "deleted")
	var stored := TrialSet.load_folder(dock.takes.folder)
	check_equal(stored.get_count(), 1, "on the disk too")
	check(FileAccess.file_exists(dock.takes.folder.path_join("001_1.measured.csv")), "files stay")
	undo.undo()
	check_equal(dock.takes.rows.size(), 3, "the deletion is undone")
	undo.undo()
	undo.undo()
	check_equal(dock.takes.rows[1]["start_s"], recorded[1]["start_s"], "the trim is undone")


func test_an_edge_is_dragged() -> void:
	await _open_scene(ScriptSource.new())
	EditorPlugin.new().make_bottom_panel_item_visible(dock)
	dock.open_gesture("dragged")
	dock.start_recording()
	RecordedGestures.new(dock.get_recorder().get_tracker()).repeat(WAY, 1)
	dock.stop_recording()
	var row := dock.takes.rows[0]
	var view: TakeView = null
	for control in dock.find_children("*", "Control", true, false):
		view = control as TakeView if control is TakeView else view
	for frame in 3:
		await process_frame
	var edge := view.get_edge(1)
	_drag(view, edge, edge - 0.1 * view.size.x)
	var end_s: float = dock.takes.rows[0]["end_s"]
	check(end_s < row["end_s"] and end_s > row["start_s"], "the end is earlier: %s" % end_s)
	check_equal(dock.takes.rows[0]["start_s"], row["start_s"], "the start is as it was")
	_drag(view, view.get_edge(0), 2.0 * view.size.x)
	check(dock.takes.rows[0]["start_s"] < end_s, "the start stays before the end")


func test_an_interrupted_recording_is_restored() -> void:
	await _open_scene(ScriptSource.new())
	dock.open_gesture("cut_off")
	dock.start_recording()
	RecordedGestures.new(dock.get_recorder().get_tracker()).repeat(WAY, 2)
	# As if the editor was closed here.
	var folder := dock.takes.folder
	dock.get_recorder().end()
	check(FileAccess.file_exists(folder.path_join("recording_001.part.csv")), "it is on the disk")
	dock.open_gesture("cut_off")
	check_equal(dock.takes.rows.size(), 2, "its takes are restored")
	check(
		dock.get_message().contains("2 takes of a recording that was cut off"),
		"the message names them"
	)


func test_a_row_that_cannot_be_read_is_kept_in_a_copy() -> void:
	await _open_scene(ScriptSource.new())
	dock.open_gesture("spoilt")
	dock.start_recording()
	RecordedGestures.new(dock.get_recorder().get_tracker()).repeat(WAY, 2)
	dock.stop_recording()
	var table := dock.takes.folder.path_join("trials.csv")
	var spoilt := FileAccess.get_file_as_string(table).replace(
		"001_2,spoilt,stable", "001_2,spoilt,lost"
	)
	FileAccess.open(table, FileAccess.WRITE).store_string(spoilt)
	# expects error: is neither stable nor unstable
	dock.open_gesture("spoilt")
	check_equal(dock.takes.rows.size(), 1, "the other take is kept")
	check(dock.get_message().contains("A copy is kept as .bak"), dock.get_message())
	check_equal(FileAccess.get_file_as_string(table + ".bak"), spoilt, "all rows are in the copy")


func test_a_circle() -> void:
	await _open_scene(ScriptSource.new())
	dock.open_gesture("loop")
	dock.start_recording()
	var hand := RecordedGestures.new(dock.get_recorder().get_tracker())
	hand.rest(0.6)
	for i in 4:
		hand.circle(0.08, 1.0 + 0.1 * i)
		hand.rest(0.6)
	hand.circle(0.08, 1.0, -1.0)
	hand.rest(0.6)
	dock.stop_recording()
	check_equal(dock.takes.rows.size(), 4, "counterclockwise ones alone")
	for row in dock.takes.rows:
		check_near(row["amplitude_m"], TAU * 0.08, 0.02, "the circumference")
		check_near((row["axis"] as Vector3).x, 1.0, 0.05, "it begins to the right")
	dock.train()
	await dock.training_finished
	check(dock.model != null and dock.model.feature == "index_along_circle", "by its feature")


func test_simulated_people_make_a_take_at_each_press() -> void:
	var source := SyntheticSource.new()
	source.gesture = &"zoom"
	await _open_scene(source)
	dock.open_gesture("spread")
	for take in 3:
		check(dock.start_recording(), dock.get_message())
		dock.get_recorder().get_tracker().advance(20.0)
		await process_frame
	check_equal(dock.takes.rows.size(), 3, "the end of the track ends the recording")
	var axis: Vector3 = dock.takes.rows[0]["axis"]
	check(axis.is_zero_approx(), "fingers that open are a radius")
	dock.train()
	await dock.training_finished
	check(dock.model != null and dock.model.feature == "tips_circumradius", "by its feature")


func test_the_dock_shows_errors() -> void:
	var tracker: HandTracker = await _open_scene(null)
	dock.open_gesture("nothing")
	check(not dock.start_recording(), "without a source nothing is recorded")
	check(dock.get_message().begins_with("Set the source of 'HandTracker'"), dock.get_message())
	dock.train()
	await dock.training_finished
	check_equal(dock.get_message(), "Record some takes first.", "nothing to train with")
	tracker.source = XRSource.new()
	dock.start_recording()
	check(dock.get_message().contains("only in a running game"), dock.get_message())
	tracker.source = ScriptSource.new()
	dock.start_recording()
	dock.stop_recording()
	check(dock.get_message().begins_with("The tracker sent no frame"), dock.get_message())
	dock.start_recording()
	RecordedGestures.new(dock.get_recorder().get_tracker()).rest(2.0)
	dock.stop_recording()
	check(dock.get_message().begins_with("No movement was found"), dock.get_message())


func test_an_edited_scene_opens_no_device() -> void:
	var tracker: HandTracker = await _open_scene(SyntheticSource.new())
	# expects error: start() opens no source in a scene that is edited
	check_equal(tracker.start(), ERR_UNAVAILABLE, "its tracker is not started")
	dock.open_gesture("closed")
	check(dock.start_recording(), "the panel records from its source")
	check(not tracker.is_running(), "the tracker stays closed")
	dock.stop_recording()


func _press(text: String) -> void:
	for button: Button in dock.find_children("*", "Button", true, false):
		if button.text == text:
			button.pressed.emit()


func _drag(view: TakeView, from_x: float, to_x: float) -> void:
	var click := InputEventMouseButton.new()
	click.button_index = MOUSE_BUTTON_LEFT
	click.pressed = true
	click.position = Vector2(from_x, 50.0)
	view._gui_input(click)
	var motion := InputEventMouseMotion.new()
	motion.position = Vector2(to_x, 50.0)
	view._gui_input(motion)
	click.pressed = false
	view._gui_input(click)


func _open_scene(source: HandSource) -> HandTracker:
	var tracker := HandTracker.new()
	tracker.name = "HandTracker"
	tracker.source = source
	dock.root_folder = _folder.get_current_dir()
	var scene: Node = await open_scene([tracker])
	return scene.get_child(0) as HandTracker


## Counts as which gestures the takes were recognised, without zeros.
func _row(gesture: String) -> Dictionary:
	var row: Dictionary = dock.get_confusion().get(gesture, {})
	var counts := {}
	for recognised: String in row:
		if row[recognised] > 0:
			counts[recognised] = row[recognised]
	return counts


## A hand that the model has not been trained with, at a task.
func _check_recognises(model: GestureModel) -> void:
	var tracker := HandTracker.new()
	tracker.source = ScriptSource.new()
	var task := GestureTask.new()
	var hmm := GestureHMM.new()
	task.gesture = GESTURE
	task.direction = WAY
	task.amplitude = WAY.length()
	root.add_child(task)
	hmm.models = [model]
	hmm.tracker = tracker
	hmm.task = task
	tracker.start()
	var hand := RecordedGestures.new(tracker)
	task.global_position = hand.place
	task.force_update_transform()
	hand.rest(1.0)
	hand.move(WAY, 0.7)
	hand.rest(1.0)
	check_equal(hmm.recognised, StringName(GESTURE), "the saved model recognises the gesture")
	for node: Node in [hmm, task, tracker]:
		node.free()
