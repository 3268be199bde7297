extends RefCounted
## What FileAccess does not tell: that a disk was full, where its buffer took the last of what was
## stored.


## Whether all that was stored in `file`, up to where it is now, is there; writes it through.
static func is_written(file: FileAccess) -> bool:
	var end := file.get_position()
	file.flush()
	return file.get_error() == OK and file.get_length() == end
