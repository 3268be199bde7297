extends "support/scene_test.gd"
## The readout of the task scenes.

const Rig := preload("support/rig.gd")
const TaskPlayer := preload("support/task_player.gd")

var _folder := DirAccess.create_temp("steadyhand_readout")


func test_the_readout_shows_the_active_gesture() -> void:
	var trials := Rig.write_trials(_folder.get_current_dir().path_join("trials"), 2)
	var player := TaskPlayer.new("horizontal_drag", _folder.get_current_dir(), self)
	var scene := player.scene
	scene.play(trials.get_trial(0), trials.get_measured_path(0))
	scene.tracker.advance(0.1)
	await _shown()
	check_equal(_status(player), "no gesture", "before the gesture")
	while scene.gesture_hmm.progress < 0.5 and not scene.tracker.is_finished():
		scene.tracker.advance(Rig.STEP_S)
	await _shown()
	var under_way := RegEx.create_from_string("^horizontal_drag   state [0-3]   5[0-9] %$")
	check(under_way.search(_status(player)) != null, "half-way: %s" % _status(player))
	scene.gesture_hmm.reset()
	await _shown()
	check_equal(_status(player), "no gesture", "and afterwards")
	scene.free()


## The signal is emitted before _process().
func _shown() -> void:
	await process_frame
	await process_frame


static func _status(player: TaskPlayer) -> String:
	return (player.scene.get_node("Readout/Panel/Rows/Status") as Label).text
