extends SceneTree
## Plays the script whose path is given, on a node of its class, until a gesture ends.

const PATIENCE_FRAMES := 1200

var _frames := 0


func _initialize() -> void:
	var script := GDScript.new()
	script.source_code = FileAccess.get_file_as_string(OS.get_cmdline_user_args()[0])
	if script.reload() != OK:
		quit(1)
		return
	var scene: Node = ClassDB.instantiate(script.get_instance_base_type())
	scene.set_script(script)
	root.add_child(scene)


func _process(_delta: float) -> bool:
	_frames += 1
	for hmm: GestureHMM in root.find_children("*", "GestureHMM", true, false):
		if hmm.recognised != &"":
			print("a gesture has ended: ", hmm.recognised)
			quit()
	if _frames > PATIENCE_FRAMES:
		print("no gesture ended in ", PATIENCE_FRAMES, " frames")
		quit(1)
	return false
