extends "support/scene_test.gd"
## Audio buses that are added, removed and renamed during a vibration.

const HeardSpring := preload("support/heard_spring.gd")
const Waveform := preload("support/waveform.gd")

const BUS := HeardSpring.BUS
const LEVEL := 0.5
const SETTLING_S := 0.3
const HEARD_S := 0.2

var _spring: HeardSpring


func test_a_bus_that_is_added_later_is_used() -> void:
	# expects error: there is no audio bus 'Wristband', so nothing is played
	_spring = HeardSpring.new(self, 0)
	check_equal(await _heard(), 0.0, "silence without the bus")
	AudioServer.add_bus()
	check_equal(await _heard(), 0.0, "silence with another bus")
	AudioServer.set_bus_name(AudioServer.bus_count - 1, BUS)
	check_near(await _heard(), LEVEL, 0.01, "vibration once the bus has the name")


func test_a_renamed_bus_is_not_used() -> void:
	var bus := AudioServer.get_bus_index(BUS)
	AudioServer.set_bus_name(bus, "Other")
	check_equal(await _heard(), 0.0, "silence on Master")
	AudioServer.set_bus_name(bus, BUS)
	check_near(await _heard(), LEVEL, 0.01, "vibration after the old name is restored")


func test_a_bus_that_is_removed_leaves_nothing_on_master() -> void:
	AudioServer.remove_bus(AudioServer.get_bus_index(BUS))
	check_equal(await _heard(), 0.0, "silence after the removal")
	AudioServer.add_bus()
	AudioServer.set_bus_name(AudioServer.bus_count - 1, BUS)
	check_near(await _heard(), LEVEL, 0.01, "vibration on a new bus of the name")
	root.remove_child(_spring.synth)
	check_equal(await _heard(), 0.0, "silence outside of the tree")
	root.add_child(_spring.synth)
	check_near(await _heard(), LEVEL, 0.01, "vibration in the tree again")
	root.remove_child(_spring.synth)
	await _heard()
	AudioServer.remove_bus(AudioServer.get_bus_index(BUS))
	root.add_child(_spring.synth)
	check_equal(await _heard(0.0), 0.0, "silence while the synth is outside of the tree")


func test_a_layout_without_the_bus() -> void:
	var layout := AudioServer.generate_bus_layout()
	AudioServer.add_bus()
	AudioServer.set_bus_name(AudioServer.bus_count - 1, BUS)
	check_near(await _heard(), LEVEL, 0.01, "vibration on the bus")
	var with_bus := AudioServer.generate_bus_layout()
	AudioServer.set_bus_layout(layout)
	check_equal(await _heard(), 0.0, "silence on Master")
	AudioServer.set_bus_layout(with_bus)
	check_near(await _heard(), LEVEL, 0.01, "vibration with a layout that has the bus")
	_spring.free_nodes()


## Peak at the output of Master.
func _heard(settling_s: float = SETTLING_S) -> float:
	if settling_s > 0.0:
		await _spring.settle(LEVEL, settling_s)
	var samples := await _spring.record(LEVEL, HEARD_S)
	var wanted := int(HEARD_S * AudioServer.get_mix_rate())
	check(samples.size() >= wanted, "Master is mixed in real time")
	return Waveform.peak(samples)
