extends RefCounted
## The trained models of a folder.

const Repository := preload("repository.gd")

const INSTALLED := "res://addons/steadyhand/models"


## The default folder of models: in the add-on or, before installation, beside the project.
static func default_path() -> String:
	if DirAccess.dir_exists_absolute(INSTALLED):
		return INSTALLED
	return Repository.absolute(Repository.MODELS)


## All *.gesture files, sorted by name. Empty after one error on stderr.
static func load_all(folder: String) -> Array[GestureModel]:
	var models: Array[GestureModel] = []
	var exists := DirAccess.dir_exists_absolute(folder)
	var files := DirAccess.get_files_at(folder) if exists else PackedStringArray()
	var names := Array(files).filter(
		func(file: String) -> bool: return file.get_extension() == "gesture"
	)
	if names.is_empty():
		printerr("no *.gesture file in '%s'" % folder)
	names.sort()
	for file: String in names:
		# load() would print a second error of the engine, without the reason.
		var model := GestureModel.load_file(folder.path_join(file))
		if model == null:
			return []
		models.append(model)
	return models
