extends "support/scene_test.gd"
## Recordings of a real hand, if available: synthesised motion beats the moving average.

const Evaluation := preload("res://tools/evaluation.gd")
const ModelFolder := preload("res://tools/model_folder.gd")
const Repository := preload("res://tools/repository.gd")

var _folder := DirAccess.create_temp("steadyhand_real")


func test_synthesised_beats_the_average() -> void:
	if not DirAccess.dir_exists_absolute(Repository.REAL_DRAGS):
		skip("no recordings in %s" % Repository.absolute(Repository.REAL_DRAGS))
		return
	var trials := TrialSet.load_folder(Repository.absolute(Repository.REAL_DRAGS))
	var settings := {mode = "paper", context = "scene", models = ModelFolder.INSTALLED}
	var evaluation := Evaluation.new()
	evaluation.run(
		trials,
		ModelFolder.load_all(ModelFolder.INSTALLED),
		settings,
		_folder.get_current_dir(),
		root
	)
	check_equal(evaluation.broken, 0, "every track can be read")
	var drags := 0
	for group in evaluation.groups:
		if group["gesture"] in ["horizontal_drag", "vertical_drag"]:
			drags += group["trials"]
			_check_group(group)
	check_equal(drags, 88, "every drag is there")


func _check_group(group: Dictionary) -> void:
	var name := "%s, %s" % [group["gesture"], group["position"]]
	var average: Dictionary = group["conditions"]["average"]
	var synthesised: Dictionary = group["conditions"]["synthesised"]
	check_equal(synthesised["n"], group["trials"], "%s: figures for each" % name)
	var r2: Array[float] = [synthesised["r2_zero"]["mean"], average["r2_zero"]["mean"]]
	check(r2[0] > r2[1], "%s: mean zero-lag R2 %.3f over %.3f" % [name, r2[0], r2[1]])
	var t_diff: Array[float] = [synthesised["t_diff"]["median"], average["t_diff"]["median"]]
	check(
		absf(t_diff[0]) < absf(t_diff[1]),
		"%s: median T_diff %.3f s against %.3f s" % [name, t_diff[0], t_diff[1]]
	)
