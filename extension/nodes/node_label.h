#pragma once

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/variant/node_path.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/variant.hpp>

namespace godot {

/// Class and path of a node, for messages. In the editor it has the name, because the path would contain the
/// editor's own nodes. Nodes of a scene that is being loaded have no name yet.
inline String node_label(const Node &p_node) {
	const bool has_path = p_node.is_inside_tree() && !p_node.is_part_of_edited_scene();
	const String name = has_path ? String(p_node.get_path()) : String(p_node.get_name());
	return name.is_empty() ? p_node.get_class() : p_node.get_class() + String(" '") + name + String("'");
}

/// Why a value is refused, e.g. "GestureTask '<path>': amplitude must be 1e-6..1e9 m, is 0.0".
inline String refusal(const String &p_where, const String &p_rule, const Variant &p_value) {
	return p_where + String(": ") + p_rule + String(", is ") + p_value.stringify();
}

inline String refusal(const Node &p_where, const String &p_rule, const Variant &p_value) {
	return refusal(node_label(p_where), p_rule, p_value);
}

} // namespace godot
