extends "support/scene_test.gd"
## Another output device may have another mix rate, and the engine sends no signal. Its dummy driver
## has one device only, so a second engine plays to ALSA devices that accept any rate.

const HeardSpring := preload("support/heard_spring.gd")

const DEVICES := """pcm.!default { type null }
pcm.plughw_other { type null hint { show on description other } }
"""
const IN_IT := "with ALSA"
const FREQUENCY_HZ := 180.0
const OTHER_RATE_HZ := 22050.0
const LEVEL := 0.5
## The vibration fades after the last motion, and these devices play it at once.
const HEARD_FROM := 0.1
const ENOUGH_PERIODS := 10
const ATTEMPTS := 200


func test_the_frequency_is_the_same_on_another_device() -> void:
	if OS.get_cmdline_user_args().has(IN_IT):
		await _change_device()
		return
	var folder := DirAccess.create_temp("steadyhand_devices")
	var devices := folder.get_current_dir().path_join("asound.conf")
	FileAccess.open(devices, FileAccess.WRITE).store_string(DEVICES)
	OS.set_environment("ALSA_CONFIG_PATH", devices)
	var arguments := ["--headless", "--audio-driver", "ALSA", "--path"]
	arguments.append(ProjectSettings.globalize_path("res://"))
	arguments.append_array(["--script", get_script().resource_path, "--", IN_IT])
	var output := []
	var exit_code := OS.execute(OS.get_environment("GODOT"), arguments, output, true)
	var text := "\n".join(output)
	if text.contains("SKIP") or text.contains("Unknown audio driver"):
		skip("no ALSA here")
		return
	check(exit_code == 0, "heard with ALSA" + ("" if exit_code == 0 else ": " + text))


func _change_device() -> void:
	if AudioServer.get_driver_name() != "ALSA":
		skip("no ALSA here")
		return
	AudioServer.add_bus()
	var bus := AudioServer.bus_count - 1
	AudioServer.set_bus_name(bus, HeardSpring.BUS)
	var spring := HeardSpring.new(self, bus)
	check_near(await _heard_hz(spring), FREQUENCY_HZ, 0.1, "Hz on the first device")
	ProjectSettings.set_setting("audio/driver/mix_rate", OTHER_RATE_HZ)
	AudioServer.output_device = AudioServer.get_output_device_list()[-1]
	var began_ms := Time.get_ticks_msec()
	while not _is_other() and Time.get_ticks_msec() - began_ms < 5000:
		await process_frame
	check(_is_other(), "another rate")
	check_near(await _heard_hz(spring), FREQUENCY_HZ, 0.1, "Hz on the other one")
	spring.free_nodes()


static func _is_other() -> bool:
	return AudioServer.get_mix_rate() == OTHER_RATE_HZ


## The median of all periods, recorded right after frames with motion. These devices consume samples
## as fast as the machine mixes them, which may be seconds of sound between two frames.
func _heard_hz(spring: HeardSpring) -> float:
	await spring.settle(LEVEL, 0.5)
	var periods: Array[float] = []
	for attempt in ATTEMPTS:
		periods.append_array(_periods(await spring.record_frame(LEVEL)))
		if periods.size() >= ENOUGH_PERIODS:
			break
	periods.sort()
	return AudioServer.get_mix_rate() / periods[periods.size() / 2] if periods else 0.0


## Periods in samples.
static func _periods(samples: PackedFloat32Array) -> Array[float]:
	var periods: Array[float] = []
	var last := -1.0
	var high := 0.0
	for i in range(1, samples.size()):
		high = maxf(high, samples[i])
		if samples[i - 1] < 0.0 and samples[i] >= 0.0:
			var at := i - samples[i] / (samples[i] - samples[i - 1])
			if last >= 0.0 and high > HEARD_FROM:
				periods.append(at - last)
			last = at
			high = 0.0
	return periods
