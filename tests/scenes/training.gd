extends "support/scene_test.gd"
## The trainer is repeatable and cancellable, and reproduces the models of the repository.

const Rig := preload("support/rig.gd")
const OwnModels := preload("res://tools/own_models.gd")
const Repository := preload("res://tools/repository.gd")
const ToolRun := preload("support/tool_run.gd")
const TrackText := preload("support/track_text.gd")

const GESTURE := &"horizontal_drag"

var _folder := DirAccess.create_temp("steadyhand_training")
var _trials := Rig.write_trials(_path("few"), 4)


func test_training_is_repeatable() -> void:
	var texts: Array[String] = []
	var reports: Array[float] = []
	for repetition in 2:
		var trainer := GestureTrainer.new()
		trainer.progressed.connect(func(done: float) -> void: reports.append(done))
		var model := trainer.train(_trials, GESTURE)
		texts.append(model.to_text() if model != null else "")
	check(texts[0].length() > 1000 and texts[0] == texts[1], "the same model")
	var first_run := reports.slice(0, reports.size() / 2)
	var sorted := first_run.duplicate()
	sorted.sort()
	check(first_run.size() > 20 and first_run[-1] == 1.0, "progress reaches 1")
	check_equal(first_run, sorted, "it never falls")


func test_own_models_are_reproduced() -> void:
	var trials := OwnModels.write_trials(_path("train"))
	for gesture in OwnModels.GESTURES:
		var trainer := GestureTrainer.new()
		trainer.without_task = false
		var model := trainer.train(trials, gesture)
		var path := Repository.absolute(Repository.MODELS).path_join(gesture + ".gesture")
		for recording in trainer.get_recordings():
			check_equal(recording["oddity"], "", recording["trial"])
		check(
			model.to_text() == FileAccess.get_file_as_string(path),
			"models/%s.gesture is what ./steadyhand train makes, bit for bit" % gesture
		)


func test_the_own_classifier_is_reproduced() -> void:
	var path := _path("classifier")
	check_equal(GestureTrainer.write_own_classifier(path), OK, "written")
	check(
		(
			FileAccess.get_file_as_string(path)
			== FileAccess.get_file_as_string(
				Repository.absolute(Repository.MODELS).path_join(OwnModels.CLASSIFIER)
			)
		),
		"models/%s is what ./steadyhand train makes, bit for bit" % OwnModels.CLASSIFIER
	)


func test_an_unwritable_model_path_is_reported_before_training() -> void:
	for out: String in ["/proc/none.gesture", _path("few/new.gesture")]:
		var options := ["--trials", _path("few"), "--gesture", String(GESTURE), "--out", out]
		var run := ToolRun.new("train", options)
		var may_write := not out.begins_with("/proc")
		check_equal(run.exit_code == 0, may_write, out)
		check_equal(run.output.contains("training %s" % GESTURE), may_write, "%s: trains" % out)
		check_equal(run.missing(["train: cannot write %s" % out]).is_empty(), not may_write, out)
		check_equal(FileAccess.file_exists(out), may_write, "%s: is there" % out)


func test_an_unknown_feature_is_reported_before_recordings_are_read() -> void:
	var options := ["--trials", _path("few"), "--gesture", String(GESTURE)]
	options += ["--out", _path("few/no.gesture"), "--feature", "toe_angle"]
	var run := ToolRun.new("train", options)
	check_equal(run.exit_code == 0, false, "refused")
	check_equal(
		run.missing(["%s: there is no feature 'toe_angle'" % GESTURE]),
		"",
		"the error names the feature"
	)
	check(not run.output.contains("training %s" % GESTURE), "no progress before the error")


func test_odd_recordings_are_reported_and_left_out() -> void:
	var trials := Rig.write_trials(_path("odd"), 4)
	var expected: Array[String] = [
		" is left out: its measured track reaches ",
		": its measured track ends at ",
		" is left out: its measured track has no motion of index_along_axis",
		" is left out: its measured track lasts ",
		" is left out: its reference moves from 0.51 amplitudes at start_s to 0.51 at end_s",
	]
	for index in 4:
		_damage(trials.get_measured_path(index), index, trials.get_trial(index)["end_s"])
	TrackText.scale(trials.get_reference_path(4), "index_x", 0.0)
	DirAccess.remove_absolute(trials.get_reference_path(5))
	var out := _path("odd/drag.gesture")
	var options := ["--trials", _path("odd"), "--gesture", String(GESTURE), "--out", out]
	var run := ToolRun.new("train", options)
	check_equal(run.exit_code, 0, "a model is trained of the others")
	check_equal(run.output.count("\ntrial "), expected.size() + 1, "other trials are not reported")
	for index in expected.size():
		var name: String = trials.get_trial(index)["trial"]
		var line: Array[String] = ["trial %s%s" % [name, expected[index]]]
		var is_reference := expected[index].contains("its reference")
		line.append(
			[trials.get_measured_path(index), trials.get_reference_path(index)][int(is_reference)]
		)
		check_equal(run.missing(line), "", expected[index])
	var unread := "trial %s is left out: %s: there is no such file"
	var missing := unread % [trials.get_trial(5)["trial"], trials.get_reference_path(5)]
	check_equal(run.missing([missing]), "", "the missing track is reported")
	var model := load(out) as GestureModel
	var names := _names(trials, expected.size() + 1)
	names.remove_at(1)
	var dropped: Array = model.get_provenance()["dropped"]
	for name in names:
		check(name in dropped, "%s is named as dropped" % name)
	var trainer := GestureTrainer.new()
	trainer.train(trials, GESTURE)
	for recording in trainer.get_recordings():
		var is_odd: bool = recording["trial"] in _names(trials, expected.size() + 1)
		check_equal(recording["oddity"].is_empty(), not is_odd, "%s: oddity" % recording["trial"])
		var curve: PackedFloat64Array = recording["curve"]
		check_equal(curve.is_empty(), recording["trial"] in names, "%s: curve" % recording["trial"])


func test_r2_threshold_drops_outlier_recordings() -> void:
	var out := _path("alike/drag.gesture")
	var options := ["--trials", _trials.get_path(), "--gesture", String(GESTURE), "--out", out]
	var run := ToolRun.new("train", options + ["--r2-threshold", "0.999"])
	var model := load(out) as GestureModel
	var kept: int = model.get_provenance()["recordings"]
	var of := _trials.get_count()
	check(kept < of, "%d of %d are kept" % [kept, of])
	var expected := (
		"train: %d of %d are less like the mean of all than R2 0.999: " % [of - kept, of]
	)
	check_equal(run.missing([expected]), "", "the report names the others")
	check_equal(model.get_provenance()["r2_threshold"], 0.999, "the model has the threshold")
	check_equal(ToolRun.new("train", options + ["--r2-threshold", "2"]).exit_code, 2, "a share")


func test_few_recordings_give_a_note() -> void:
	var note := "are too few to learn how much hands differ: record 8 or more"
	for subjects: int in [1, 8]:
		var set_name := "of_%d" % subjects
		var trials := Rig.write_trials(_path(set_name), subjects)
		var out := _path(set_name + ".gesture")
		var options := ["--trials", trials.get_path(), "--gesture", String(GESTURE), "--out", out]
		var run := ToolRun.new("train", options)
		check_equal(run.exit_code, 0, "%d people: a model is trained" % subjects)
		check_equal(note in run.output, subjects == 1, "%d people: the note" % subjects)


func test_provenance() -> void:
	var trainer := GestureTrainer.new()
	var model := trainer.train(_trials, GESTURE)
	var provenance := model.get_provenance()
	check_equal(
		provenance["trained_with"], "SteadyHand %s" % GestureTrainer.get_version(), "the version"
	)
	var kept := 0
	var sum := PackedFloat64Array()
	sum.resize(model.get_reference_mean().size())
	for recording in trainer.get_recordings():
		if not recording["kept"]:
			check(recording["trial"] in provenance["dropped"], "a dropped one is named")
			continue
		kept += 1
		var curve: PackedFloat64Array = recording["curve"]
		for i in sum.size():
			sum[i] += curve[i]
	check_equal(kept, provenance["recordings"], "the number of kept recordings is right")
	var worst := 0.0
	for i in sum.size():
		worst = maxf(worst, absf(sum[i] / kept - model.get_reference_mean()[i]))
	check(worst < 1e-12, "the reference curve is the mean of those kept, within %s" % worst)


func test_a_progress_handler_may_cancel_the_training() -> void:
	# While tracks are read, the codebook is made, and the HMM is trained.
	for limit: float in [0.1, 0.5, 0.7, 0.9]:
		var trainer := GestureTrainer.new()
		var reported: Array[float] = []
		trainer.progressed.connect(
			func(done: float) -> void:
				reported.append(done)
				if done >= limit:
					trainer.cancel()
		)
		check(trainer.train(_trials, GESTURE) == null, "cancelled at %s: no model" % limit)
		check(trainer.is_cancelled() and reported[-1] < 1.0, "the training stops")
		trainer.progressed.disconnect(trainer.progressed.get_connections()[0]["callable"])
		check(trainer.train(_trials, GESTURE) != null, "the next training is not cancelled")


func test_cancel_without_training_does_nothing() -> void:
	var trainer := GestureTrainer.new()
	trainer.cancel()
	check(not trainer.is_cancelled(), "there was nothing to cancel")


func test_cancelled_from_another_thread() -> void:
	var trainer := GestureTrainer.new()
	var is_training := Semaphore.new()
	var cancelled := Semaphore.new()
	var wait_once := func(_done: float) -> void:
		is_training.post()
		cancelled.wait()
	trainer.progressed.connect(wait_once, CONNECT_ONE_SHOT)
	var thread := Thread.new()
	thread.start(func() -> GestureModel: return trainer.train(_trials, GESTURE))
	is_training.wait()
	trainer.cancel()
	cancelled.post()
	check(thread.wait_to_finish() == null, "no model")


func test_training_on_a_gesture_without_trials_is_an_error() -> void:
	# expects error: no trial of the gesture 'zoom', but of horizontal_drag
	check(
		GestureTrainer.new().train(_trials, &"zoom") == null,
		"no model without trials of the gesture"
	)


func test_settings_out_of_range_are_refused() -> void:
	# expects error: GestureTrainer: states must be 1..20, is
	# expects error: GestureTrainer: symbols must be 1..1024, is
	# expects error: GestureTrainer: r2_threshold must be 0..1, is
	var trainer := GestureTrainer.new()
	trainer.states = 0
	trainer.symbols = 99999
	trainer.r2_threshold = 5.0
	check_equal(trainer.states, 4, "states")
	check_equal(trainer.symbols, 16, "symbols")
	check_equal(trainer.r2_threshold, 0.9, "r2_threshold")


func test_saving_leaves_no_partial_file() -> void:
	# expects error: no_such_folder
	var model := GestureTrainer.new().train(_trials, GESTURE)
	var path := _path("saved.gesture")
	FileAccess.open(path, FileAccess.WRITE).store_string("an older one")
	check_equal(ResourceSaver.save(model, path), OK, "an older file is replaced")
	check_equal(FileAccess.get_file_as_string(path), model.to_text(), "the file is complete")
	check(not FileAccess.file_exists(path + ".part"), "no partial file is left")
	var nowhere := _path("no_such_folder/saved.gesture")
	check(ResourceSaver.save(model, nowhere) != OK, "an unwritable path is an error")


func test_an_invalid_model_name_is_refused_before_training() -> void:
	for name: String in ["nameless", "odd.txt", "a_file/tap.gesture"]:
		FileAccess.open(_path("a_file"), FileAccess.WRITE).store_string("no folder")
		var run := _train_to(name)
		check_equal(run.exit_code, 2, "%s: exit code" % name)
		check_equal(
			run.missing(["train: ", _path(name).get_base_dir()]), "", "the message names the path"
		)
		check(not run.output.contains("training %s" % GESTURE), "nothing is trained")
		check(not FileAccess.file_exists(_path(name)), "nothing is written")
	var ending := _train_to("nameless").missing(["train: ", ".gesture"])
	check_equal(ending, "", "the error names the ending")


func test_a_model_that_cannot_be_saved_is_an_error() -> void:
	DirAccess.make_dir_absolute(_path("folder.gesture"))
	var run := _train_to("folder.gesture")
	check_equal(run.exit_code, 2, "exit code")
	check_equal(run.missing(["cannot write %s" % _path("folder.gesture")]), "", "the message")


## Names of the first trials.
static func _names(trials: TrialSet, count: int) -> Array[String]:
	var names: Array[String] = []
	for index in count:
		names.append(trials.get_trial(index)["trial"])
	return names


## Damages a track by one of several faults.
static func _damage(path: String, fault: int, end_s: float) -> void:
	match fault:
		0:
			TrackText.scale(path, "index_x", 1000.0)
		1:
			TrackText.keep_frames(path, -INF, end_s - 0.3)
		2:
			var text := FileAccess.get_file_as_string(path).replace("index_", "other_")
			FileAccess.open(path, FileAccess.WRITE).store_string(text)
		3:
			TrackText.scale(path, "t", 1000.0)


func _train_to(name: String) -> ToolRun:
	return ToolRun.new(
		"train", ["--trials", _trials.get_path(), "--gesture", GESTURE, "--out", _path(name)]
	)


func _path(name: String) -> String:
	return _folder.get_current_dir().path_join(name)
