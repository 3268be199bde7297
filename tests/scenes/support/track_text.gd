extends RefCounted
## Changes track files.


## Cuts a track down to its frames from `from_s` to `to_s`.
static func keep_frames(path: String, from_s: float, to_s: float) -> void:
	var kept := PackedStringArray()
	for line in FileAccess.get_file_as_string(path).split("\n", false):
		var t := line.get_slice(",", 0)
		if not t.is_valid_float() or (t.to_float() >= from_s and t.to_float() <= to_s):
			kept.append(line)
	FileAccess.open(path, FileAccess.WRITE).store_string("\n".join(kept) + "\n")


static func scale(path: String, name: String, factor: float) -> void:
	var lines := FileAccess.get_file_as_string(path).split("\n", false)
	var header := 0
	while not lines[header].begins_with("t,"):
		header += 1
	var column := lines[header].split(",").find(name)
	for row in range(header + 1, lines.size()):
		var cells := lines[row].split(",")
		if cells[column].is_valid_float():
			cells[column] = str(factor * cells[column].to_float())
		lines[row] = ",".join(cells)
	FileAccess.open(path, FileAccess.WRITE).store_string("\n".join(lines) + "\n")
