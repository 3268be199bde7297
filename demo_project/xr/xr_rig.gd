extends XROrigin3D
## A seated player: headset, two tracked hands, recentring. Without a running XR interface it does
## nothing, and the scene's own camera shows the scene.
##
## Start the project with `--xr-mode on`. The space bar, or the headset's menu, moves the
## seat to the present place of the head.

signal recentred

## Place of the seated player's eyes, in the space of the origin's parent.
@export var seat := Vector3(0.0, 1.2, 0.0)

var _interface: XRInterface = null

@onready var camera: XRCamera3D = $XRCamera3D
@onready var left: HandTracker = $Left
@onready var right: HandTracker = $Right


func _ready() -> void:
	_interface = XRServer.find_interface("OpenXR")
	if not is_active():
		for tracker: HandTracker in [left, right]:
			tracker.stop()
		return
	get_viewport().use_xr = true
	camera.current = true
	DisplayServer.window_set_vsync_mode(DisplayServer.VSYNC_DISABLED)
	if _interface.has_signal(&"pose_recentered"):
		_interface.connect(&"pose_recentered", recentre)
	# The head has no pose in the first frames.
	await get_tree().create_timer(1.0).timeout
	recentre()


func _unhandled_key_input(event: InputEvent) -> void:
	var key := event as InputEventKey
	if is_active() and key.pressed and not key.echo and key.keycode == KEY_SPACE:
		recentre()


func is_active() -> bool:
	return _interface != null and _interface.is_initialized()


## Turns and moves the origin, so that the head is at the seat and looks along -z.
func recentre() -> void:
	var head := camera.transform
	var ahead := Vector3(head.basis.z.x, 0.0, head.basis.z.z)
	var turn := Basis(Vector3.UP, -atan2(ahead.x, ahead.z)) if ahead.length() > 0.1 else Basis()
	transform = Transform3D(turn, seat - turn * head.origin)
	recentred.emit()
