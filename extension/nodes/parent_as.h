#pragma once

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/variant/node_path.hpp>

namespace godot {

/// The parent of a node if it is a `Parent`, otherwise null. It is the default of a node's property.
template <class Parent> Parent *parent_as(const Node &p_node) {
	return Object::cast_to<Parent>(p_node.get_node_or_null(NodePath("..")));
}

} // namespace godot
