extends Node
## The parts of GUT and gdUnit4 that the add-on's templates use, to run them without a framework.

var failures: Array[String] = []

var _emitted: Array[Array] = []


func add_child_autofree(node: Node) -> Node:
	add_child(node)
	return node


func auto_free(node: Node) -> Node:
	return node


func watch_signals(watched: Object) -> void:
	watched.connect(&"key_pressed", func(key: String) -> void: _emitted.append([key]))


func assert_signal_emitted_with_parameters(_o: Object, what: String, expected: Array) -> void:
	_check(not _emitted.is_empty() and _emitted[-1] == expected, "%s: %s" % [what, _emitted])


func assert_true(condition: bool, what: String) -> void:
	_check(condition, what)


func assert_bool(value: bool) -> Claim:
	return Claim.new(self, value)


func assert_array(value: Array) -> Claim:
	return Claim.new(self, value)


func _check(condition: bool, what: String) -> void:
	if not condition:
		failures.append(what)


class Claim:
	extends RefCounted
	var _test: Node
	var _value: Variant

	func _init(test: Node, value: Variant) -> void:
		_test = test
		_value = value

	func is_true() -> void:
		_test.call("_check", _value, "it is false")

	func is_equal(expected: Variant) -> void:
		_test.call("_check", _value == expected, "%s instead of %s" % [_value, expected])
