extends "support/evaluation_test.gd"
## The results of an evaluation, in its files and on the terminal, and its options.

const Rig := preload("support/rig.gd")
const CommandLine := preload("res://tools/command_line.gd")
const EvaluationReport := preload("res://tools/evaluation_report.gd")
const ToolRun := preload("support/tool_run.gd")

const CONDITIONS: Array[String] = ["measured", "average", "one_euro", "kalman", "synthesised"]
const FIGURES: Array[String] = ["r2", "r2_zero", "lag", "t_diff", "sparc"]


func test_files_of_an_evaluation() -> void:
	var trials := Rig.write_trials(_path("trials"), 2)
	var evaluation := _evaluate(trials, "out")
	check_equal(evaluation.broken, 0, "no trial is broken")
	var header := "trial,gesture,position,subject,recognised"
	for condition in CONDITIONS:
		for figure in FIGURES:
			header += ",%s_%s" % [figure, condition]
	var rows := _lines("out/results.csv")
	check_equal(rows[0], header, "the columns of results.csv")
	check_equal(rows.size(), trials.get_count() + 1, "a row a trial")
	for row in rows.slice(1):
		var cells := row.split(",")
		var are_finite := true
		for cell in cells.slice(5):
			are_finite = are_finite and cell.is_valid_float() and is_finite(cell.to_float())
		check(cells.size() == 30 and are_finite, "%s has 25 finite figures" % cells[0])
		_check_curves(cells[0])
	var summary: Dictionary = JSON.parse_string("\n".join(_lines("out/summary.json")))
	check_equal(summary["groups"].size(), 2, "the summary has stable and unstable")
	check_equal(summary["settings"]["mode"], "paper", "and the settings")
	for rate: String in ["false_alarms_per_minute", "begun_per_minute", "under_way_share"]:
		check_equal(summary[rate], null, "%s is unknown without trials of none" % rate)
	_check_summary(summary["groups"], rows)


func test_the_sensors_latency_can_be_given() -> void:
	var trials := Rig.write_trials(_path("late"))
	var half_way_ms: Dictionary[String, int] = {}
	for given: String in ["", "0", "0.05"]:
		var out := "late_out" + given
		var options := ["--trials", _path("late"), "--out", _path(out)]
		if not given.is_empty():
			options.append_array(["--sensor-latency", given])
		check_equal(ToolRun.new("evaluate", options).exit_code, 0, "--sensor-latency '%s'" % given)
		var summary: Dictionary = JSON.parse_string("\n".join(_lines(out + "/summary.json")))
		var wanted := 0.007 if given.is_empty() else given.to_float()
		check_equal(summary["settings"]["sensor_latency_s"], wanted, "it is in summary.json")
		var curves := _lines("%s/%s.curves.csv" % [out, trials.get_trial(0)["trial"]])
		var row := 1
		while curves[row].get_slice(",", 6).to_float() < 0.5:
			row += 1
		half_way_ms[given] = row
	var earlier_ms := half_way_ms["0"] - half_way_ms["0.05"]
	check(absi(earlier_ms - 50) < 10, "the motion is earlier by %d ms" % earlier_ms)
	check(half_way_ms[""] < half_way_ms["0"], "without it the default latency is compensated")
	for wrong: String in ["soon", "-0.001", "0.201", "nan", "1e999", ""]:
		var options := ["--trials", _path("late"), "--out", _path("wrong_out")]
		var run := ToolRun.new("evaluate", options + ["--sensor-latency", wrong])
		var text := "--sensor-latency is '%s'; it must be a time in s from 0.0 to 0.2" % wrong
		check_equal(run.exit_code, 2, "exit code of '%s'" % wrong)
		check_equal(run.missing([text]), "", "the message")
		check(not DirAccess.dir_exists_absolute(_path("wrong_out")), "nothing is written")


func test_a_set_without_trials() -> void:
	Rig.write_trials(_path("none"))
	var header := _lines("none/trials.csv")[0]
	FileAccess.open(_path("none/trials.csv"), FileAccess.WRITE).store_string(header + "\n")
	var run := ToolRun.new("evaluate", ["--trials", _path("none"), "--out", _path("none_out")])
	check_equal(run.exit_code, 1, "exit code")
	check_equal(run.missing(["no row in %s" % _path("none/trials.csv")]), "", "the message")
	check_equal(run.missing(["evaluate: there was no trial to run"]), "", "the summary")
	check(not DirAccess.dir_exists_absolute(_path("none_out")), "nothing is written")
	var options := ["--trials", _path("none"), "--out", _path("out")]
	var earlier := DirAccess.get_files_at(_path("out"))
	check_equal(ToolRun.new("evaluate", options).exit_code, 1, "exit code over an earlier one")
	check(earlier.size() > 2, "there are earlier files")
	check_equal(DirAccess.get_files_at(_path("out")), earlier, "the earlier files stay")


func test_the_result_is_printed() -> void:
	var trials := Rig.write_trials(_path("printed"), 2)
	var table := _lines("printed/trials.csv")
	_replace_cells(table, 1, {1: "none", 6: "", 7: "", 8: "", 9: "", 10: "", 11: "", 12: ""})
	FileAccess.open(_path("printed/trials.csv"), FileAccess.WRITE).store_string("\n".join(table))
	var options := ["--trials", _path("printed"), "--out", _path("printed_out")]
	var run := ToolRun.new("evaluate", options + ["--context", "open"])
	check_equal(run.exit_code, 0, "exit code")
	var summary: Dictionary = JSON.parse_string("\n".join(_lines("printed_out/summary.json")))
	for group: Dictionary in summary["groups"]:
		var head: Array[String] = [group["gesture"], group["position"], "%d" % group["trials"]]
		check_equal(run.missing(head), "", "a row of each gesture and position")
		var own: Dictionary = group["conditions"]
		if group["gesture"] == "none":
			check_equal(
				run.missing(["none", "no figures"]), "", "a trial without a gesture has no figures"
			)
			continue
		var means := PackedStringArray(["mean zero-lag R2"])
		for condition in CONDITIONS:
			means.append("%.4f" % own[condition]["r2_zero"]["mean"])
		check_equal(run.missing(means), "", "the means of all conditions")
	var rate: float = summary["false_alarms_per_minute"]
	check_equal(run.missing(["1 false alarm in", "%.2f a minute" % rate]), "", "false alarms")
	var curves := "summary.json and %d curves" % trials.get_count()
	check_equal(run.missing([_path("printed_out/results.csv"), curves]), "", "what was written")


func test_files_of_an_earlier_evaluation_are_removed() -> void:
	var trials := Rig.write_trials(_path("earlier"), 2)
	_evaluate(trials, "again")
	var name: String = trials.get_trial(0)["trial"]
	for own: String in ["notes.curves.csv", "results.csv.old"]:
		FileAccess.open(_path("again").path_join(own), FileAccess.WRITE).store_line("mine")
	var report := EvaluationReport.new(_path("again"))
	var left := DirAccess.get_files_at(_path("again"))
	check_equal(
		Array(left),
		["notes.curves.csv", "results.csv.old", "results.csv.part"],
		"a new evaluation begins"
	)
	var cut := FileAccess.open(_path("again/results.csv.part"), FileAccess.WRITE)
	cut.store_line(_lines("out/results.csv")[0])
	cut.store_line("%s,tap,st" % name)
	cut.close()
	FileAccess.open(_path("again/%s.curves.csv" % name), FileAccess.WRITE).store_line("cut")
	check_equal(report.error, "", "no fault")
	EvaluationReport.new(_path("again"))
	left = DirAccess.get_files_at(_path("again"))
	check_equal(left.size(), 3, "files of an incomplete evaluation are removed, too")
	_evaluate(trials, "again")
	left = DirAccess.get_files_at(_path("again"))
	check_equal(
		left.size(), 2 + 2 + trials.get_count(), "results, summary, curves and the user's files"
	)
	check(not "results.csv.part" in left, "the table is complete")


func test_confusion_and_false_alarms() -> void:
	var trials := Rig.write_trials(_path("confused"), 2)
	# A drag in a trial without a gesture: any recognised gesture is a false alarm.
	var table := _lines("confused/trials.csv")
	var cells := table[1].split(",")
	table[1] = ",".join([cells[0], "none", cells[2], cells[3], cells[4], cells[5], ",,,,,,"])
	FileAccess.open(_path("confused/trials.csv"), FileAccess.WRITE).store_string("\n".join(table))
	trials = TrialSet.load_folder(trials.get_path())
	_evaluate(trials, "confused_out", "open")
	var summary: Dictionary = JSON.parse_string("\n".join(_lines("confused_out/summary.json")))
	var counted: Dictionary[String, Dictionary] = {}
	for row in _lines("confused_out/results.csv").slice(1):
		var pair := [row.get_slice(",", 1), row.get_slice(",", 4)]
		var counts: Dictionary = counted.get_or_add(pair[0], {})
		counts[pair[1]] = counts.get(pair[1], 0) + 1
	for gesture in counted:
		for recognised: String in counted[gesture]:
			check_equal(
				int(summary["confusion"][gesture][recognised]),
				counted[gesture][recognised],
				"%s taken for %s, counted in results.csv" % [gesture, recognised]
			)
	check_equal(int(summary["confusion"]["none"]["horizontal_drag"]), 1, "the drag is counted")
	var instants := _lines("confused_out/%s.curves.csv" % cells[0]).size() - 1
	check_near(summary["none_minutes"], instants / 60000.0, 1e-9, "1 ms an instant")
	check_near(
		summary["false_alarms_per_minute"] * summary["none_minutes"], 1.0, 1e-9, "one false alarm"
	)
	# The hand rests before the record ends.
	var begun: float = summary["begun_per_minute"] * summary["none_minutes"]
	check(begun > 0.5, "the gesture started")
	var active_s: float = summary["under_way_share"] * summary["none_minutes"] * 60.0
	var left_s: float = instants / 1000.0 - cells[4].to_float()
	check(active_s > 0.1 and active_s < left_s, "active for %.3f s" % active_s)
	var alarms: Array = summary["false_alarms"]
	check_equal(alarms.size(), 1, "the false alarm is listed")
	check_equal(alarms[0]["trial"], cells[0], "with its trial")
	check_equal(alarms[0]["gesture"], "horizontal_drag", "its gesture")
	check(alarms[0]["time_s"] > cells[4].to_float(), "its end")


func test_min_confidence_can_be_given() -> void:
	var trials := Rig.write_trials(_path("sure"))
	for given: String in ["", "0.3", "1"]:
		var out := "sure_out" + given
		var options := ["--trials", _path("sure"), "--out", _path(out), "--context", "open"]
		if not given.is_empty():
			options.append_array(["--min-confidence", given])
		check_equal(ToolRun.new("evaluate", options).exit_code, 0, "--min-confidence '%s'" % given)
		var summary: Dictionary = JSON.parse_string("\n".join(_lines(out + "/summary.json")))
		check_equal(
			summary["settings"]["min_confidence"], given.to_float(), "it is in summary.json"
		)
		var recognised := _lines(out + "/results.csv")[1].get_slice(",", 4)
		check_equal(recognised, "none" if given == "1" else "horizontal_drag", "at '%s'" % given)
	for wrong: String in ["sure", "-0.01", "1.01", "nan", ""]:
		var options := ["--trials", trials.get_path(), "--out", _path("wrong_out")]
		var run := ToolRun.new("evaluate", options + ["--min-confidence", wrong])
		var text := "--min-confidence is '%s'; it must be a probability from 0.0 to 1.0" % wrong
		check_equal(run.exit_code, 2, "exit code of '%s'" % wrong)
		check_equal(run.missing([text]), "", "the message")


func test_arguments() -> void:
	var known: Dictionary[String, String] = {trials = "", mode = "paper"}
	var good := CommandLine.new(["--trials", "/a b/c"], known)
	check_equal(good.path("trials"), "/a b/c", "a path")
	check_equal(good.choice("mode", ["paper"]), "paper", "a default")
	check_equal(good.error, "", "no error")
	var joined := CommandLine.new(["--trials=/a b/--c=d", "--mode", "fast"], known)
	check_equal(joined.path("trials"), "/a b/--c=d", "a path after an equals sign")
	check_equal(joined.text("mode"), "fast", "and an option after it")
	check(_fault(["--trails", "/x"], known).contains("--trails"), "an unknown option is named")
	check(
		_fault(["--trails=/x"], known).contains("--trails"),
		"an unknown option with a value is named"
	)
	check(_fault(["--trials"], known).contains("--trials"), "a missing value")
	check(_fault(["--trials", "x"], known).contains("absolute"), "a relative path")
	check(_fault([], known).contains("--trials"), "a missing option")
	check(_fault(["--trials", "/x", "--mode", "fast"], known).contains("fast"), "no such mode")


func _fault(arguments: PackedStringArray, known: Dictionary[String, String]) -> String:
	var line := CommandLine.new(arguments, known)
	line.path("trials")
	line.choice("mode", ["paper"])
	return line.error


func _check_curves(trial: String) -> void:
	var lines := _lines("out/%s.curves.csv" % trial)
	check_equal(lines[0], "t,reference,%s" % ",".join(CONDITIONS), "the columns of its curves")
	var first := lines[1].get_slice(",", 0).to_float()
	var last := lines[-1].get_slice(",", 0).to_float()
	check_near(lines.size() - 2, 1000.0 * (last - first), 1e-6, "1 kHz without a gap")


## Compares the groups' figures with those computed from the rows.
func _check_summary(groups: Array, rows: PackedStringArray) -> void:
	var columns := rows[0].split(",")
	for group: Dictionary in groups:
		var own := Array(rows.slice(1)).filter(
			func(row: String) -> bool: return row.split(",")[2] == group["position"]
		)
		for condition in CONDITIONS:
			var figures: Dictionary = group["conditions"][condition]
			check_equal(int(figures["n"]), own.size(), "trials of %s" % condition)
			for figure in FIGURES:
				var place := columns.find("%s_%s" % [figure, condition])
				var values := own.map(
					func(row: String) -> float: return row.split(",")[place].to_float()
				)
				values.sort()
				# Linear between two values.
				var expected := {
					mean = (values[0] + values[1]) / 2.0,
					median = (values[0] + values[1]) / 2.0,
					p5 = lerpf(values[0], values[1], 0.05),
					p2_5 = lerpf(values[0], values[1], 0.025),
					p97_5 = lerpf(values[0], values[1], 0.975),
				}
				var is_same := true
				for statistic: String in figures[figure]:
					var error: float = figures[figure][statistic] - expected[statistic]
					is_same = is_same and absf(error) < 2e-6
				check(is_same, "%s of %s, %s" % [figure, condition, group["position"]])
