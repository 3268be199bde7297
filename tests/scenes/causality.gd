extends "support/scene_test.gd"
## The output at time t depends only on frames with time stamps up to t.

const Rig := preload("support/rig.gd")

const SUBJECTS := 2
const CUTS_PER_TRIAL := 4
const AFTER_STEPS := 400

var _folder := DirAccess.create_temp("steadyhand_causality")
var _random := RandomNumberGenerator.new()


func test_a_cut_track_gives_the_same_output_before_the_cut() -> void:
	_random.seed = 1
	var trials := Rig.write_trials(_folder.get_current_dir(), SUBJECTS)
	var later_differs := 0
	for index in trials.get_count():
		var trial := trials.get_trial(index)
		var path := trials.get_measured_path(index)
		for repetition in CUTS_PER_TRIAL:
			var cut_s := _random.randf_range(trial["start_s"], trial["end_s"])
			if _check_cut(trial, path, cut_s):
				later_differs += 1
	check(later_differs > 0, "frames after the cut change the output after it")


## True if the later output differs.
func _check_cut(trial: Dictionary, path: String, cut_s: float) -> bool:
	var first_step := floori((cut_s - 1.5) / Rig.STEP_S)
	var cut_step := floori(cut_s / Rig.STEP_S)
	var whole := _record(trial, path, first_step, cut_step + AFTER_STEPS)
	var cut := _record(trial, _cut_track(path, cut_s), first_step, cut_step + AFTER_STEPS)
	var before := (cut_step - first_step + 1) * Rig.MOTIONS.size()
	check(
		whole.slice(0, before).to_byte_array() == cut.slice(0, before).to_byte_array(),
		"%s cut at %.4f s: the same bits before" % [trial["trial"], cut_s]
	)
	return whole != cut


func _record(
	trial: Dictionary, path: String, first_step: int, last_step: int
) -> PackedFloat64Array:
	var rig := Rig.new(trial, path, root)
	var values := rig.record(first_step, last_step)
	rig.free_nodes()
	return values


## The path of a copy that ends with the last frame stamped at or before `cut_s`.
func _cut_track(path: String, cut_s: float) -> String:
	var cut_path := _folder.get_current_dir().path_join("cut.csv")
	var cut := FileAccess.open(cut_path, FileAccess.WRITE)
	for line in FileAccess.get_file_as_string(path).split("\n", false):
		var stamp := line.get_slice(",", 0)
		if not stamp.is_valid_float() or stamp.to_float() <= cut_s:
			cut.store_line(line)
	return cut_path
