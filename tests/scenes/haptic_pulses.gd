extends "support/scene_test.gd"
## The vibration's strength at an XR controller and a joypad. A test XR interface replaces the
## headset. The engine keeps the last strength of a joypad, connected or not.

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


func test_a_freed_controller_is_null() -> void:
	var synth := HapticSynth.new()
	var controller := XRNode3D.new()
	synth.controller = controller
	check(synth.controller == controller, "it is set before")
	controller.free()
	check(synth.controller == null, "a freed controller is null")
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
	check(pulses[0]["duration"] <= 0.1, "a pulse lasts 0.1 s at most")
	check_equal(pulses[-1]["amplitude"], 0.0, "the last pulse is silent")
	var most: int = ceili(played["seconds"] / 0.02) + 2
	check(pulses.size() <= most, "%d pulses in %s s" % [pulses.size(), played["seconds"]])
	var each := func(synth: HapticSynth, value: float) -> void:
		if value > 0.5 and synth.is_inside_tree():
			check(pulses[-1]["amplitude"] > 0.0, "half-way")
			root.remove_child(synth)
			check_equal(pulses[-1]["amplitude"], 0.0, "stopped outside of the tree")
			check_near(pulses[-1]["duration"], 0.1, 1e-9, "the last pulse has a length, as at rest")
	_play(func(synth: HapticSynth) -> void: synth.controller = controller, each)
	controller.free()
	XRServer.primary_interface = null
	XRServer.remove_interface(_interface)


func test_a_tracker_without_vibration_is_warned_of() -> void:
	# expects one warning: left_hand: /user/hand_tracker/right does not vibrate
	# expects one warning: left_hand: head does not vibrate
	for name: StringName in [&"/user/hand_tracker/right", &"head", &"right_hand"]:
		var synth := HapticSynth.new()
		var controller := XRController3D.new()
		controller.tracker = name
		synth.controller = controller
		root.add_child(synth)
		synth.free()
		controller.free()


func test_a_joypad_shakes_and_stops_at_pause_and_exit() -> void:
	var strengths := {}
	var each := func(synth: HapticSynth, value: float) -> void:
		var strength := Input.get_joy_vibration_strength(JOYPAD)
		strengths["light"] = maxf(strengths.get("light", 0.0), strength.x)
		strengths["heavy"] = maxf(strengths.get("heavy", 0.0), strength.y)
		if value > 0.5 and not strengths.has("paused"):
			check(strength.x > 0.3, "half-way: %s" % strength)
			paused = true
			strengths["paused"] = Input.get_joy_vibration_strength(JOYPAD)
			paused = false
		elif value > 0.7 and not strengths.has("gone"):
			check(strength.x > 0.3, "again after the pause: %s" % strength)
			root.remove_child(synth)
			strengths["gone"] = Input.get_joy_vibration_strength(JOYPAD)
			root.add_child(synth)
	_play(func(synth: HapticSynth) -> void: synth.joypad = JOYPAD, each)
	check_equal(strengths["paused"], Vector2.ZERO, "stopped at a pause")
	check_equal(strengths["gone"], Vector2.ZERO, "stopped outside of the tree")
	check(strengths["light"] > 0.8, "180 Hz drives the light motor: %s" % strengths["light"])
	check_equal(strengths["heavy"], 0.0, "it does not drive the heavy motor")
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
	check_equal(refreshed.size(), 1, "another joypad has no effect")
	Input.joy_connection_changed.emit(JOYPAD, false)
	check_equal(refreshed.size(), 2, "it is gone")
	edited_scene_root = null
	root.remove_child(synth)
	Input.joy_connection_changed.emit(JOYPAD, true)
	check_equal(refreshed.size(), 2, "no update outside of the tree")
	node_configuration_warning_changed.disconnect(note)
	synth.free()


func test_missing_devices_are_warned_of_once() -> void:
	# expects one warning: Connect joypad 7,
	# expects one warning: Connect joypad 8,
	# expects one warning: Set the "tracker" of the node in "controller", for example
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
	check_equal(synth.joypad, 8, "another missing joypad is reported, too")
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


func test_each_motor_has_its_own_share() -> void:
	var most := [0.0, 0.0, 0.0]
	var each := func(synth: HapticSynth, _value: float) -> void:
		var strength := Input.get_joy_vibration_strength(JOYPAD)
		most[0] = maxf(most[0], strength.x)
		most[1] = maxf(most[1], strength.y)
		most[2] = maxf(most[2], synth.get_amplitude())
	for maximum: float in [1.0, 0.5]:
		most.fill(0.0)
		var prepare := func(synth: HapticSynth) -> void:
			synth.effects = [_constant(60.0, 0.3), _constant(200.0, 0.5)] as Array[HapticEffect]
			synth.device = HapticDeviceProfile.new()
			synth.device.maximum_amplitude = maximum
			synth.joypad = JOYPAD
		_play(prepare, each)
		var share := minf(maximum / 0.8, 1.0)
		check_near(most[0], 0.5 * share, 1e-6, "the light motor, with maximum %s" % maximum)
		check_near(most[1], 0.3 * share, 1e-6, "the heavy one's")
		check_near(most[2], 0.8 * share, 1e-6, "the sum is within the device's maximum")


func test_a_cue_is_advanced_by_the_latency_of_the_device() -> void:
	for latency: float in [0.0, 0.1, 0.2, 0.5]:
		var seen := {joypad = 0.0, samples = 0.0, arrived_s = INF, motor_s = INF}
		var each := func(synth: HapticSynth, _value: float) -> void:
			var time_s := synth.gesture_hmm.time
			var strength := Input.get_joy_vibration_strength(JOYPAD).x
			seen["joypad"] = maxf(seen["joypad"], strength)
			if strength > 0.0:
				seen["motor_s"] = minf(seen["motor_s"], time_s)
			if synth.get_amplitude() > 0.0:
				seen["arrived_s"] = minf(seen["arrived_s"], time_s)
			for sample in synth.get_buffer(roundi(48000.0 * FRAME_S)):
				seen["samples"] = maxf(seen["samples"], absf(sample.x))
		var prepare := func(synth: HapticSynth) -> void:
			synth.effects = [InertialViscousEffect.new()] as Array[HapticEffect]
			synth.device = HapticDeviceProfile.new()
			synth.device.latency = latency
			synth.joypad = JOYPAD
		_play(prepare, each)
		var strength: float = seen["samples"]
		check(strength > 0.4 and strength < 0.9, "%s s: %s in samples" % [latency, strength])
		check_near(seen["joypad"], strength, 0.1, "%s s: the motor has the same strength" % latency)
		var early_s: float = seen["arrived_s"] - seen["motor_s"]
		check(
			early_s > minf(latency, 0.25) - 0.03 and early_s < latency + 0.03,
			"%s s: %s s early" % [latency, early_s]
		)


func test_an_arrival_is_felt_once() -> void:
	var folder := DirAccess.create_temp("steadyhand_taps")
	var trials := Rig.write_trials(folder.get_current_dir(), 1, "tap")
	for follows: StringName in [&"nothing", &"task", &"run"]:
		var rig := Rig.new(trials.get_trial(0), trials.get_measured_path(0), root)
		var next := GestureTask.new()
		next.gesture = &"tap"
		next.position = Vector3.ONE
		root.add_child(next)
		var hmm := rig.gesture_hmm
		if follows == &"task":
			var go_on := func(
				_gesture: StringName, _time_s: float, _task: GestureTask, _fraction: float
			) -> void:
				hmm.task = next
			hmm.gesture_ended.connect(go_on)
		var synth := HapticSynth.new()
		synth.gesture_hmm = hmm
		synth.joypad = JOYPAD
		root.add_child(synth)
		rig.tracker.start()
		var begun_s := rig.tracker.get_start_time()
		var beats := 0
		var before := 0.0
		for frame in 400:
			rig.tracker.advance_to(begun_s + frame * FRAME_S)
			var strength := Input.get_joy_vibration_strength(JOYPAD).x
			beats += int(strength > before + 0.02)
			before = strength
		check_equal(beats, 1, "cue once, followed by %s" % follows)
		if follows == &"run":
			rig.tracker.source = ScriptSource.new()
			rig.tracker.start()
			var rest := {HandTracker.JOINT_INDEX: rig.task.position}
			for frame in 400:
				rig.tracker.push_frame(begun_s + frame * FRAME_S, rest)
				before = maxf(before, Input.get_joy_vibration_strength(JOYPAD).x)
				before = maxf(before, synth.get_amplitude())
			check_equal(before, 0.0, "no pulse at that time of the next run")
		synth.free()
		next.free()
		rig.free_nodes()


func _constant(frequency_hz: float, gain: float) -> SpringEffect:
	var spring := SpringEffect.new()
	spring.drive = HapticEffect.DRIVE_CONSTANT
	spring.trigger = HapticEffect.TRIGGER_ALWAYS
	spring.frequency = frequency_hz
	spring.gain = gain
	return spring


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
