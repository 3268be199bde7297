extends "support/scene_test.gd"
## The README's script, pasted onto a Node3D.

const PATIENCE_MS := 15000


func test_the_script_of_the_readme_drags_a_box() -> void:
	var path := ProjectSettings.globalize_path("res://").path_join("../README.md")
	var readme := FileAccess.get_file_as_string(path)
	var script := GDScript.new()
	script.source_code = readme.get_slice("```gdscript\n", 1).get_slice("```", 0)
	check_equal(script.reload(), OK, "it compiles")
	var scene := Node3D.new()
	scene.set_script(script)
	root.add_child(scene)
	var hmm := scene.find_children("*", "GestureHMM", true, false)[0] as GestureHMM
	var box := scene.find_children("*", "CSGBox3D", true, false)[0] as Node3D
	var farthest := 0.0
	var began_ms := Time.get_ticks_msec()
	while hmm.recognised == &"" and Time.get_ticks_msec() - began_ms < PATIENCE_MS:
		await process_frame
		farthest = maxf(farthest, box.position.x)
	check_equal(hmm.recognised, &"horizontal_drag", "the drag ends")
	check_near(farthest, 0.2, 0.03, "the box has been dragged")
	scene.free()
