extends "scene_test.gd"
## A test of evaluations in a folder of its own.

const Evaluation := preload("res://tools/evaluation.gd")
const ModelFolder := preload("res://tools/model_folder.gd")

var _folder := DirAccess.create_temp("steadyhand_evaluation")


func _evaluate(trials: TrialSet, out: String, context := "scene") -> Evaluation:
	var evaluation := Evaluation.new()
	var settings := {mode = "paper", context = context, models = ModelFolder.INSTALLED}
	evaluation.run(trials, ModelFolder.load_all(ModelFolder.INSTALLED), settings, _path(out), root)
	return evaluation


## `cells`: by column.
static func _replace_cells(table: PackedStringArray, row: int, cells: Dictionary) -> void:
	var old := table[row].split(",")
	for column: int in cells:
		old[column] = cells[column]
	table[row] = ",".join(old)


func _lines(name: String) -> PackedStringArray:
	return FileAccess.get_file_as_string(_path(name)).split("\n", false)


func _path(name: String) -> String:
	return _folder.get_current_dir().path_join(name)
