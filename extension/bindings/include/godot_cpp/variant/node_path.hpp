#pragma once

#include <godot_cpp/variant/opaque.hpp>
#include <godot_cpp/variant/string.hpp>

namespace godot {

class NodePath : public internal::Opaque<GDEXTENSION_VARIANT_TYPE_NODE_PATH, internal::NODE_PATH_SIZE> {
public:
	NodePath() = default;
	NodePath(const String &p_text);
	NodePath(const char *p_text) : NodePath(String(p_text)) {}

	bool operator==(const NodePath &p_other) const { return String(*this) == String(p_other); }
	bool operator!=(const NodePath &p_other) const { return !(*this == p_other); }

#include <godot_cpp/variant/node_path_methods.inc>
};

} // namespace godot
