extends "support/scene_test.gd"
## LslOutlet without liblsl, and with it where STEADYHAND_LSL names it.

const StudyScene := preload("res://study/study_scene.gd")

const FRAMES := 20
const NO_LIBRARY := "/none/liblsl.so"

var _folder := DirAccess.create_temp("steadyhand_lsl")
var _given := OS.get_environment("STEADYHAND_LSL")


# expects one warning: LslOutlet '/root/Outlet': cannot load liblsl
func test_without_liblsl_it_warns_once_and_frames_go_on() -> void:
	OS.set_environment("STEADYHAND_LSL", NO_LIBRARY)
	var outlet := _outlet()
	check(not outlet.is_active(), "it is not active")
	check_equal(_push_frames(outlet), FRAMES, "frames go on")
	root.remove_child(outlet)
	root.add_child(outlet)
	check(not outlet.is_active(), "it stays inactive in the tree again")
	outlet.stream_name = "Other"
	check_equal(outlet.stream_name, "Other", "its name can be changed")
	_free(outlet)


# expects error: stream_name must not be empty
func test_an_empty_stream_name_is_refused() -> void:
	var outlet := LslOutlet.new()
	outlet.stream_name = ""
	check_equal(outlet.stream_name, "SteadyHand", "the name is kept")
	outlet.free()


func test_a_freed_tracker_is_forgotten() -> void:
	var outlet := LslOutlet.new()
	var tracker := HandTracker.new()
	outlet.tracker = tracker
	tracker.free()
	check(outlet.tracker == null, "the tracker is forgotten")
	outlet.free()


func test_the_study_scene_has_an_outlet_where_use_lsl_is_on() -> void:
	# expects one warning: LslOutlet '/root/Study/Outlet': cannot load liblsl
	OS.set_environment("STEADYHAND_LSL", NO_LIBRARY)
	for use_lsl: bool in [false, true]:
		var scene := (
			(load("res://study/study_scene.tscn") as PackedScene).instantiate() as StudyScene
		)
		scene.study_folder = _folder.get_current_dir().path_join(str(use_lsl))
		scene.use_lsl = use_lsl
		root.add_child(scene)
		check_equal(scene.run_session("p01"), OK, "a session starts")
		check_equal(scene.lsl != null, use_lsl, "an outlet: %s" % use_lsl)
		if use_lsl:
			var outlet := scene.lsl as LslOutlet
			check(outlet.tracker == scene.runner.hand.tracker, "it has the hand's tracker")
		scene.free()


func test_with_liblsl_frames_and_events_are_sent() -> void:
	OS.set_environment("STEADYHAND_LSL", _given)
	if _given.is_empty():
		skip("STEADYHAND_LSL does not name liblsl")
		return
	var outlet := _outlet()
	check(outlet.is_active(), "it is active")
	check_equal(_push_frames(outlet), FRAMES, "frames go on")
	outlet.source_id = "test"
	check(outlet.is_active(), "its streams are open again after a change")
	root.remove_child(outlet)
	check(not outlet.is_active(), "it is not active outside the tree")
	root.add_child(outlet)
	check(outlet.is_active(), "it is active in the tree again")
	_free(outlet)


func _outlet() -> LslOutlet:
	var tracker := HandTracker.new()
	tracker.update_mode = HandTracker.UPDATE_MANUAL
	tracker.source = ScriptSource.new()
	var outlet := LslOutlet.new()
	outlet.name = "Outlet"
	outlet.tracker = tracker
	root.add_child(tracker)
	root.add_child(outlet)
	tracker.start()
	return outlet


## How many frames the tracker delivered.
func _push_frames(outlet: LslOutlet) -> int:
	var times: Array[float] = []
	var keep := func(frame: HandFrame) -> void: times.append(frame.time)
	outlet.tracker.frame_received.connect(keep)
	for i in FRAMES:
		var joints := {HandTracker.JOINT_INDEX: Vector3(0.01 * i, 0.1, 0.2)}
		outlet.tracker.push_frame(0.01 * i, joints, 1.0)
		outlet.push_event("frame %d" % i)
	return times.size()


func _free(outlet: LslOutlet) -> void:
	outlet.tracker.free()
	outlet.free()
