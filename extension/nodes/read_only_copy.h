#pragma once

#include <godot_cpp/variant/typed_array.hpp>

namespace godot {

/// For the getter of a property. A change of the array would have no effect, and is an error of the engine.
template <typename T> TypedArray<T> read_only_copy(const TypedArray<T> &p_array) {
	TypedArray<T> copy = p_array.duplicate();
	copy.make_read_only();
	return copy;
}

} // namespace godot
