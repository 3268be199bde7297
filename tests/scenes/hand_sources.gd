extends "support/scene_test.gd"
## Common behaviour of all sources, and sources in GDScript.

const PushedHand := preload("support/pushed_hand.gd")
const Rig := preload("support/rig.gd")
const XRHand := preload("support/xr_hand.gd")

const FRAME_S := 0.01
const INDEX := HandTracker.JOINT_INDEX
const PLACE := Vector3(0.1, 1.2, -0.3)


class Scene:
	extends Node3D
	## As newcomers write it: the source is set in _ready().

	var tracker := HandTracker.new()
	var source := SyntheticSource.new()

	func _init() -> void:
		add_child(tracker)

	func _ready() -> void:
		tracker.source = source


class AheadSource:
	extends HandSource
	var polls := 0

	func _poll(tracker: HandTracker, time_s: float) -> void:
		polls += 1
		tracker.push_frame(time_s + 1000.0, {HandTracker.JOINT_INDEX: Vector3.ONE})


class CountingSource:
	extends HandSource
	var refusal := ""
	var calls: Array[String] = []

	func _start(_tracker: HandTracker) -> String:
		calls.append("start")
		return refusal

	func _poll(tracker: HandTracker, time_s: float) -> void:
		if calls[-1] != "poll":
			calls.append("poll")
		tracker.push_frame(time_s, {HandTracker.JOINT_INDEX: Vector3.ONE})

	func _stop(_tracker: HandTracker) -> void:
		calls.append("stop")


func test_a_source_set_in_ready_starts_by_itself() -> void:
	var scene := Scene.new()
	root.add_child(scene)
	await process_frame
	await process_frame
	check(scene.tracker.is_running(), "it runs")
	scene.tracker.source = null
	check(not scene.tracker.is_running(), "it stops without a source")
	scene.free()


func test_a_tracker_without_a_source_is_an_error() -> void:
	# expects one error: set "source", e.g. to an XRSource
	# expects one error: push_frame: set "source" to a ScriptSource first: it is empty
	# expects one error: push_frame: set "source" to a ScriptSource first: its SyntheticSource makes
	var tracker := _tracker(null)
	check_equal(tracker.start(), ERR_CANT_OPEN, "it cannot start")
	tracker.push_frame(0.0, {INDEX: PLACE})
	tracker.source = SyntheticSource.new()
	tracker.start()
	tracker.push_frame(0.0, {INDEX: PLACE})
	tracker.free()


func test_a_source_in_gdscript() -> void:
	# expects one error: plug it in
	var source := CountingSource.new()
	source.refusal = "plug it in"
	var tracker := HandTracker.new()
	tracker.source = source
	var reasons: Array[String] = []
	tracker.failed.connect(func(reason: String) -> void: reasons.append(reason))
	root.add_child(tracker)
	check_equal(reasons, ["plug it in"] as Array[String], "the signal gives the reason")
	source.refusal = ""
	tracker.start()
	await process_frame
	await process_frame
	check(tracker.is_joint_tracked(INDEX), "its frames come")
	tracker.free()
	check_equal(source.calls, ["start", "start", "poll", "stop"] as Array[String], "the calls")


func test_the_source_of_the_docs() -> void:
	var docs := ProjectSettings.globalize_path("res://").path_join("../docs/new_source.md")
	var text := FileAccess.get_file_as_string(docs)
	var code := text.get_slice("```gdscript\n", 1).get_slice("```", 0)
	var script := GDScript.new()
	# A second global class of that name is an error.
	script.source_code = code.replace("class_name UdpSource\n", "")
	check_equal(script.reload(), OK, "it compiles")
	var source := script.new() as HandSource
	source.set("port", 39771)
	var tracker := HandTracker.new()
	tracker.source = source
	root.add_child(tracker)
	var sender := PacketPeerUDP.new()
	sender.connect_to_host("127.0.0.1", 39771)
	sender.put_packet('{"t": 1.5, "10": [0.1, 0.2, -0.3]}'.to_utf8_buffer())
	# expects one error: UdpSource: a packet has no number "t": nonsense
	sender.put_packet("nonsense".to_utf8_buffer())
	for i in 20:
		await process_frame
		OS.delay_msec(2)
	check_equal(tracker.get_time(), 1.5, "the frame's time")
	check_equal(tracker.get_joint_position(INDEX), Vector3(0.1, 0.2, -0.3), "its joint")
	tracker.free()


func test_a_source_is_published_as_an_xr_hand_tracker() -> void:
	var name := &"/steadyhand/left"
	var tracker := _tracker(ScriptSource.new())
	tracker.publish_name = name
	tracker.publish_hand = HandTracker.HAND_LEFT
	check(XRServer.get_tracker(name) == null, "not published before it runs")
	tracker.start()
	var hand := XRServer.get_tracker(name) as XRHandTracker
	check_equal(hand.hand, XRPositionalTracker.TRACKER_HAND_LEFT, "the left hand")
	tracker.push_frame(0.0, {INDEX: PLACE, HandTracker.JOINT_WRIST: PLACE + Vector3(0, 0, 0.18)})
	check(hand.has_tracking_data, "it is tracked")
	var tip := XRHandTracker.HAND_JOINT_INDEX_FINGER_TIP
	check_equal(hand.get_hand_joint_transform(tip).origin, PLACE, "a measured joint")
	check(_is_measured(hand, tip), "a tracked joint is marked as tracked")
	var middle := XRHandTracker.HAND_JOINT_INDEX_FINGER_PHALANX_INTERMEDIATE
	check(not _is_measured(hand, middle), "an inferred one is valid only")
	check(hand.get_hand_joint_flags(middle) & XRHand.INFERRED != 0, "the inferred joint is present")
	check_equal(hand.get_hand_joint_flags(XRHandTracker.HAND_JOINT_THUMB_TIP), 0, "no thumb")
	var again := _tracker(XRSource.new())
	(again.source as XRSource).tracker_name = name
	again.advance(FRAME_S)
	check_equal(again.get_joint_position(INDEX), PLACE, "another tracker reads it")
	again.free()
	for frame in range(1, 30):
		tracker.push_frame(frame * FRAME_S, {})
	check(not hand.has_tracking_data, "a lost hand")
	tracker.free()
	check(XRServer.get_tracker(name) == null, "not published after it is freed")


func test_a_name_that_is_taken_is_not_published() -> void:
	# expects one error: its XRSource reads the tracker '
	# expects one error: has a tracker '/user/hand_tracker/left' already
	var hand := XRHand.new()
	hand.place(PLACE)
	hand.register()
	var tracker := _tracker(XRSource.new())
	tracker.publish_name = XRHand.RIGHT
	var left := XRHand.new(XRHand.LEFT)
	left.register()
	tracker.publish_name = XRHand.LEFT
	check(XRServer.get_tracker(XRHand.LEFT) == left.tracker, "the runtime's tracker stays")
	tracker.free()
	check(
		XRServer.get_tracker(XRHand.LEFT) == left.tracker, "it also stays after the node is freed"
	)
	left.remove()
	hand.remove()


func test_endless_recursion_of_advance_is_an_error() -> void:
	# expects error: advance() calls itself
	var source := SyntheticSource.new()
	source.loop = true
	var tracker := _tracker(source)
	tracker.frame_received.connect(func(_frame: HandFrame) -> void: tracker.advance(0.1))
	tracker.start()
	tracker.advance(0.1)
	check(tracker.is_running(), "it goes on")
	tracker.free()


func test_a_device_whose_clock_is_ahead_is_polled_on() -> void:
	var source := AheadSource.new()
	var tracker := HandTracker.new()
	tracker.source = source
	root.add_child(tracker)
	for frame in 10:
		await process_frame
	check(source.polls > 5, "%d polls" % source.polls)
	tracker.free()


func test_live_sources_keep_pace_in_physics_frames_and_pauses() -> void:
	var hand := XRHand.new()
	hand.register()
	var modes: Array[HandTracker.UpdateMode] = [
		HandTracker.UPDATE_IDLE, HandTracker.UPDATE_PHYSICS, HandTracker.UPDATE_IDLE
	]
	Engine.max_fps = 144
	for i in modes.size():
		Engine.time_scale = 0.0 if i == 2 else 1.0
		var tracker := HandTracker.new()
		tracker.source = XRSource.new()
		tracker.update_mode = modes[i]
		root.add_child(tracker)
		var began_us := Time.get_ticks_usec()
		var from_s := tracker.get_time()
		while Time.get_ticks_usec() - began_us < 600000:
			hand.place(PLACE + PushedHand.tremor(1e-6 * Time.get_ticks_usec()))
			await process_frame
		var pace := (tracker.get_time() - from_s) / (1e-6 * (Time.get_ticks_usec() - began_us))
		check_near(pace, 1.0, 0.1, "mode %d, scale %s" % [modes[i], Engine.time_scale])
		tracker.free()
	Engine.time_scale = 1.0
	Engine.max_fps = 0
	hand.remove()


func test_a_placed_synthetic_hand_moves_at_its_task() -> void:
	for gesture: StringName in [&"horizontal_drag", &"vertical_drag", &"tap"]:
		var task := GestureTask.new()
		task.gesture = gesture
		task.position = Vector3(2.0, 1.0, -3.0)
		task.rotation = Vector3(0.3, 1.0, -0.2)
		task.direction = Vector3.DOWN
		task.amplitude = 0.15
		root.add_child(task)
		var source := SyntheticSource.new()
		source.placement = SyntheticSource.PLACEMENT_TASK
		source.task_path = ^"../Task"
		task.name = &"Task"
		var tracker := _tracker(source)
		check_equal(tracker.start(), OK, "%s at a task" % gesture)
		var hmm := GestureHMM.new()
		hmm.models = [load(Rig.MODEL % gesture) as GestureModel]
		hmm.tracker = tracker
		hmm.task = task
		root.add_child(hmm)
		while not tracker.is_finished():
			tracker.advance(FRAME_S)
		check_equal(hmm.recognised, gesture, "%s: it is recognised there" % gesture)
		source.place_at(task)
		check_equal(source.placement, SyntheticSource.PLACEMENT_FIXED, "place_at() fixes it")
		check_equal(source.start, task.position, "at the task's start")
		for node: Node in [hmm, tracker, task]:
			node.free()


func test_the_true_motion_is_the_reference_of_the_measured_one() -> void:
	var seen := SyntheticSource.new()
	seen.gesture = &"vertical_drag"
	seen.position = SyntheticSource.POSITION_UNSTABLE
	seen.subject = 3
	var truth := seen.duplicate() as SyntheticSource
	truth.true_motion = true
	var ends: Array[Vector3] = []
	for source: SyntheticSource in [seen, truth]:
		var tracker := _tracker(source)
		var frames: Array[HandFrame] = []
		tracker.frame_received.connect(func(frame: HandFrame) -> void: frames.append(frame))
		tracker.start()
		tracker.advance_to(source.get_trial()["end_s"])
		ends.append(tracker.get_joint_position(HandTracker.JOINT_INDEX))
		if source.true_motion:
			var is_whole := frames.all(func(frame: HandFrame) -> bool: return frame.is_tracked())
			check(is_whole, "the reference has no dropouts")
			check_near(tracker.frame_rate, 240.0, 1.0, "its rate")
		tracker.free()
	check(ends[0].distance_to(ends[1]) > 1e-4, "the simulated tracker has errors")
	check(ends[0].distance_to(ends[1]) < 0.1, "both have the same motion")


func test_a_degraded_source_adds_its_faults() -> void:
	var degraded := DegradedSource.new()
	# expects one error: a source cannot degrade itself
	degraded.source = degraded
	check(degraded.source == null, "not itself")
	# expects one error: set "source" of the DegradedSource
	var tracker := _tracker(degraded)
	check_equal(tracker.start(), ERR_CANT_OPEN, "nothing to degrade")
	degraded.source = ScriptSource.new()
	degraded.preset = DegradedSource.PRESET_UNSTABLE
	check(degraded.drift > 0.0 and degraded.latency > 0.0, "a preset sets the properties")
	degraded.preset = DegradedSource.PRESET_STABLE
	degraded.latency = 0.1
	check_equal(degraded.preset, DegradedSource.PRESET_CUSTOM, "a changed property makes it custom")
	# expects one error: DegradedSource: noise must be finite, and 0 (off) or more, is nan
	degraded.noise = NAN
	var late := DegradedSource.new()
	late.source = ScriptSource.new()
	late.latency = 0.1
	tracker.source = late
	tracker.start()
	for frame in 100:
		tracker.push_frame(frame * FRAME_S, {INDEX: Vector3(0.001 * frame, 1, 0)})
	check_near(tracker.get_joint_position(INDEX).x, 0.089, 1e-6, "0.1 s late")
	check_near(tracker.get_time(), 0.99, 1e-9, "the frame keeps its time")
	tracker.free()


func _is_measured(hand: XRHandTracker, joint: int) -> bool:
	return hand.get_hand_joint_flags(joint) & XRHand.TRACKED == XRHand.TRACKED


func _tracker(source: HandSource) -> HandTracker:
	var tracker := HandTracker.new()
	tracker.source = source
	tracker.autostart = false
	tracker.update_mode = HandTracker.UPDATE_MANUAL
	root.add_child(tracker)
	if source is XRSource:
		tracker.start()
	return tracker
