extends RefCounted
## Common functions of the scene tests of studies.


## 2 gestures x 2 positions x 2 conditions x 2 trials, and a practice trial for each gesture.
static func protocol() -> StudyProtocol:
	var protocol := StudyProtocol.paper()
	protocol.gestures = ["horizontal_drag", "tap"]
	protocol.conditions = ["measured", "synthesised"]
	protocol.trials_per_cell = 2
	protocol.block_size = 2
	protocol.practice_trials = 1
	protocol.rest_after_trials = 8
	protocol.rest_s = 10.0
	protocol.questionnaires[0] = protocol.questionnaires[0].duplicate()
	protocol.questionnaires[0].after_trials = 4
	protocol.order = StudyProtocol.Order.FIXED
	return protocol


## Rows of a table by column.
static func read(session: StudySession, name: String) -> Array[Dictionary]:
	var file := FileAccess.open(session.folder.path_join(name), FileAccess.READ)
	var header := file.get_csv_line()
	var rows: Array[Dictionary] = []
	while file.get_position() < file.get_length():
		var cells := file.get_csv_line()
		var row := {}
		for i in header.size():
			row[header[i]] = cells[i]
		rows.append(row)
	return rows
