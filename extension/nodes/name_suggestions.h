#pragma once

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>

namespace godot {

/// The inspector suggests these names, and accepts any other.
inline void suggest(const PackedStringArray &p_names, PropertyInfo &r_property) {
	r_property.hint = PROPERTY_HINT_ENUM_SUGGESTION;
	r_property.hint_string = String(",").join(p_names);
}

} // namespace godot
