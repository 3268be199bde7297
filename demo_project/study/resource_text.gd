extends RefCounted
## The properties in the text of a *.tres file.


## One per property, in order: {section (its header line), name, line (from 1), text (of the value),
## is_complete (all of its brackets and quotes are closed)}.
static func properties(text: String) -> Array[Dictionary]:
	var found: Array[Dictionary] = []
	var section := ""
	var value := Value.new()
	var lines := text.split("\n")
	for i in lines.size():
		var line := lines[i]
		if not found.is_empty() and not found[-1]["is_complete"]:
			found[-1]["text"] += "\n" + line
			found[-1]["is_complete"] = value.ends_with_line(line)
		elif line.begins_with("["):
			section = line
		elif "=" in line and not line.begins_with(";"):
			value = Value.new()
			var first := line.substr(line.find("=") + 1).strip_edges()
			var property := {section = section, name = line.get_slice("=", 0).strip_edges()}
			property.merge({line = i + 1, text = first})
			property["is_complete"] = value.ends_with_line(first)
			found.append(property)
	return found


## Whether str_to_var() may read it: it would load the resources of a value.
static func is_plain(property: Dictionary) -> bool:
	return "Resource(" not in property["text"] and "Object(" not in property["text"]


## The first property whose value cannot be read, with its line. Empty: none is found.
static func fault(text: String) -> String:
	for property in properties(text):
		if not property["is_complete"]:
			return "line %d: the value of '%s' does not end" % [property["line"], property["name"]]
		var is_null: bool = property["text"] == "null"
		if is_plain(property) and not is_null and str_to_var(property["text"]) == null:
			return "line %d: '%s' has no valid value" % [property["line"], property["name"]]
	return ""


## The state of a value that may have several lines.
class Value:
	var _depth := 0
	var _is_quoted := false
	var _has_begun := false

	## Whether the value ends with its next line.
	func ends_with_line(line: String) -> bool:
		var i := 0
		while i < line.length():
			var letter := line[i]
			if _is_quoted and letter == "\\":
				i += 1
			elif letter == '"':
				_is_quoted = not _is_quoted
			elif not _is_quoted and letter == ";":
				break  # a comment
			elif not _is_quoted:
				_depth += int(letter in "([{") - int(letter in ")]}")
			_has_begun = _has_begun or letter not in " \t\r"
			i += 1
		return _has_begun and _depth <= 0 and not _is_quoted
