extends "support/scene_test.gd"
## A replay gives the same bits, however fast it is stepped.

const Rig := preload("support/rig.gd")

const FIRST_STEP := 0
const LAST_STEP := 2400
const COARSE := 8

var _folder := DirAccess.create_temp("steadyhand_replay")
var _trials := Rig.write_trials(_folder.get_current_dir())


func test_twice_the_same_bits() -> void:
	for index in _trials.get_count():
		var rig := _make_rig(index)
		var once := rig.record(FIRST_STEP, LAST_STEP)
		rig.gesture_hmm.reset()
		var again := rig.record(FIRST_STEP, LAST_STEP)
		rig.free_nodes()
		var fresh := _make_rig(index)
		var anew := fresh.record(FIRST_STEP, LAST_STEP)
		fresh.free_nodes()
		check(once.to_byte_array() == again.to_byte_array(), "trial %d started again" % index)
		check(once.to_byte_array() == anew.to_byte_array(), "trial %d with new nodes" % index)


func test_the_size_of_the_steps_does_not_matter() -> void:
	for index in _trials.get_count():
		var fine_rig := _make_rig(index)
		var fine := fine_rig.record(FIRST_STEP, LAST_STEP)
		fine_rig.free_nodes()
		var coarse_rig := _make_rig(index)
		var coarse := coarse_rig.record(FIRST_STEP, LAST_STEP, COARSE)
		coarse_rig.free_nodes()
		var width := Rig.MOTIONS.size()
		var common := PackedFloat64Array()
		for i in range(0, fine.size(), COARSE * width):
			common.append_array(fine.slice(i, i + width))
		check(
			common.to_byte_array() == coarse.to_byte_array(),
			"trial %d: 8 ms steps as 1 ms steps" % index
		)


func test_a_track_in_memory_plays_without_its_file() -> void:
	var path := _folder.get_current_dir().path_join("kept.csv")
	DirAccess.copy_absolute(_trials.get_measured_path(0), path)
	var source := RecordedSource.new()
	source.recording = RecordedTrack.load_file(path)
	DirAccess.remove_absolute(path)
	var from_file := _make_rig(0)
	var from_memory := _make_rig(0)
	from_memory.tracker.source = source
	check_equal(from_memory.tracker.start(), OK, "it starts")
	check(
		(
			from_file.record(FIRST_STEP, LAST_STEP).to_byte_array()
			== from_memory.record(FIRST_STEP, LAST_STEP).to_byte_array()
		),
		"the motion is that of the file"
	)
	from_file.free_nodes()
	from_memory.free_nodes()


func test_a_track_without_frames_is_refused() -> void:
	# expects one error: empty.csv: this track has no frames; record it again
	# expects one error: recording has no frames: take it from RecordedTrack.load_file()
	var path := _folder.get_current_dir().path_join("empty.csv")
	FileAccess.open(path, FileAccess.WRITE).store_string("t,index_x,index_y,index_z\n")
	check(RecordedTrack.load_file(path) == null, "it is not loaded")
	var source := RecordedSource.new()
	source.recording = RecordedTrack.new()
	check(source.recording == null, "a source keeps none")


func test_the_hand_moves_at_all() -> void:
	var rig := _make_rig(0)
	var values := rig.record(FIRST_STEP, LAST_STEP)
	check_equal(String(rig.gesture_hmm.recognised), "horizontal_drag", "the drag is recognised")
	var last := values[values.size() - 1]
	check_near(last, rig.task.amplitude, 0.02, "the synthesised motion ends where the task ends")
	rig.free_nodes()


func _make_rig(index: int) -> Rig:
	return Rig.new(_trials.get_trial(index), _trials.get_measured_path(index), root)
