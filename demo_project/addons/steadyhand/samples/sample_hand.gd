extends HandTracker
## The hand of a sample: an OpenXR hand, the mouse, or a hand that demonstrates the sample. Copy it
## to choose the source of your own game's HandTracker from the available devices.

enum Device { AUTOMATIC, OPENXR, MOUSE, SHOWN }

## AUTOMATIC: OpenXR if it runs, else the mouse; or what is in `source`, for example a recording.
@export var device := Device.AUTOMATIC
## The sample's. The mouse and the demonstrating hand move at its tasks.
@export var gesture_hmm: GestureHMM

## Demonstrates the sample. Null: the user's hand or mouse is used.
var _shown: GestureTestHand = null
var _turn := 0


func _ready() -> void:
	if device != Device.AUTOMATIC or source == null:
		# The sample may make its tasks in _ready(), which runs after that of its children.
		owner.ready.connect(use.bind(device))


func _process(_delta: float) -> void:
	if _shown != null and not _shown.is_busy:
		_shown.make_gesture(gesture_hmm.tasks[_turn % gesture_hmm.tasks.size()])
		_turn += 1


func _unhandled_key_input(event: InputEvent) -> void:
	if event.is_pressed() and not event.is_echo() and (event as InputEventKey).keycode == KEY_S:
		use(Device.AUTOMATIC if _shown != null else Device.SHOWN)


func use(new_device: Device) -> void:
	_shown = null
	if new_device == Device.SHOWN:
		_shown = GestureTestHand.attach(self)
		_shown.pinches = gesture_hmm.start_condition == GestureHMM.START_PINCH
	elif new_device == Device.OPENXR or (new_device == Device.AUTOMATIC and is_xr_running()):
		source = XRSource.new()
		# OpenXR predicts where the hand is when the frame is shown.
		gesture_hmm.sensor_latency = 0.0
	else:
		var mouse := MouseSource.new()
		mouse.place_at(gesture_hmm.task)
		source = mouse


static func is_xr_running() -> bool:
	var interface := XRServer.primary_interface
	return interface != null and interface.is_initialized()
