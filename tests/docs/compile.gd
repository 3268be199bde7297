extends SceneTree
## Compiles the scripts whose paths are given: tools/suites/docs_scripts.py.


func _initialize() -> void:
	var good := 0
	for path in OS.get_cmdline_user_args():
		var script := GDScript.new()
		script.source_code = FileAccess.get_file_as_string(path)
		if script.reload() == OK:
			good += 1
		else:
			print("does not compile: ", path)
	print(good, " scripts compile")
	quit(0 if good == OS.get_cmdline_user_args().size() else 1)
