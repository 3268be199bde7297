extends Resource
## A resource that finds misspelt properties in its file. Godot leaves them out without a message.

var _unknown := PackedStringArray()


func _set(property: StringName, _value: Variant) -> bool:
	if property not in self and not property.begins_with("metadata/"):
		_unknown.append(property)
	return false


## A problem for each property of the file that this class does not have.
func unknown_properties() -> PackedStringArray:
	var found := PackedStringArray()
	for property in _unknown:
		found.append("%s: unknown property '%s': correct or remove it." % [resource_path, property])
	return found
