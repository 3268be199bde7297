extends "support/scene_test.gd"
## The evaluation's files, and its report of broken trials.

const Rig := preload("support/rig.gd")
const CommandLine := preload("res://tools/command_line.gd")
const Evaluation := preload("res://tools/evaluation.gd")
const EvaluationReport := preload("res://tools/evaluation_report.gd")
const ModelFolder := preload("res://tools/model_folder.gd")
const ToolRun := preload("support/tool_run.gd")
const TrackText := preload("support/track_text.gd")

const CONDITIONS: Array[String] = ["measured", "average", "one_euro", "kalman", "synthesised"]
const FIGURES: Array[String] = ["r2", "r2_zero", "lag", "t_diff", "sparc"]

var _folder := DirAccess.create_temp("steadyhand_evaluation")


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


func test_a_broken_track_does_not_lose_the_others() -> void:
	# expects error: measured.csv:4
	var trials := Rig.write_trials(_path("broken"), 2)
	var name: String = trials.get_trial(1)["trial"]
	var track := "t,index_x,index_y,index_z\n0,0,0,0\n1,0,0,0\n2,0,zero,0\n"
	FileAccess.open(trials.get_measured_path(1), FileAccess.WRITE).store_string(track)
	var evaluation := _evaluate(trials, "broken_out")
	check_equal(evaluation.broken, 1, "one is counted")
	var rows := _lines("broken_out/results.csv")
	check_equal(rows.size(), trials.get_count(), "the other trials are there")
	check(not "\n".join(rows).contains(name), "it is not")


func test_invalid_trials_are_reported_and_left_out() -> void:
	var trials := Rig.write_trials(_path("odd"), 4)
	var table := _lines("odd/trials.csv")
	var names: Array[String] = []
	for row in table.slice(1):
		names.append(row.get_slice(",", 0))
	_replace_cells(table, 1, {4: "100", 5: "101"})
	TrackText.keep_frames(trials.get_reference_path(1), -INF, trials.get_trial(1)["end_s"] - 0.05)
	TrackText.keep_frames(trials.get_reference_path(2), trials.get_trial(2)["start_s"] + 0.05, INF)
	_write_blind_reference(trials, 3)
	_replace_cells(table, 5, {1: "swipe"})
	_replace_cells(table, 6, {1: "ring", 6: "", 7: "", 8: "", 9: "", 10: "", 11: "", 12: ""})
	table.append(table[8])
	_replace_cells(table, 9, {0: "backwards", 12: "-0.2"})
	FileAccess.open(_path("odd/trials.csv"), FileAccess.WRITE).store_string("\n".join(table))

	var run := ToolRun.new("evaluate", ["--trials", _path("odd"), "--out", _path("odd_out")])
	check_equal(run.exit_code, 1, "exit code")
	var row := "trials.csv:10: amplitude_m: '-0.2' is not positive; the trial is left out"
	check_equal(run.missing([row]), "", "the message names the bad row")
	for place: int in [0, 1, 2]:
		var reference := trials.get_reference_path(place)
		_check_left_out(run, names[place], ["is not within the reference", reference])
	_check_left_out(run, names[3], ["the reference holds no motion of index_along_axis"])
	_check_left_out(run, names[5], ["no amplitude_m"])
	var folder := ProjectSettings.globalize_path(ModelFolder.INSTALLED)
	var without := "trials of 'swipe' have no figures: no model of it in %s" % folder
	check_equal(run.missing([without]), "", "the message names the gesture without a model")
	var number := "6 trials left out, 1 trial without figures"
	check_equal(run.missing([number]), "", "and how many")

	var rows := _lines("odd_out/results.csv")
	check_equal(rows.size(), 4, "the other trials are there")
	var summary: Dictionary = JSON.parse_string("\n".join(_lines("odd_out/summary.json")))
	for group: Dictionary in summary["groups"]:
		if group["gesture"] == "swipe":
			check_equal(group["conditions"], {}, "no figures without a model")
			continue
		var own := Array(rows).filter(
			func(row: String) -> bool: return row.contains("drag,%s" % group["position"])
		)
		var r2: float = group["conditions"]["measured"]["r2"]["mean"]
		check_equal(own.size(), 1, "one sound drag is %s" % group["position"])
		check_near(r2, own[0].get_slice(",", 5).to_float(), 1e-6, "its R2 is the mean")


func test_only_a_hand_that_is_never_tracked_is_reported() -> void:
	var trials := Rig.write_trials(_path("unseen"), 1, "circle")
	DirAccess.make_dir_absolute(_path("circles"))
	var model := GestureTrainer.new().train(trials, "circle")
	check_equal(ResourceSaver.save(model, _path("circles/circle.gesture")), OK, "a model is saved")
	var blind := "t,index_x,index_y,index_z\n0,,,\n5,,,\n"
	FileAccess.open(trials.get_measured_path(1), FileAccess.WRITE).store_string(blind)
	for context: String in Evaluation.CONTEXTS:
		var options := ["--trials", _path("unseen"), "--out", _path("unseen_out")]
		options += ["--models", _path("circles"), "--context", context]
		var run := ToolRun.new("evaluate", options)
		check_equal(run.exit_code, 0, "exit code")
		var note := "trial %s: its measured track has no motion"
		check_equal(
			run.missing([note % trials.get_trial(1)["trial"]]),
			"",
			"a note for a tracker that sees nothing"
		)
		var seen := note % trials.get_trial(0)["trial"]
		check(not run.output.contains(seen), "no note for a tracked hand: %s" % context)


func test_wrong_recordings_are_reported() -> void:
	var far := "its reference reaches "
	var messages: Dictionary[String, String] = {
		backwards = far,
		elsewhere = "its reference comes no nearer to its start than ",
		millimetres = far,
		millimetres_seen = "its measured track reaches ",
		short = "its measured track ends at ",
		late = "its measured track begins at ",
		slow = "its measured track lasts ",
	}
	for wrong: String in messages:
		var trials := Rig.write_trials(_path(wrong))
		var table := _lines(wrong + "/trials.csv")
		match wrong:
			"backwards":
				_replace_cells(table, 1, {9: "-1"})
			"elsewhere":
				var start_x: float = trials.get_trial(0)["start"].x - 0.4
				_replace_cells(table, 1, {6: "%.6f" % start_x})
			"millimetres":
				_replace_cells(table, 1, {12: "200"})
			"millimetres_seen":
				TrackText.scale(trials.get_measured_path(0), "index_x", 1000.0)
			"short":
				var half_way_s: float = trials.get_trial(0)["end_s"] - 0.3
				TrackText.keep_frames(trials.get_measured_path(0), -INF, half_way_s)
			"late":
				var end_s: float = trials.get_trial(0)["end_s"]
				TrackText.keep_frames(trials.get_measured_path(0), end_s + 0.1, INF)
			"slow":
				TrackText.scale(trials.get_measured_path(0), "t", 100.0)
		var text := "\n".join(table) + "\n"
		FileAccess.open(_path(wrong + "/trials.csv"), FileAccess.WRITE).store_string(text)
		var options := ["--trials", _path(wrong), "--out", _path(wrong + "_out")]
		var run := ToolRun.new("evaluate", options)
		check_equal(run.exit_code, 0, "%s: the trial is evaluated" % wrong)
		var message: String = "trial %s: %s" % [trials.get_trial(0)["trial"], messages[wrong]]
		check_equal(run.missing([message]), "", wrong)
		var sound := "trial %s:" % trials.get_trial(1)["trial"]
		check(
			not run.output.contains(sound), "%s: the report does not name the other trial" % wrong
		)


func test_a_gesture_of_minutes_is_left_out() -> void:
	var trials := Rig.write_trials(_path("minutes"))
	_end_reference(trials, "1500")
	var table := _lines("minutes/trials.csv")
	_replace_cells(table, 1, {5: "1500"})
	FileAccess.open(_path("minutes/trials.csv"), FileAccess.WRITE).store_string("\n".join(table))
	var run := ToolRun.new(
		"evaluate", ["--trials", _path("minutes"), "--out", _path("minutes_out")]
	)
	check_equal(run.exit_code, 1, "exit code")
	_check_left_out(run, trials.get_trial(0)["trial"], ["its gesture lasts 1499", "in seconds?"])
	check_equal(
		_lines("minutes_out/results.csv").size(), trials.get_count(), "the other trials are there"
	)


func test_a_record_of_seven_hours_is_left_out() -> void:
	var trials := Rig.write_trials(_path("hours"))
	_append_hours(trials, 7)
	var run := ToolRun.new("evaluate", ["--trials", _path("hours"), "--out", _path("hours_out")])
	check_equal(run.exit_code, 1, "exit code")
	var why: Array[String] = ["its reference lasts 252", trials.get_reference_path(0)]
	_check_left_out(run, trials.get_trial(0)["trial"], why)
	check(not run.output.contains("ERROR"), "no other error")
	check_equal(
		_lines("hours_out/results.csv").size(), trials.get_count(), "the other trials are there"
	)


func test_a_reference_with_a_clock_jump_is_evaluated() -> void:
	var trials := Rig.write_trials(_path("jump"))
	_end_reference(trials, "1e9")
	var run := ToolRun.new("evaluate", ["--trials", _path("jump"), "--out", _path("jump_out")])
	check_equal(run.exit_code, 0, "exit code")
	check_equal(run.missing(["t: the clock jumps by 1e+09 s"]), "", "a warning names the jump")
	check_equal(
		_lines("jump_out/results.csv").size(), trials.get_count() + 1, "all trials are there"
	)


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


## `cells`: by column.
static func _replace_cells(table: PackedStringArray, row: int, cells: Dictionary) -> void:
	var old := table[row].split(",")
	for column: int in cells:
		old[column] = cells[column]
	table[row] = ",".join(old)


## The first trial's reference has its last frame at `time_s`.
static func _end_reference(trials: TrialSet, time_s: String) -> void:
	var path := trials.get_reference_path(0)
	var lines := FileAccess.get_file_as_string(path).split("\n", false)
	lines[-1] = time_s + lines[-1].substr(lines[-1].find(","))
	FileAccess.open(path, FileAccess.WRITE).store_string("\n".join(lines) + "\n")


## Adds rows, an hour apart, after the reference's last one.
static func _append_hours(trials: TrialSet, count: int) -> void:
	var path := trials.get_reference_path(0)
	var text := FileAccess.get_file_as_string(path)
	var last := text.split("\n", false)[-1]
	for hour in range(1, count + 1):
		text += "%.3f%s\n" % [last.to_float() + 3599.9 * hour, last.substr(last.find(","))]
	FileAccess.open(path, FileAccess.WRITE).store_string(text)


## A reference that tracks only the wrist.
static func _write_blind_reference(trials: TrialSet, index: int) -> void:
	var track := "t,wrist_x,wrist_y,wrist_z\n"
	for frame in 1000:
		track += "%.2f,0,0,%.6f\n" % [0.01 * frame, 1e-4 * (frame % 3)]
	FileAccess.open(trials.get_reference_path(index), FileAccess.WRITE).store_string(track)


func _check_left_out(run: ToolRun, trial: String, why: Array[String]) -> void:
	var texts := PackedStringArray(["trial %s left out: " % trial])
	texts.append_array(PackedStringArray(why))
	check_equal(run.missing(texts), "", "%s: %s" % [trial, why[0]])


func _fault(arguments: PackedStringArray, known: Dictionary[String, String]) -> String:
	var line := CommandLine.new(arguments, known)
	line.path("trials")
	line.choice("mode", ["paper"])
	return line.error


func _evaluate(trials: TrialSet, out: String, context := "scene") -> Evaluation:
	var evaluation := Evaluation.new()
	var settings := {mode = "paper", context = context, models = ModelFolder.INSTALLED}
	evaluation.run(trials, ModelFolder.load_all(ModelFolder.INSTALLED), settings, _path(out), root)
	return evaluation


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


func _lines(name: String) -> PackedStringArray:
	return FileAccess.get_file_as_string(_path(name)).split("\n", false)


func _path(name: String) -> String:
	return _folder.get_current_dir().path_join(name)
