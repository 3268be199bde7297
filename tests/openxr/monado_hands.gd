extends RefCounted
## The two hands of Monado's remote driver. A thread sends their positions 100 times a second.

enum Hand { LEFT, RIGHT }

const PORT := 4242
const WAIT_S := 10.0
const STEP_US := 10000
## Monado 25's packet: a header, the head, the left and the right hand.
const SIZE := 376
const MAGIC := "mndrmt3"
const OFFSETS: Array[int] = [136, 256]
const ROTATION_W := 12
const POSITION := 16
const CURLS: Array[float] = [0.2, 0.0, 1.0, 1.0, 1.0]
const FIRST_CURL := 52
const IS_HAND_TRACKED := 104
const IS_ACTIVE := 105

const PushedHand := preload("../scenes/support/pushed_hand.gd")

var _connection := StreamPeerTCP.new()
var _packet := PackedByteArray()
var _thread := Thread.new()
var _mutex := Mutex.new()
var _is_running := true
var _from: Array[Vector3] = [Vector3(-0.3, 1.2, -0.4), Vector3(0.1, 1.2, -0.4)]
var _to: Array[Vector3] = _from.duplicate()
var _begin_s: Array[float] = [0.0, 0.0]
var _seconds: Array[float] = [1.0, 1.0]
var _is_tracked: Array[bool] = [true, true]


## What failed, or nothing.
func start() -> String:
	var until_s := _now_s() + WAIT_S
	_connection.connect_to_host("127.0.0.1", PORT)
	while _connection.get_status() != StreamPeerTCP.STATUS_CONNECTED:
		if _now_s() > until_s:
			return "Monado's remote driver does not listen on port %d" % PORT
		if _connection.get_status() == StreamPeerTCP.STATUS_ERROR:
			_connection.disconnect_from_host()
			_connection.connect_to_host("127.0.0.1", PORT)
		OS.delay_msec(20)
		_connection.poll()
	_connection.set_no_delay(true)
	# Monado first sends how its devices begin, then how they are.
	for packet in 2:
		var received := _connection.get_data(SIZE)
		_packet = received[1]
		if received[0] != OK or _packet.slice(0, MAGIC.length()).get_string_from_ascii() != MAGIC:
			return "Monado's remote driver speaks another version of its protocol"
	_thread.start(_send_all)
	return ""


func stop() -> void:
	_mutex.lock()
	_is_running = false
	_mutex.unlock()
	if _thread.is_started():
		_thread.wait_to_finish()


## Moves it there within `seconds`, from where it was to go before.
func move(hand: Hand, to: Vector3, seconds: float) -> void:
	_mutex.lock()
	_from[hand] = _to[hand]
	_to[hand] = to
	_begin_s[hand] = _now_s()
	_seconds[hand] = seconds
	_mutex.unlock()


func position(hand: Hand) -> Vector3:
	return _to[hand]


func set_tracked(hand: Hand, is_tracked: bool) -> void:
	_mutex.lock()
	_is_tracked[hand] = is_tracked
	_mutex.unlock()


func _send_all() -> void:
	while true:
		_mutex.lock()
		var is_running := _is_running
		_write(Hand.LEFT)
		_write(Hand.RIGHT)
		_mutex.unlock()
		if not is_running or _connection.put_data(_packet) != OK:
			return
		OS.delay_usec(STEP_US)


func _write(hand: Hand) -> void:
	var at := OFFSETS[hand]
	var now_s := _now_s()
	var share := PushedHand.share((now_s - _begin_s[hand]) / _seconds[hand])
	var place := _from[hand].lerp(_to[hand], share) + PushedHand.tremor(now_s)
	for i in 3:
		_packet.encode_float(at + 4 * i, 0.0)
		_packet.encode_float(at + POSITION + 4 * i, place[i])
	_packet.encode_float(at + ROTATION_W, 1.0)
	for i in CURLS.size():
		_packet.encode_float(at + FIRST_CURL + 4 * i, CURLS[i])
	_packet[at + IS_HAND_TRACKED] = int(_is_tracked[hand])
	_packet[at + IS_ACTIVE] = 1


func _now_s() -> float:
	return 1e-6 * Time.get_ticks_usec()
