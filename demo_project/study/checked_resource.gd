extends Resource
## A resource that finds misspelt properties and values of a wrong type in its file. Godot leaves
## them out, or converts them, without a message.

var _unknown := PackedStringArray()


func _set(property: StringName, _value: Variant) -> bool:
	if property not in self and not property.begins_with("metadata/"):
		_unknown.append(property)
	return false


## A problem for each property of the file that this class does not have, and for each value of a
## wrong type.
func file_problems() -> PackedStringArray:
	var found := PackedStringArray()
	for property in _unknown:
		found.append("%s: unknown property '%s': correct or remove it." % [resource_path, property])
	var values := _file_values()
	for property in values:
		var wanted: Variant = get(property)
		if property in self and not _fits(values[property], wanted):
			(
				found
				. append(
					(
						"%s: '%s' is %s, of type %s; its type must be %s."
						% [
							resource_path,
							property,
							var_to_str(values[property]),
							type_string(typeof(values[property])),
							type_string(typeof(wanted)),
						]
					)
				)
			)
	return found


## The values of this resource in its text file. Values of several lines and resources are left out.
func _file_values() -> Dictionary[String, Variant]:
	var values: Dictionary[String, Variant] = {}
	var path := resource_path.get_slice("::", 0)
	if path.get_extension() != "tres" or not FileAccess.file_exists(path):
		return values
	var id := resource_path.get_slice("::", 1) if "::" in resource_path else ""
	var header := "[resource]" if id.is_empty() else 'id="%s"' % id
	var is_here := false
	for line in FileAccess.get_file_as_string(path).split("\n"):
		if line.begins_with("["):
			is_here = header in line
		elif is_here and " = " in line and "Resource(" not in line and "Object(" not in line:
			var value: Variant = str_to_var(line.get_slice(" = ", 1))
			if value != null:
				values[line.get_slice(" = ", 0)] = value
	return values


static func _fits(value: Variant, wanted: Variant) -> bool:
	var type := typeof(value)
	if type == typeof(wanted):
		return type != TYPE_ARRAY or _fit_elements(value, wanted)
	if type == TYPE_INT:
		return wanted is float
	if type == TYPE_ARRAY:
		return typeof(wanted) >= TYPE_PACKED_BYTE_ARRAY
	return type == TYPE_STRING and wanted is StringName


static func _fit_elements(values: Array, wanted: Array) -> bool:
	var type := wanted.get_typed_builtin()
	return values.all(func(one: Variant) -> bool: return one == null or typeof(one) == type)
