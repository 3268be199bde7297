extends RefCounted
## Detects a full disk. FileAccess reports no error if the last data is still in its buffer.


## Flushes `file`, and returns whether all data up to its position is on the disk.
static func is_written(file: FileAccess) -> bool:
	var end := file.get_position()
	file.flush()
	return file.get_error() == OK and file.get_length() == end


## The one of `names` that differs from `name` only in upper and lower case. Empty: none. Windows
## and macOS take both for one file or folder.
static func same_in_other_case(name: String, names: PackedStringArray) -> String:
	for other in names:
		if other != name and other.nocasecmp_to(name) == 0:
			return other
	return ""
