extends SceneTree
## A test in a headless Godot of its own, through the public API only. Runs every method whose name
## begins with `test_`, prints a line for each check and, last, `END <n> passed, <m> failed`. A
## check whose data is missing prints SKIP. Comments of a test define which errors and warnings must
## occur: `# expects error: TEXT`, `# expects warning: TEXT`, or exactly once: `# expects one error:
## TEXT`, `# expects one warning: TEXT`. Options of the engine: `# engine options: WORDS`.

## A freed playback fades out in one mix and is released in another.
const AUDIO_RELEASE_MIXES := 4

var _passed := 0
var _failed := 0
var _started := false


# The root is in no tree before the first frame.
func _process(_delta: float) -> bool:
	if not _started:
		_started = true
		_run()
	return false


func _run() -> void:
	for method in get_method_list():
		var name: String = method["name"]
		if name.begins_with("test_"):
			await call(name)
	await _finish()


func _finish() -> void:
	for i in AUDIO_RELEASE_MIXES:
		await _audio_mixed()
	print("END %d passed, %d failed" % [_passed, _failed])
	_end(0 if _failed == 0 else 1)


func _end(status: int) -> void:
	quit(status)


## Waits for a mix of the audio thread, which may be late on a busy machine.
func _audio_mixed() -> void:
	var since_s := 0.0
	while AudioServer.get_time_since_last_mix() >= since_s:
		since_s = AudioServer.get_time_since_last_mix()
		await process_frame


func check(condition: bool, what: String) -> void:
	if condition:
		_passed += 1
		print("pass  %s" % what)
	else:
		_failed += 1
		print("FAIL  %s" % what)


func check_equal(actual: Variant, expected: Variant, what: String) -> void:
	var is_same: bool = typeof(actual) == typeof(expected) and actual == expected
	check(is_same, what if is_same else "%s: %s instead of %s" % [what, actual, expected])


func check_near(actual: float, expected: float, tolerance: float, what: String) -> void:
	var is_near := absf(actual - expected) <= tolerance
	check(is_near, "%s: %s, expected %s within %s" % [what, actual, expected, tolerance])


func skip(what: String) -> void:
	print("SKIP  %s" % what)
