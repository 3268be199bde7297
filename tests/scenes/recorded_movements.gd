extends "support/scene_test.gd"
## The movements that the editor's panel finds in recordings of real and simulated hands.

const Movements := preload("res://addons/steadyhand/editor/gestures/movements.gd")
const Rig := preload("support/rig.gd")
const TrackCurves := preload("res://addons/steadyhand/editor/gestures/track_curves.gd")

const SHARED := "../../shared/real/%s"
const SETS: Array[String] = ["drags", "drags_train"]
## Share of the amplitude of the reference sensor's track.
const AMPLITUDE_TOLERANCE := 0.2
const RATE_HZ := 200.0
const SAME_WAY := 0.8
const FOUND_SHARE := 0.95

var _folder := DirAccess.create_temp("steadyhand_movements")


func test_real_drags_are_found_where_their_tasks_are() -> void:
	for name in SETS:
		var path := ProjectSettings.globalize_path("res://").path_join(SHARED % name)
		if not FileAccess.file_exists(path.path_join("trials.csv")):
			skip("no recordings in %s" % path)
			continue
		var count := 0
		var found := 0
		var trials := TrialSet.load_folder(path)
		for i in trials.get_count():
			if trials.get_trial(i)["position"] == "stable":
				count += 1
				found += int(_is_found(trials, i))
		check(found >= FOUND_SHARE * count, "%s: %d of %d are found" % [name, found, count])


func test_simulated_gestures_are_found_with_their_shape() -> void:
	for gesture: String in ["horizontal_drag", "vertical_drag", "tap", "zoom"]:
		var trials := Rig.write_trials(_folder.get_current_dir().path_join(gesture), 8, gesture)
		for i in trials.get_count():
			if trials.get_trial(i)["position"] == "stable":
				check(_is_found(trials, i), "%s is found" % trials.get_trial(i)["trial"])


## One movement overlaps the trial and has its direction and about its length.
func _is_found(trials: TrialSet, index: int) -> bool:
	var trial := trials.get_trial(index)
	var curves := TrackCurves.read(trials.get_measured_path(index))
	var is_radius := (trial["axis"] as Vector3).is_zero_approx()
	var shape := Movements.Shape.OPENING if is_radius else Movements.Shape.STRAIGHT
	if Movements.guess_shape(curves) != shape:
		return false
	var true_way := _true_way(trials, index, Movements.FEATURES[shape])
	for row in Movements.find(curves, Movements.Shape.AUTOMATIC):
		var overlaps: bool = row["start_s"] < trial["end_s"] and row["end_s"] > trial["start_s"]
		var share: float = row["amplitude_m"] / true_way
		var goes_its_way := is_radius or (row["axis"] as Vector3).dot(trial["axis"]) > SAME_WAY
		if overlaps and goes_its_way and absf(share - 1.0) < AMPLITUDE_TOLERANCE:
			return true
	return false


## Length of the reference, m: a tap continues below its surface.
func _true_way(trials: TrialSet, index: int, feature: String) -> float:
	var trial := trials.get_trial(index)
	var curves := TrackCurves.read(trials.get_reference_path(index))
	var track := RecordedTrack.load_file(trials.get_reference_path(index))
	var curve := MotionMetrics.feature_curve(
		track, feature, trial, curves.start_s, RATE_HZ, curves.count()
	)
	return Array(curve).max() * trial["amplitude_m"]
