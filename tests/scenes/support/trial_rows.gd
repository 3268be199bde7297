extends RefCounted
## Reads a session's trials.csv.

const NAME := "trials.csv"


## One row for each trial, by column.
static func read(session: String) -> Array[Dictionary]:
	var file := FileAccess.open(session.path_join(NAME), FileAccess.READ)
	var header := file.get_csv_line()
	var rows: Array[Dictionary] = []
	while file.get_position() < file.get_length():
		var cells := file.get_csv_line()
		var row: Dictionary[String, String] = {}
		for column in header.size():
			row[header[column]] = cells[column]
		rows.append(row)
	return rows


static func header(session: String) -> String:
	return FileAccess.get_file_as_string(session.path_join(NAME)).get_slice("\n", 0)
