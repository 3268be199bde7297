extends SceneTree
## A test in a headless Godot of its own, through the public API alone: runs every method whose name
## begins with `test_`, prints a line for each check and, last, `END <n> passed, <m> failed`. A
## check that needs data which is not there says SKIP. Errors of the engine that a test provokes are
## announced to the runner by a comment of that test's: `# expects error: TEXT`; warnings that must
## come: `# expects warning: TEXT`.

const AUDIO_RELEASE_S := 0.1

var _passed := 0
var _failed := 0
var _started := false


# Before the first frame the root is in no tree.
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
	# The audio thread lets go of what was freed while it played.
	await create_timer(AUDIO_RELEASE_S).timeout
	print("END %d passed, %d failed" % [_passed, _failed])
	quit(0 if _failed == 0 else 1)


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
