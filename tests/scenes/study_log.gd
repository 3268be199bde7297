extends "support/scene_test.gd"
## The columns of trials.csv that a study needs: participant, task, place and time of the end.

const DragStage := preload("res://scripts/drag_stage.gd")
const LiveHand := preload("support/live_hand.gd")
const Participant := preload("res://scripts/participant.gd")
const Rig := preload("support/rig.gd")
const TaskPlayer := preload("support/task_player.gd")
const Tasks := preload("res://scripts/tasks.gd")
const TrialRows := preload("support/trial_rows.gd")
const ZoomStage := preload("res://scripts/zoom_stage.gd")

const HEADER := (
	"trial,gesture,position,condition,start_s,end_s,duration_s"
	+ ",participant,amplitude_m,width_m,end_value_m,gesture_end_s,origin"
)
## Widths of the 4 cm marker, the 4 mm plate, and the ring from 45 to 48 mm around a sphere of
## 15 mm, which grows by 30 mm together with the hand's circle.
const WIDTHS: Dictionary[String, float] = {
	"horizontal_drag": 0.04, "vertical_drag": 0.04, "tap": 0.004, "zoom": 0.003
}
## Ends of drags of 20 cm, m.
const ENDS: PackedFloat64Array = [0.19, 0.205, 0.21, 0.195, 0.2]
## A drag may end before its last millimetre.
const END_ERROR_M := 0.0025

var _folder := DirAccess.create_temp("steadyhand_study_log")


func test_drags_whose_ends_are_known() -> void:
	Participant.chosen = 'Doe, "J"'
	var player := TaskPlayer.new("horizontal_drag", _folder.get_current_dir(), self)
	Participant.chosen = ""
	var scene := player.scene
	scene.gesture_hmm.motion = GestureHMM.MOTION_MEASURED
	scene.follow_live()
	var hand := LiveHand.new()
	var ended: Array[float] = []
	for way in ENDS:
		hand.make_gesture(scene, way)
		# 1 s of rest after 1 s of movement.
		ended.append(hand.time_s - 1.0)
	var session := scene.session_folder
	var rows := _rows(session, player)
	check_equal(rows.size(), ENDS.size(), "a row for each drag")
	for i in rows.size():
		var row := rows[i]
		check_equal(row["participant"], 'Doe, "J"', "drag %d: the participant" % i)
		check_equal(row["origin"], "person", "a person")
		check_equal(row["condition"], "measured", "by what")
		check_equal(row["amplitude_m"], "0.200000", "of how far")
		check_near(row["end_value_m"].to_float(), ENDS[i], END_ERROR_M, "where it ended")
		check_near(row["gesture_end_s"].to_float(), ended[i], 0.15, "when it ended")
		check(row["start_s"].to_float() > ended[i] - 1.0, "each drag has its own start")
	_check_frames(session, hand)


func test_a_live_source_names_who_makes_its_frames() -> void:
	var degraded := DegradedSource.new()
	degraded.source = SyntheticSource.new()
	var sources: Dictionary[String, HandSource] = {
		"person": ScriptSource.new(), "synthetic": degraded
	}
	for origin in sources:
		var folder := _folder.get_current_dir().path_join(origin)
		var player := TaskPlayer.new("tap", folder, self)
		player.scene.follow_live(sources[origin])
		var rows := _rows(player.scene.session_folder, player)
		check_equal(rows[0]["origin"], origin, "a live trial of a %s source" % origin)


func test_played_trials_name_their_subject() -> void:
	for gesture in Tasks.SCENES:
		var folder := _folder.get_current_dir().path_join(gesture)
		var trials := Rig.write_trials(folder, 1, gesture)
		var player := TaskPlayer.new(gesture, folder.path_join("logs"), self)
		for index in trials.get_count():
			player.scene.play(trials.get_trial(index), trials.get_measured_path(index))
			player.play_to_end()
		var rows := _rows(player.scene.session_folder, player)
		check_equal(rows.size(), trials.get_count(), "%s: a row for each trial" % gesture)
		for index in rows.size():
			var trial := trials.get_trial(index)
			check_equal(rows[index]["participant"], trial["subject"], "the participant")
			check_equal(rows[index]["origin"], "replay", "the origin is a replay")
			var amplitude: float = rows[index]["amplitude_m"].to_float()
			check_near(amplitude, trial["amplitude_m"], 1e-6, "the amplitude")
			check_near(rows[index]["width_m"].to_float(), WIDTHS[gesture], 1e-6, "the width")
			if trial["position"] == "stable":
				var end: float = rows[index]["end_value_m"].to_float()
				check_near(end / amplitude, 1.0, 0.15, "the end")


func test_a_trial_with_an_unreadable_track_is_skipped() -> void:
	# expects one error: tune_0_tap_unstable_0.measured.csv: there is no such file
	var folder := _folder.get_current_dir().path_join("unreadable")
	var trials := Rig.write_trials(folder, 2, "tap")
	DirAccess.remove_absolute(trials.get_measured_path(1))
	var player := TaskPlayer.new("tap", folder.path_join("logs"), self)
	player.scene.trial_folder = folder
	for i in 3:
		player.scene.play_next()
		if player.scene.tracker.is_running():
			player.play_to_end()
	var rows := _rows(player.scene.session_folder, player)
	var logged := rows.map(func(row: Dictionary) -> String: return row["trial"])
	var expected := [0, 2, 3].map(func(i: int) -> String: return trials.get_trial(i)["trial"])
	check_equal(logged, expected, "the other trials are played and logged")


func test_a_trial_without_an_end_is_reported() -> void:
	var player := TaskPlayer.new("tap", _folder.get_current_dir().path_join("never"), self)
	player.scene.follow_live()
	var hand := LiveHand.new()
	hand.move(player.scene, player.scene.task.get_start())
	var rows := _rows(player.scene.session_folder, player)
	check_equal(rows.size(), 1, "a row")
	for column: String in ["start_s", "end_s", "participant", "end_value_m", "gesture_end_s"]:
		check_equal(rows[0][column], "", "no %s" % column)


func test_sessions_of_one_second_have_folders_of_their_own() -> void:
	var folders: Dictionary[String, bool] = {}
	for session in 3:
		var player := TaskPlayer.new("tap", _folder.get_current_dir().path_join("thrice"), self)
		player.scene.follow_live()
		LiveHand.new().move(player.scene, player.scene.task.get_start())
		var folder := player.scene.session_folder
		check_equal(_rows(folder, player).size(), 1, "its one trial")
		folders[folder] = true
	check_equal(folders.size(), 3, "a folder each")


func test_the_width_of_an_oblique_marker() -> void:
	var player := TaskPlayer.new("horizontal_drag", _folder.get_current_dir(), self)
	var stage: DragStage = player.scene.get_node("Stage")
	player.scene.task.direction = Vector3(0.6, 0.0, -0.8)
	stage.place(player.scene.task, "")
	check_near(stage.target_width(), 0.05, 1e-6, "the length of the path through the box")
	player.scene.free()


func test_where_a_zoom_in_strokes_ends() -> void:
	var player := TaskPlayer.new("zoom", _folder.get_current_dir(), self)
	var stage: ZoomStage = player.scene.get_node("Stage")
	stage.begin_stroke()
	stage.show_motion(0.012)
	check_near(stage.end_value(0.012), 0.012, 1e-6, "a stroke of 12 of 30 mm")
	stage.begin_stroke()
	stage.show_motion(0.02)
	check_near(stage.end_value(0.02), 0.032, 1e-6, "the next stroke overshoots by 2 mm")
	check_near(player.body("Sphere").scale.x, 3.0, 1e-6, "the sphere stops at the target")
	player.scene.free()


## The test emits the signals itself.
func test_only_the_end_of_the_task_counts() -> void:
	var counted: Dictionary[String, float] = {"horizontal_drag": 1.0, "zoom": 2.0}
	for gesture in counted:
		var player := TaskPlayer.new(gesture, _folder.get_current_dir().path_join(gesture), self)
		var trial := Rig.write_trials(_folder.get_current_dir().path_join("ends"), 1, gesture)
		player.scene.play(trial.get_trial(0), trial.get_measured_path(0))
		var hmm := player.scene.gesture_hmm
		hmm.gesture_ended.emit(gesture, 0.5, null, 1.0)
		check(is_nan(player.scene.course.gesture_end_s), "%s: no end before a start" % gesture)
		hmm.gesture_started.emit(gesture, null)
		hmm.gesture_ended.emit(gesture, 1.0, null, 1.0)
		hmm.gesture_ended.emit(gesture, 2.0, null, 1.0)
		player.scene.course.end_s = 1.5
		hmm.gesture_ended.emit(gesture, 3.0, null, 1.0)
		check_equal(
			player.scene.course.gesture_end_s, counted[gesture], "the end that completed the task"
		)
		player.scene.free()


## Checks that each pushed frame was recorded.
func _check_frames(session: String, hand: LiveHand) -> void:
	var tracker := HandTracker.new()
	tracker.update_mode = HandTracker.UPDATE_MANUAL
	var source := RecordedSource.new()
	source.track = session.path_join("frames_01.csv")
	tracker.source = source
	root.add_child(tracker)
	var counted: Array[int] = [0]
	tracker.frame_received.connect(func(_frame: HandFrame) -> void: counted[0] += 1)
	check_equal(tracker.start(), OK, "the frames of a live hand are a track")
	tracker.advance(hand.time_s + 1.0)
	check_equal(counted[0], roundi(hand.time_s / LiveHand.FRAME_S), "all frames are recorded")
	tracker.free()


## Rows of the session, after freeing its scene.
func _rows(session: String, player: TaskPlayer) -> Array[Dictionary]:
	player.scene.free()
	check_equal(TrialRows.header(session), HEADER, "the columns, new ones last")
	return TrialRows.read(session)
