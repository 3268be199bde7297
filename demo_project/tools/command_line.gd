extends RefCounted
## The options of a tool: `--name value` or `--name=value`. Paths must be absolute, because Godot
## runs in the project's folder (`./steadyhand` makes them absolute).

## The error of the arguments, with the option's name. Empty: none.
var error := ""

var _values: Dictionary[String, String] = {}


## `defaults`: every known option and its default value.
func _init(arguments: PackedStringArray, defaults: Dictionary[String, String]) -> void:
	_values = defaults.duplicate()
	var i := 0
	while i < arguments.size():
		var option := arguments[i].get_slice("=", 0).trim_prefix("--")
		if not arguments[i].begins_with("--") or option not in defaults:
			error = (
				"unknown argument '%s'; known are --%s"
				% [arguments[i], " --".join(defaults.keys())]
			)
			return
		if "=" in arguments[i]:
			_values[option] = arguments[i].substr(arguments[i].find("=") + 1)
			i += 1
			continue
		if i + 1 >= arguments.size() or arguments[i + 1].begins_with("--"):
			error = "--%s needs a value" % option
			return
		_values[option] = arguments[i + 1]
		i += 2


func text(option: String) -> String:
	return _values[option]


## One of `allowed`.
func choice(option: String, allowed: Array) -> String:
	if _values[option] not in allowed:
		_report(
			"--%s is '%s'; this version has %s" % [option, _values[option], " and ".join(allowed)]
		)
	return _values[option]


## A number within the bounds. `what`: its name and unit, for the error message.
func number(option: String, lowest: float, highest: float, what: String) -> float:
	var value := _values[option].to_float()
	if not _values[option].is_valid_float() or value < lowest or value > highest:
		_report_range(option, what, lowest, highest)
	return value


## A whole number within the bounds.
func whole_number(option: String, lowest: int, highest: int) -> int:
	var value := _values[option].to_int()
	if not _values[option].is_valid_int() or value < lowest or value > highest:
		_report_range(option, "whole number", lowest, highest)
	return value


## A required option.
func given(option: String) -> String:
	if _values[option].is_empty():
		_report("--%s is missing" % option)
	return _values[option]


## A required path. It need not exist.
func path(option: String) -> String:
	given(option)
	return optional_path(option)


## Empty: not given.
func optional_path(option: String) -> String:
	var value := _values[option]
	if not value.is_empty() and not value.is_absolute_path():
		_report("--%s is '%s', which is no absolute path" % [option, value])
	return value


func _report_range(option: String, what: String, lowest: Variant, highest: Variant) -> void:
	_report(
		(
			"--%s is '%s'; it must be a %s from %s to %s"
			% [option, _values[option], what, lowest, highest]
		)
	)


func _report(message: String) -> void:
	if error.is_empty():
		error = message
