extends RefCounted
## The groups of evaluations as one table for the terminal.

const Conditions := preload("res://scripts/conditions.gd")

const FIGURE_ROWS: Array[String] = ["mean R2", "mean R2, no lag", "median T_diff", "missed"]
const HEAD := "%-10s %-16s %-9s %6s  %-16s"
const CELL := " %12s"

var _lines: PackedStringArray = []


## `groups`: as of evaluation_report.gd.
func add(set_name: String, groups: Array[Dictionary]) -> void:
	for group in groups:
		if group["conditions"].is_empty():
			continue
		var head := [set_name, group["gesture"], group["position"], "%d" % group["trials"]]
		for row in FIGURE_ROWS:
			var line := HEAD % (head + [row])
			for condition in Conditions.NAMES:
				line += CELL % _cell(group["conditions"][condition], row)
			_lines.append(line)
			head = ["", "", "", ""]


func show() -> void:
	var title := HEAD % ["set", "gesture", "position", "trials", ""]
	for condition in Conditions.NAMES:
		title += CELL % condition
	print("\n%s\n%s" % [title, "-".repeat(title.length())])
	print("\n".join(_lines))
	print("T_diff: end of the reference minus end of the curve; positive: the curve ends early.\n")


static func _cell(summary: Dictionary, row: String) -> String:
	match row:
		"mean R2":
			return "%.4f" % summary["r2"]["mean"]
		"mean R2, no lag":
			return "%.4f" % summary["r2_zero"]["mean"]
		"median T_diff":
			return "%+.0f ms" % (1000.0 * summary["t_diff"]["median"])
		_:
			return "%d" % summary["missed"]
