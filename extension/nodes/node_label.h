#pragma once

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/variant/node_path.hpp>
#include <godot_cpp/variant/string.hpp>

namespace godot {

/// Which node of the scene a message is about.
inline String node_label(const Node &p_node) {
	return p_node.get_class() + String(" '") +
			(p_node.is_inside_tree() ? String(p_node.get_path()) : String(p_node.get_name())) + String("'");
}

} // namespace godot
