extends "support/scene_test.gd"
## Audio buses that come, go and change their names while a spring is held.

const HeardSpring := preload("support/heard_spring.gd")
const Waveform := preload("support/waveform.gd")

const BUS := HeardSpring.BUS
const LEVEL := 0.5
const SETTLING_S := 0.3
const HEARD_S := 0.2

var _spring: HeardSpring


func test_a_bus_that_comes_later_is_played_on() -> void:
	# expects error: there is no audio bus 'Wristband', so nothing is played
	_spring = HeardSpring.new(self, 0)
	check_equal(await _heard(), 0.0, "nothing without it")
	AudioServer.add_bus()
	check_equal(await _heard(), 0.0, "nor on another")
	AudioServer.set_bus_name(AudioServer.bus_count - 1, BUS)
	check_near(await _heard(), LEVEL, 0.01, "on it once it has the name")


func test_a_bus_of_another_name_is_none() -> void:
	var bus := AudioServer.get_bus_index(BUS)
	AudioServer.set_bus_name(bus, "Other")
	check_equal(await _heard(), 0.0, "nothing on Master")
	AudioServer.set_bus_name(bus, BUS)
	check_near(await _heard(), LEVEL, 0.01, "the name is back")


func test_a_bus_that_is_removed_leaves_nothing_on_master() -> void:
	AudioServer.remove_bus(AudioServer.get_bus_index(BUS))
	check_equal(await _heard(), 0.0, "while it plays")
	AudioServer.add_bus()
	AudioServer.set_bus_name(AudioServer.bus_count - 1, BUS)
	check_near(await _heard(), LEVEL, 0.01, "a new one of the name")
	root.remove_child(_spring.synth)
	check_equal(await _heard(), 0.0, "nothing out of the tree")
	root.add_child(_spring.synth)
	check_near(await _heard(), LEVEL, 0.01, "in the tree again")
	root.remove_child(_spring.synth)
	await _heard()
	AudioServer.remove_bus(AudioServer.get_bus_index(BUS))
	root.add_child(_spring.synth)
	check_equal(await _heard(0.0), 0.0, "while the synth is out of the tree")


func test_a_layout_without_the_bus() -> void:
	var layout := AudioServer.generate_bus_layout()
	AudioServer.add_bus()
	AudioServer.set_bus_name(AudioServer.bus_count - 1, BUS)
	check_near(await _heard(), LEVEL, 0.01, "on the bus")
	var with_bus := AudioServer.generate_bus_layout()
	AudioServer.set_bus_layout(layout)
	check_equal(await _heard(), 0.0, "nothing on Master")
	AudioServer.set_bus_layout(with_bus)
	check_near(await _heard(), LEVEL, 0.01, "a layout that has it")
	_spring.free_nodes()


## Peak of what comes out of Master.
func _heard(settling_s: float = SETTLING_S) -> float:
	if settling_s > 0.0:
		await _spring.settle(LEVEL, settling_s)
	var samples := await _spring.hear(LEVEL, HEARD_S)
	var wanted := int(HEARD_S * AudioServer.get_mix_rate())
	check(samples.size() >= wanted, "Master is mixed in real time")
	return Waveform.peak(samples)
