extends "support/evaluation_test.gd"
## Trials that an evaluation leaves out, and its report of them.

const Rig := preload("support/rig.gd")
const ToolRun := preload("support/tool_run.gd")
const TrackText := preload("support/track_text.gd")


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
