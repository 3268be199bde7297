extends "support/scene_test.gd"
## Lag and rigid offset of two trackers of one hand, through the nodes.

const INDEX := HandTracker.JOINT_INDEX
const LAG_S := 0.06
const SECONDS := 12.0
const REFERENCE_HZ := 240.0
const TRACKER_HZ := 90.0


class Pair:
	extends Node
	## Two trackers with ScriptSources; the second one is turned, shifted and late.

	var reference := HandTracker.new()
	var tracker := HandTracker.new()
	var alignment := TrackerAlignment.new()
	var offset := Transform3D(Basis(Vector3(1, 2, -1).normalized(), 0.8), Vector3(0.5, -0.2, 1.0))

	func _init() -> void:
		for node: HandTracker in [reference, tracker]:
			node.source = ScriptSource.new()
			node.autostart = false
			add_child(node)
		add_child(alignment)
		alignment.reference = reference
		alignment.tracker = tracker

	static func hand(time_s: float) -> Vector3:
		return Vector3(
			0.15 * sin(1.9 * time_s) + 0.03 * sin(8.6 * time_s),
			1.2 + 0.12 * sin(2.9 * time_s + 1.0),
			-0.4 + 0.1 * sin(4.6 * time_s + 2.0)
		)

	## Both see the hand from `from_s` on. `place` is the tracker's device_transform, if it has one.
	func see(from_s: float, to_s: float, place := Transform3D.IDENTITY) -> void:
		for frame in range(ceili(from_s * REFERENCE_HZ), floori(to_s * REFERENCE_HZ)):
			var time_s := frame / REFERENCE_HZ
			reference.push_frame(time_s, {INDEX: hand(time_s)})
		var to_tracker := place * offset.affine_inverse()
		for frame in range(ceili(from_s * TRACKER_HZ), floori(to_s * TRACKER_HZ)):
			var time_s := frame / TRACKER_HZ
			tracker.push_frame(time_s, {INDEX: to_tracker * hand(time_s - LAG_S)})

	func run() -> void:
		for node: HandTracker in [reference, tracker]:
			node.start()
		alignment.start()


func test_two_trackers_are_aligned() -> void:
	var pair := _pair()
	var alignment := pair.alignment
	check(not alignment.is_running(), "it waits for start()")
	check(is_nan(alignment.lag) and is_nan(alignment.residual), "no result yet")
	pair.see(0.0, 1.0)
	check_equal(alignment.duration, 0.0, "it collects nothing before start()")
	pair.run()
	check(alignment.is_running(), "it runs")
	pair.see(0.0, SECONDS)
	check_near(alignment.duration, SECONDS, 0.05, "duration")
	alignment.stop()
	pair.see(SECONDS, SECONDS + 1.0)
	check_near(alignment.duration, SECONDS, 0.05, "stop() ends it")
	check_equal(alignment.solve(), OK, "it is solved: %s" % alignment.error_message)
	check_near(alignment.lag, LAG_S, 0.0005, "lag")
	check_near(alignment.residual, 0.0, 0.0003, "residual")
	check(alignment.residual_max >= alignment.residual, "its maximum")
	check(alignment.sample_count > 1000, "samples")
	check(_is_near(alignment.transform, pair.offset), "transform")
	check_equal(alignment.error_message, "", "no error")
	pair.free()


func test_the_result_moves_a_liberty() -> void:
	var pair := _pair()
	var alignment := pair.alignment
	var place := Transform3D(Basis(Vector3.UP, 0.5), Vector3(0, 1, 0))
	var liberty := LibertySource.new()
	liberty.device_transform = place
	check_equal(alignment.apply(), ERR_UNCONFIGURED, "nothing to apply")
	check(alignment.error_message.contains("call solve()"), "the error message")
	pair.run()
	pair.see(0.0, SECONDS, place)
	alignment.stop()
	pair.tracker.source = liberty
	check_equal(alignment.solve(), OK, "it is solved")
	check_equal(alignment.apply(), OK, "and applied: %s" % alignment.error_message)
	check(_is_near(liberty.device_transform, pair.offset), "the source is at the reference's place")
	check_equal(alignment.apply(), ERR_ALREADY_EXISTS, "not twice")
	check(_is_near(liberty.device_transform, pair.offset), "it is not moved again")
	check_equal(alignment.solve(), ERR_INVALID_DATA, "positions from before are cleared")
	pair.free()


func test_an_inapplicable_result_gives_the_reason() -> void:
	var headset := LeapSource.new()
	headset.mounting = LeapSource.MOUNTING_HMD
	for source: HandSource in [ScriptSource.new(), XRSource.new(), headset]:
		var pair := _solved()
		pair.tracker.source = source
		check_equal(pair.alignment.apply(), ERR_UNAVAILABLE, source.get_class())
		check(pair.alignment.error_message.contains("no device_transform"), "the reason")
		pair.free()
	var moved := _solved()
	var leap := LeapSource.new()
	leap.device_transform = Transform3D(Basis.IDENTITY, Vector3.ONE)
	moved.tracker.source = leap
	check_equal(
		moved.alignment.apply(), ERR_INVALID_DATA, "refused for a device that was moved since"
	)
	moved.reference.source = leap
	check_equal(moved.alignment.apply(), ERR_UNAVAILABLE, "refused for one source of both")
	moved.free()


func test_errors_name_the_remedy() -> void:
	var alignment := TrackerAlignment.new()
	check_equal(alignment.start(), ERR_UNCONFIGURED, "no trackers")
	check(alignment.error_message.contains("two HandTrackers"), "the error message")
	var tracker := HandTracker.new()
	alignment.reference = tracker
	alignment.tracker = tracker
	check_equal(alignment.start(), ERR_UNCONFIGURED, "one tracker twice")
	check_equal(alignment.solve(), ERR_INVALID_DATA, "no samples")
	check(alignment.error_message.contains("no samples of the reference"), alignment.error_message)
	# expects one error: joint must be one of HandTracker.JOINT_*
	alignment.joint = 7 as HandTracker.Joint
	check_equal(alignment.joint, INDEX, "an unknown joint is refused")
	tracker.free()
	alignment.free()
	var pair := _pair()
	pair.run()
	pair.see(0.0, 3.0)
	check_equal(pair.alignment.solve(), ERR_INVALID_DATA, "3 s")
	check(pair.alignment.error_message.contains("at least 5 s"), pair.alignment.error_message)
	check(pair.alignment.is_running(), "it goes on")
	pair.see(3.0, 8.0)
	check_equal(pair.alignment.solve(), OK, "8 s are enough")
	pair.free()


func test_a_restarted_tracker_clears_the_positions() -> void:
	var pair := _pair()
	pair.run()
	pair.see(0.0, SECONDS)
	pair.tracker.start()
	check_equal(pair.alignment.duration, 0.0, "the positions are cleared")
	check(pair.alignment.is_running(), "it goes on")
	pair.free()


func test_trackers_and_alignment_may_be_freed_in_any_order() -> void:
	for first in 3:
		var pair := _pair()
		pair.run()
		pair.see(0.0, 1.0)
		var nodes: Array[Node] = [pair.reference, pair.tracker, pair.alignment]
		nodes[first].free()
		if first == 0:
			check(pair.alignment.reference == null, "the reference is null")
			check(not pair.alignment.is_running(), "it stops")
			pair.tracker.push_frame(2.0, {INDEX: Vector3.ONE})
		elif first == 2:
			pair.see(1.0, 2.0)
		pair.free()
	check(true, "freed")


func test_the_code_of_the_docs() -> void:
	var docs := ProjectSettings.globalize_path("res://").path_join("../docs/devices.md")
	var text := FileAccess.get_file_as_string(docs).get_slice("as the reference of another\n", 1)
	var code := text.get_slice("```gdscript\n", 1).get_slice("```", 0)
	var script := GDScript.new()
	var head := "extends RefCounted\n\nfunc run(alignment: TrackerAlignment) -> void:\n"
	script.source_code = head + code.indent("\t")
	check_equal(script.reload(), OK, "it compiles")
	var liberty := LibertySource.new()
	var pair := _pair()
	pair.run()
	pair.see(0.0, SECONDS)
	pair.alignment.stop()
	pair.tracker.source = liberty
	(script.new() as RefCounted).call("run", pair.alignment)
	check(_is_near(liberty.device_transform, pair.offset), "the device is moved")
	pair.free()


func test_the_panel_guides_and_shows_the_residual() -> void:
	var panel := (load("res://addons/steadyhand/alignment_panel.tscn") as PackedScene).instantiate()
	root.add_child(panel)
	panel.call("begin")
	_check_shows(panel, 'Set "alignment"')
	var pair := _pair()
	panel.set("alignment", pair.alignment)
	for node: HandTracker in [pair.reference, pair.tracker]:
		node.start()
	(panel.get_node("Panel/Rows/Align") as Button).pressed.emit()
	_check_shows(panel, "all directions for 10 s")
	pair.see(0.0, 5.0)
	await process_frame
	await process_frame
	check_near((panel.get_node("Panel/Rows/Progress") as ProgressBar).value, 0.5, 0.02, "progress")
	pair.see(5.0, SECONDS)
	await process_frame
	await process_frame
	_check_shows(panel, "lag 60.")
	_check_shows(panel, 'not applied: the source of "tracker"')
	check(not pair.alignment.is_running(), "it stops")
	for node: Node in [panel, pair]:
		node.free()


func _pair() -> Pair:
	var pair := Pair.new()
	root.add_child(pair)
	for node: HandTracker in [pair.reference, pair.tracker]:
		node.start()
	return pair


func _solved() -> Pair:
	var pair := _pair()
	pair.run()
	pair.see(0.0, SECONDS)
	pair.alignment.stop()
	check_equal(pair.alignment.solve(), OK, "it is solved")
	return pair


func _is_near(one: Transform3D, other: Transform3D) -> bool:
	var is_turned_alike := (
		one.basis.get_rotation_quaternion().angle_to(other.basis.get_rotation_quaternion()) < 0.002
	)
	return is_turned_alike and one.origin.distance_to(other.origin) < 0.002


func _check_shows(panel: Node, text: String) -> void:
	var shown: String = panel.call("describe")
	check(shown.contains(text), ("'%s' is in '%s'" % [text, shown]).replace("\n", " / "))
