extends RefCounted
## Lets one program at a time write to a session: session.lock holds the id of its process. The lock
## is released when this object is freed.

const WholeFile := preload("whole_file.gd")

const LOCK_FILE := "session.lock"

## Why it could not be taken.
var error := ""

## Empty while it is not taken.
var _path := ""


## A lock of an ended process is stale.
func take(folder: String) -> Error:
	var path := folder.path_join(LOCK_FILE)
	if FileAccess.file_exists(path):
		var holder := FileAccess.get_file_as_string(path).strip_edges().to_int()
		if holder > 0 and holder != OS.get_process_id() and _is_running(holder):
			error = (
				(
					"%s: process %d writes to this session. Close that program,"
					+ " or remove %s if it is another one."
				)
				% [folder, holder, LOCK_FILE]
			)
			return ERR_LOCKED
	if WholeFile.write(path, "%d\n" % OS.get_process_id()) != OK:
		error = WholeFile.failure_of(path)
		return ERR_FILE_CANT_WRITE
	_path = path
	return OK


func release() -> void:
	if not _path.is_empty():
		DirAccess.remove_absolute(_path)
		_path = ""


func _notification(what: int) -> void:
	if what == NOTIFICATION_PREDELETE and not _path.is_empty():
		DirAccess.remove_absolute(_path)


## OS.is_process_running() knows children of this process only.
static func _is_running(process_id: int) -> bool:
	if DirAccess.dir_exists_absolute("/proc/self"):
		return DirAccess.dir_exists_absolute("/proc/%d" % process_id)
	if OS.get_name() == "Windows":
		var listed := []
		OS.execute("tasklist", ["/NH", "/FI", "PID eq %d" % process_id], listed)
		return str(process_id) in str(listed)
	return OS.execute("ps", ["-p", str(process_id)]) == 0
