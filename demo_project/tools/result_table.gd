extends RefCounted
## The groups of evaluations as one table for the terminal: the filters, and the synthesised motion
## of both modes.

const Conditions := preload("res://scripts/conditions.gd")
const Stored := preload("res://scripts/stored.gd")

const SYNTHESISED := "synthesised"
const PAPER := "paper"
const PHASE := "phase"
## Modes of the synthesised motion, in the order of the table.
const MODES: Array[String] = [PAPER, PHASE]
const FIGURE_ROWS: Array[String] = ["mean R2", "mean zero-lag R2", "median T_diff", "missed"]
const HEAD := "%-10s %-16s %-9s %6s  %-16s"
const CELL := " %12s"
const T_DIFF := "T_diff: end(reference) - end(curve); positive: the curve ends early."
const MARKDOWN_CELL := " %.3f, %+.0f ms, %d |"

var _lines: PackedStringArray = []
var _markdown: PackedStringArray = []


## `phase`, `paper`: groups of evaluation_report.gd, of the same trials in both modes.
func add(set_name: String, phase: Array[Dictionary], paper: Array[Dictionary]) -> void:
	for i in phase.size():
		var group := phase[i]
		if group["conditions"].is_empty():
			continue
		var columns := _columns(group, paper[i])
		_markdown.append(_markdown_line(set_name, group, columns))
		var head := [set_name, group["gesture"], group["position"], "%d" % group["trials"]]
		for row in FIGURE_ROWS:
			var line := HEAD % (head + [row])
			for column: String in columns:
				line += CELL % cell(columns[column], row)
			_lines.append(line)
			head = ["", "", "", ""]


func show() -> void:
	var title := HEAD % ["set", "gesture", "position", "trials", ""]
	for condition in Conditions.NAMES:
		if condition != SYNTHESISED:
			title += CELL % condition
	for mode in MODES:
		title += CELL % mode
	print("\n%s\n%s" % [title, "-".repeat(title.length())])
	print("\n".join(_lines))
	print("paper, phase: synthesised motion of each mode.\n%s\n" % T_DIFF)


## Zero-lag R2, median T_diff and missed ends of each condition, for a page.
func save_markdown(path: String) -> void:
	var title := "| tracks | trials |"
	for i in Conditions.NAMES.size():
		if Conditions.NAMES[i] != SYNTHESISED:
			title += " %s |" % Conditions.TITLES[i]
	for mode in MODES:
		title += " synthesised, `%s` |" % mode
	var file := FileAccess.open(path, FileAccess.WRITE)
	if file == null:
		push_error("%s: %s" % [path, error_string(FileAccess.get_open_error())])
		return
	file.store_line(title)
	file.store_line("| --- | ---: |" + " ---: |".repeat(Conditions.NAMES.size() - 1 + MODES.size()))
	file.store_line("\n".join(_markdown))
	if not Stored.is_written(file):
		push_error("%s: is the disk full?" % path)


## Summaries by the title of their column, in the order of the table.
static func _columns(phase: Dictionary, paper: Dictionary) -> Dictionary:
	var columns: Dictionary = phase["conditions"].duplicate()
	columns.erase(SYNTHESISED)
	columns[PAPER] = paper["conditions"][SYNTHESISED]
	columns[PHASE] = phase["conditions"][SYNTHESISED]
	return columns


static func _markdown_line(set_name: String, group: Dictionary, columns: Dictionary) -> String:
	var gesture: String = group["gesture"].replace("_", " ")
	var line := "| %s, %s, %s | %d |" % [set_name, gesture, group["position"], group["trials"]]
	for column: String in columns:
		var summary: Dictionary = columns[column]
		var t_diff_ms: float = 1000.0 * summary["t_diff"]["median"]
		line += MARKDOWN_CELL % [summary["r2_zero"]["mean"], t_diff_ms, summary["missed"]]
	return line


## `row`: one of FIGURE_ROWS. `summary`: of a condition.
static func cell(summary: Dictionary, row: String) -> String:
	match row:
		"mean R2":
			return "%.4f" % summary["r2"]["mean"]
		"mean zero-lag R2":
			return "%.4f" % summary["r2_zero"]["mean"]
		"median T_diff":
			return "%+.0f ms" % (1000.0 * summary["t_diff"]["median"])
		_:
			return "%d" % summary["missed"]
