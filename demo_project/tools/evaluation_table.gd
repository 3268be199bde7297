extends RefCounted
## Results of an evaluation for the terminal: a block of lines for each gesture and position.

const Conditions := preload("res://scripts/conditions.gd")
const ResultTable := preload("result_table.gd")

const HEAD := "%-16s %-9s %6s %10s  %-16s"


## `groups`: of evaluation_report.gd.
static func text(groups: Array[Dictionary]) -> String:
	var title := HEAD % ["gesture", "position", "trials", "recognised", ""]
	for condition in Conditions.NAMES:
		title += ResultTable.CELL % condition
	var lines := PackedStringArray([title, "-".repeat(title.length())])
	for group in groups:
		var head: Array[String] = [group["gesture"], group["position"]]
		for number: String in ["trials", "recognised"]:
			head.append("%d" % group[number])
		var conditions: Dictionary = group["conditions"]
		if conditions.is_empty():
			lines.append((HEAD % (head + ["no figures"])).strip_edges(false))
			continue
		for row in ResultTable.FIGURE_ROWS:
			var line := HEAD % (head + [row])
			for condition: String in conditions:
				line += ResultTable.CELL % ResultTable.cell(conditions[condition], row)
			lines.append(line)
			head.assign(["", "", "", ""])
	lines.append(ResultTable.T_DIFF)
	return "\n".join(lines)
