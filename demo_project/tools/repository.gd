extends RefCounted
## Paths of the repository, outside of the project.

const MODELS := "res://../models"
const BUILD := "res://../build"
## Recordings of real hands; may be missing.
const REAL_DRAGS := "res://../../shared/real/drags"


static func absolute(path: String) -> String:
	return ProjectSettings.globalize_path(path).simplify_path()
