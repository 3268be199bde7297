extends RefCounted
## Writes a file whole or not at all.

const Stored := preload("res://scripts/stored.gd")


## A new file beside `path` takes its place once all of it is on the disk.
static func write(path: String, text: String) -> Error:
	var part := path + ".part"
	var file := FileAccess.open(part, FileAccess.WRITE)
	if file == null:
		return FileAccess.get_open_error()
	file.store_buffer(text.to_utf8_buffer())
	var is_whole := Stored.is_written(file)
	file.close()
	if is_whole and DirAccess.rename_absolute(part, path) == OK:
		return OK
	DirAccess.remove_absolute(part)
	return ERR_FILE_CANT_WRITE


## Why `path` could not be written, and what to look at.
static func failure_of(path: String) -> String:
	return "%s: cannot be written. Is the disk full, or has another program opened the file?" % path
