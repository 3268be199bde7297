extends "support/editor_test.gd"
## The editor's "Gestures" panel records from a running game, as needed for a headset.

const PushedHand := preload("support/pushed_hand.gd")

const SCENE := "res://recorded_game.tscn"
const FRAME_S := 1.0 / 90.0
const TRACK_S := 40.0
## Of the hand in the game: out, rest, back, rest.
const PERIOD_S := 2.4
const PART_S := 0.6
const PATIENCE_S := 15.0
## Has a whole movement, whenever it begins.
const RECORDED_S := 4.0

var _folder := DirAccess.create_temp("steadyhand_takes")


func test_a_running_game_is_recorded() -> void:
	_save_scene()
	dock.root_folder = _folder.get_current_dir()
	dock.open_gesture("wipe")
	check(not dock.start_recording(), "without a game there is nothing to record")
	var port := randi_range(20000, 30000)
	_open_debug_server(port)
	var game := _start_game(port)
	var began_ms := Time.get_ticks_msec()
	while dock.hint().begins_with("Add a HandTracker") and _waits(began_ms):
		await process_frame
	check(dock.hint().begins_with("Press Record"), dock.hint())
	check(dock.start_recording(), "the game is recorded: %s" % dock.get_message())
	await create_timer(RECORDED_S).timeout
	check(dock.get_recorder().get_tracker().is_hand_tracked(), "the editor gets its hand")
	dock.stop_recording()
	check(dock.takes.rows.size() > 0, "it has movements: %d" % dock.takes.rows.size())
	OS.kill(game)
	began_ms = Time.get_ticks_msec()
	while not dock.hint().begins_with("Add a HandTracker") and _waits(began_ms):
		await process_frame
	check(dock.hint().begins_with("Add a HandTracker"), "the game is over")


## As the item of the menu Debug: the editor then listens to a game started by another program.
func _open_debug_server(port: int) -> void:
	EditorInterface.get_editor_settings().set_setting("network/debug/remote_port", port)
	for menu: PopupMenu in root.find_children("*", "PopupMenu", true, false):
		for index in menu.item_count:
			if menu.get_item_text(index) == "Keep Debug Server Open":
				menu.id_pressed.emit(menu.get_item_id(index))


## The editor would start its own executable, which may be a loader.
func _start_game(port: int) -> int:
	var godot := OS.get_environment("GODOT")
	var arguments := ["--headless", "--path", ProjectSettings.globalize_path("res://")]
	arguments += ["--remote-debug", "tcp://127.0.0.1:%d" % port, SCENE]
	return OS.create_process(OS.get_executable_path() if godot.is_empty() else godot, arguments)


func _waits(began_ms: int) -> bool:
	return Time.get_ticks_msec() - began_ms < 1e3 * PATIENCE_S


func _save_scene() -> void:
	var scene := Node3D.new()
	var tracker := HandTracker.new()
	var source := RecordedSource.new()
	source.track = _write_track()
	tracker.source = source
	tracker.name = "HandTracker"
	var overlay := load("res://addons/steadyhand/debug_overlay.tscn") as PackedScene
	var shown := overlay.instantiate()
	for node: Node in [tracker, shown]:
		scene.add_child(node)
		node.owner = scene
	shown.set("tracker", tracker)
	var packed := PackedScene.new()
	packed.pack(scene)
	ResourceSaver.save(packed, SCENE)
	scene.free()


func _write_track() -> String:
	var rows := PackedStringArray(["t,index_x,index_y,index_z"])
	for frame in int(TRACK_S / FRAME_S):
		var time_s := frame * FRAME_S
		var passed := fmod(time_s, PERIOD_S) / PART_S
		var way := 0.2 * (PushedHand.share(passed) - PushedHand.share(passed - 2.0))
		var tip := Vector3(way, 1.0, -0.3) + PushedHand.tremor(time_s)
		rows.append("%s,%s,%s,%s" % [time_s, tip.x, tip.y, tip.z])
	var path := _folder.get_current_dir().path_join("hand.csv")
	FileAccess.open(path, FileAccess.WRITE).store_string("\n".join(rows) + "\n")
	return path
