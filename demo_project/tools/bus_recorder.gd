extends RefCounted
## Records an audio bus: its samples, and when they were mixed.

const LONGEST_S := 30.0

var name: StringName
var frames := PackedVector2Array()
## Pairs: the time on the process's clock (s), and the number of frames mixed until then.
var moments := PackedFloat64Array()

var _capture := AudioEffectCapture.new()
var _pushed_before := 0


func _init(bus_name: StringName) -> void:
	name = bus_name
	AudioServer.add_bus()
	var bus := AudioServer.bus_count - 1
	AudioServer.set_bus_name(bus, bus_name)
	AudioServer.set_bus_mute(bus, false)
	_capture.buffer_length = LONGEST_S
	AudioServer.add_bus_effect(bus, _capture)


func begin() -> void:
	_capture.clear_buffer()
	_pushed_before = _capture.get_pushed_frames()
	frames.clear()
	moments.clear()


## Once a game frame.
func note() -> void:
	moments.append(now_s())
	moments.append(_capture.get_pushed_frames() - _pushed_before)


func end() -> void:
	frames = _capture.get_buffer(_capture.get_frames_available())


## Left and right in turn, 32-bit floats. The moments go into a text file of the same name.
func save(path: String) -> void:
	var file := FileAccess.open(path, FileAccess.WRITE)
	file.store_buffer(frames.to_byte_array())
	file.close()


static func now_s() -> float:
	return 1e-6 * Time.get_ticks_usec()
