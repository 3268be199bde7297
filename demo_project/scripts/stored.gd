extends RefCounted
## Detects a full disk. FileAccess reports no error if the last data is still in its buffer.


## Flushes `file`, and returns whether all data up to its position is on the disk.
static func is_written(file: FileAccess) -> bool:
	var end := file.get_position()
	file.flush()
	return file.get_error() == OK and file.get_length() == end
