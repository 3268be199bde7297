extends RefCounted
## A CSV file to which rows are only ever added. A row that cannot be written is kept in memory and
## written before the next one. Rows never mix: a partial row of a failed write or a crash is
## removed from the file.

const Stored := preload("res://scripts/stored.gd")

## A partial last row is kept in a file with this ending.
const CUT := ".cut"

var path := ""

var _columns: PackedStringArray = []
## Whole rows that are not on the disk yet.
var _pending := PackedByteArray()
## Bytes of the file that are whole rows.
var _whole := 0


func _init(given_path: String, columns: PackedStringArray) -> void:
	path = given_path
	_columns = columns


## Reads the file and removes a partial last row. Returns an error if that fails.
func open() -> Error:
	_whole = 0
	_pending.clear()
	if FileAccess.file_exists(path):
		var file := FileAccess.open(path, FileAccess.READ)
		if file == null:
			return FileAccess.get_open_error()
		var bytes := file.get_buffer(file.get_length())
		file.close()
		_whole = bytes.rfind(10) + 1
		if _whole < bytes.size():
			var error := _cut_off(bytes.slice(_whole))
			if error != OK:
				return error
	if _whole == 0:
		_pending = _line(_columns)
	return OK


## Whether the file is new or begins with the table's header line.
func has_header() -> bool:
	var file := FileAccess.open(path, FileAccess.READ)
	if _whole == 0 or file == null:
		return true
	return file.get_line().strip_edges().trim_prefix("\ufeff") == ",".join(_columns)


## Rows by column; each value is a text.
func read() -> Array[Dictionary]:
	var rows: Array[Dictionary] = []
	var file := FileAccess.open(path, FileAccess.READ)
	if file == null:
		return rows
	var header := file.get_csv_line()
	header[0] = header[0].trim_prefix("\ufeff")
	while file.get_position() < _whole:
		var cells := file.get_csv_line()
		var row := {}
		for i in mini(header.size(), cells.size()):
			row[header[i]] = cells[i]
		rows.append(row)
	return rows


## `row`: values by column; NAN, null and what is missing become empty cells.
func add(row: Dictionary) -> void:
	var cells := PackedStringArray()
	for column in _columns:
		cells.append(cell(row.get(column)))
	_pending.append_array(_line(cells))


func has_pending() -> bool:
	return not _pending.is_empty()


## Writes all rows that are not on the disk yet, at once.
func flush() -> Error:
	if _pending.is_empty():
		return OK
	var is_new := not FileAccess.file_exists(path)
	var file := FileAccess.open(path, FileAccess.WRITE if is_new else FileAccess.READ_WRITE)
	if file == null:
		return FileAccess.get_open_error()
	if is_new and _whole > 0:
		# Another program removed the file.
		_whole = 0
		_pending = _line(_columns) + _pending
	file.seek(_whole)
	file.store_buffer(_pending)
	var end := _whole + _pending.size()
	var is_written := Stored.is_written(file) or file.get_length() > end
	if is_written and file.get_length() > end:
		is_written = file.resize(end) == OK
	# Closing may write what the buffer still holds: cut the file only after it.
	file.close()
	if not is_written:
		_shorten()
		return ERR_FILE_CANT_WRITE
	_whole = end
	_pending.clear()
	return OK


func _shorten() -> void:
	var file := FileAccess.open(path, FileAccess.READ_WRITE)
	if file != null and file.get_length() > _whole:
		file.resize(_whole)


static func cell(value: Variant) -> String:
	if value == null:
		return ""
	if value is float:
		return "" if is_nan(value) or is_inf(value) else "%.6f" % value
	if value is bool:
		return "1" if value else "0"
	return str(value).replace("\r", " ").replace("\n", " ")


## RFC 4180.
static func _line(cells: PackedStringArray) -> PackedByteArray:
	var quoted := PackedStringArray()
	for text in cells:
		var needs_quotes := "," in text or '"' in text
		quoted.append('"%s"' % text.replace('"', '""') if needs_quotes else text)
	return (",".join(quoted) + "\n").to_utf8_buffer()


## The bytes first go to the .cut file, so that nothing recorded is lost.
func _cut_off(bytes: PackedByteArray) -> Error:
	var cut_path := path + CUT
	var mode := FileAccess.READ_WRITE if FileAccess.file_exists(cut_path) else FileAccess.WRITE
	var kept := FileAccess.open(cut_path, mode)
	if kept == null:
		return FileAccess.get_open_error()
	kept.seek_end()
	kept.store_buffer(bytes + "\n".to_utf8_buffer())
	if not Stored.is_written(kept):
		return ERR_FILE_CANT_WRITE
	var file := FileAccess.open(path, FileAccess.READ_WRITE)
	if file == null:
		return FileAccess.get_open_error()
	return file.resize(_whole)
