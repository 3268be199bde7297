extends "support/scene_test.gd"
## The vibration's strength at an XR controller and a joypad. An XR interface of the test's own
## stands in for the headset; of a joypad the engine remembers what it was told, there or not.

const Rig := preload("support/rig.gd")

const FRAME_S := 1.0 / 90.0
const JOYPAD := 3


class ListeningInterface:
	extends XRInterfaceExtension
	var pulses: Array[Dictionary] = []

	func _get_name() -> StringName:
		return &"Listening"

	func _initialize() -> bool:
		return true

	func _is_initialized() -> bool:
		return true

	func _trigger_haptic_pulse(
		action: String,
		tracker: StringName,
		frequency: float,
		amplitude: float,
		duration: float,
		_delay: float
	) -> void:
		pulses.append(
			{
				action = action,
				tracker = tracker,
				frequency = frequency,
				amplitude = amplitude,
				duration = duration
			}
		)


var _folder := DirAccess.create_temp("steadyhand_pulses")
var _trials := Rig.write_trials(_folder.get_current_dir(), 1, "horizontal_drag")
var _interface := ListeningInterface.new()


func test_a_controller_that_is_freed_is_none() -> void:
	var synth := HapticSynth.new()
	var controller := XRNode3D.new()
	synth.controller = controller
	check(synth.controller == controller, "until then it is there")
	controller.free()
	check(synth.controller == null, "a controller that is freed is none")
	synth.free()


func test_a_controller_feels_the_spring_and_the_end() -> void:
	XRServer.add_interface(_interface)
	XRServer.primary_interface = _interface
	var controller := XRNode3D.new()
	controller.tracker = &"right_hand"
	root.add_child(controller)
	var played := _play(func(synth: HapticSynth) -> void: synth.controller = controller)
	var pulses := _interface.pulses
	check(pulses.size() > 10, "%d pulses" % pulses.size())
	var loudest := 0.0
	for pulse in pulses:
		loudest = maxf(loudest, pulse["amplitude"])
	check(loudest > 0.8 and loudest <= 1.0, "the spring is stretched: %s" % loudest)
	check_equal(pulses[0]["action"], "haptic", "the action")
	check_equal(pulses[0]["tracker"], &"right_hand", "the tracker")
	check_near(pulses[0]["frequency"], 180.0, 1e-6, "the frequency")
	check(pulses[0]["duration"] <= 0.1, "it ends by itself")
	check_equal(pulses[-1]["amplitude"], 0.0, "the end is told")
	var most: int = ceili(played["seconds"] / 0.02) + 2
	check(pulses.size() <= most, "%d pulses in %s s" % [pulses.size(), played["seconds"]])
	controller.free()
	XRServer.primary_interface = null
	XRServer.remove_interface(_interface)


func test_a_joypad_shakes_and_stops_at_pause_and_exit() -> void:
	var told := {}
	var each := func(synth: HapticSynth, value: float) -> void:
		var strength := Input.get_joy_vibration_strength(JOYPAD)
		told["light"] = maxf(told.get("light", 0.0), strength.x)
		told["heavy"] = maxf(told.get("heavy", 0.0), strength.y)
		if value > 0.5 and not told.has("paused"):
			check(strength.x > 0.3, "half-way: %s" % strength)
			paused = true
			told["paused"] = Input.get_joy_vibration_strength(JOYPAD)
			paused = false
		elif value > 0.7 and not told.has("gone"):
			check(strength.x > 0.3, "again after the pause: %s" % strength)
			root.remove_child(synth)
			told["gone"] = Input.get_joy_vibration_strength(JOYPAD)
			root.add_child(synth)
	_play(func(synth: HapticSynth) -> void: synth.joypad = JOYPAD, each)
	check_equal(told["paused"], Vector2.ZERO, "stopped at a pause")
	check_equal(told["gone"], Vector2.ZERO, "stopped out of the tree")
	check(told["light"] > 0.8, "180 Hz is the light motor's: %s" % told["light"])
	check_equal(told["heavy"], 0.0, "and not the heavy one's")
	check_equal(Input.get_joy_vibration_strength(JOYPAD), Vector2.ZERO, "at rest in the end")


func test_the_warning_of_a_missing_joypad_follows_joypads_that_come_and_go() -> void:
	var synth := HapticSynth.new()
	synth.joypad = JOYPAD
	root.add_child(synth)
	edited_scene_root = synth
	var refreshed: Array[Node] = []
	var note := func(node: Node) -> void: refreshed.append(node)
	node_configuration_warning_changed.connect(note)
	Input.joy_connection_changed.emit(JOYPAD, true)
	check_equal(refreshed.size(), 1, "one has come")
	Input.joy_connection_changed.emit(JOYPAD + 1, true)
	check_equal(refreshed.size(), 1, "another's coming is no matter")
	Input.joy_connection_changed.emit(JOYPAD, false)
	check_equal(refreshed.size(), 2, "it is gone")
	edited_scene_root = null
	root.remove_child(synth)
	Input.joy_connection_changed.emit(JOYPAD, true)
	check_equal(refreshed.size(), 2, "out of the tree nothing is heard")
	node_configuration_warning_changed.disconnect(note)
	synth.free()


func test_what_is_missing_is_said_once() -> void:
	# expects one warning: Connect joypad 7,
	# expects one warning: Connect joypad 8,
	# expects one warning: Set the "tracker" of the node in "controller"
	var synth := HapticSynth.new()
	synth.joypad = 7
	var controller := XRNode3D.new()
	for node: Node in [controller, synth]:
		root.add_child(node)
	synth.controller = controller
	synth.controller_action = &"pulse"
	root.remove_child(synth)
	root.add_child(synth)
	synth.joypad = 8
	check_equal(synth.joypad, 8, "another that is not there is said too")
	for node: Node in [synth, controller]:
		node.free()


func test_low_frequencies_are_the_heavy_motor_s() -> void:
	var heaviest := [0.0]
	var each := func(_synth: HapticSynth, _value: float) -> void:
		heaviest[0] = maxf(heaviest[0], Input.get_joy_vibration_strength(JOYPAD).y)
	var prepare := func(synth: HapticSynth) -> void:
		var device := HapticDeviceProfile.new()
		device.resonance = 60.0
		synth.device = device
		synth.joypad = JOYPAD
	_play(prepare, each)
	check(heaviest[0] > 0.5, "a device that resonates at 60 Hz: %s" % heaviest[0])


## A drag at 90 frames a second. `each` is called after every frame with the motion's value, shares
## of the amplitude.
func _play(prepare: Callable, each: Callable = Callable()) -> Dictionary:
	var rig := Rig.new(_trials.get_trial(0), _trials.get_measured_path(0), root)
	var synth := HapticSynth.new()
	synth.gesture_hmm = rig.gesture_hmm
	prepare.call(synth)
	root.add_child(synth)
	rig.tracker.start()
	var begun_s := rig.tracker.get_start_time()
	var end_s := begun_s + rig.tracker.get_duration()
	var frame := 0
	while begun_s + frame * FRAME_S < end_s:
		rig.tracker.advance_to(begun_s + frame * FRAME_S)
		if each.is_valid():
			each.call(synth, rig.gesture_hmm.value / rig.task.amplitude)
		frame += 1
	synth.free()
	rig.free_nodes()
	return {seconds = end_s - begun_s}
