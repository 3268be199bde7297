extends Resource
## A resource that finds misspelt properties and values of a wrong type in its file. Godot leaves
## them out, or converts them, without a message.

const ResourceText := preload("resource_text.gd")

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
		var problem := _type_problem(values[property], wanted)
		if property in self and not problem.is_empty():
			found.append(
				(
					"%s: '%s' is %s; %s."
					% [resource_path, property, var_to_str(values[property]), problem]
				)
			)
	return found


## The values of this resource in its text file. Resources are left out.
func _file_values() -> Dictionary[String, Variant]:
	var values: Dictionary[String, Variant] = {}
	var path := resource_path.get_slice("::", 0)
	if path.get_extension() != "tres" or not FileAccess.file_exists(path):
		return values
	var id := resource_path.get_slice("::", 1) if "::" in resource_path else ""
	var header := "[resource]" if id.is_empty() else 'id="%s"' % id
	for property in ResourceText.properties(FileAccess.get_file_as_string(path)):
		if header in property["section"] and ResourceText.is_plain(property):
			var value: Variant = str_to_var(property["text"])
			if value != null:
				values[property["name"]] = value
	return values


## Empty: Godot sets the value as it is.
static func _type_problem(value: Variant, wanted: Variant) -> String:
	var type := typeof(value)
	if value is Array and wanted is Array:
		var element: int = wanted.get_typed_builtin()
		for one: Variant in value:
			if one != null and element != TYPE_NIL and typeof(one) != element:
				return "its elements must be of type %s" % type_string(element)
		return ""
	if (
		type == typeof(wanted)
		or (type == TYPE_INT and wanted is float)
		or (type == TYPE_ARRAY and typeof(wanted) >= TYPE_PACKED_BYTE_ARRAY)
		or (type == TYPE_STRING_NAME and wanted is String)
	):
		return ""
	return "its type must be %s, not %s" % [type_string(typeof(wanted)), type_string(type)]
