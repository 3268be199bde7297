extends "support/scene_test.gd"
## Models: trained, saved, loaded.

const Rig := preload("support/rig.gd")

var _folder := DirAccess.create_temp("steadyhand_model")


func test_installed_models_load() -> void:
	for gesture: String in ["horizontal_drag", "vertical_drag", "tap", "zoom"]:
		var model := load(Rig.MODEL % gesture) as GestureModel
		check(model != null, "%s loads" % gesture)
		check_equal(String(model.gesture), gesture, "its gesture")
		check_equal(model.state_count, 4, "its states")
		check(not model.get_provenance().is_empty(), "it has a provenance")
		check_near(model.evaluate(0.0), 0.0, 0.05, "its curve starts at 0")
		check_near(model.evaluate(1.0), 1.0, 0.05, "and ends at 1")


func test_reference_rises() -> void:
	var mean := (load(Rig.MODEL % "horizontal_drag") as GestureModel).get_reference_mean()
	var falls := 0
	for i in range(1, mean.size()):
		if mean[i] < mean[i - 1] - 1e-3:
			falls += 1
	check(mean.size() > 20, "a curve of %d points" % mean.size())
	check_equal(falls, 0, "a drag does not go back")


func test_round_trip_through_the_engine() -> void:
	var model := load(Rig.MODEL % "horizontal_drag") as GestureModel
	var path := _folder.get_current_dir().path_join("copy.gesture")
	check_equal(ResourceSaver.save(model, path), OK, "saved")
	var copy := ResourceLoader.load(path, "GestureModel") as GestureModel
	check_equal(copy.to_text(), model.to_text(), "the same text")
	check_equal(
		copy.get_reference_mean().to_byte_array(),
		model.get_reference_mean().to_byte_array(),
		"the same bits"
	)
