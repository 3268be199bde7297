// All builtin types that the bindings have as C++ types, and their indices in the engine's list of types.
#pragma once

#include <godot_cpp/variant/array.hpp>
#include <godot_cpp/variant/basis.hpp>
#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/color.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/node_path.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_float64_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/packed_int64_array.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/packed_vector2_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/quaternion.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/string_name.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/vector2.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include <concepts>

#define GODOT_CPP_BUILTINS(X)                                                                                \
	X(String, STRING)                                                                                        \
	X(Vector2, VECTOR2)                                                                                      \
	X(Vector3, VECTOR3)                                                                                      \
	X(Quaternion, QUATERNION)                                                                                \
	X(Basis, BASIS)                                                                                          \
	X(Transform3D, TRANSFORM3D)                                                                              \
	X(Color, COLOR)                                                                                          \
	X(StringName, STRING_NAME)                                                                               \
	X(NodePath, NODE_PATH)                                                                                   \
	X(Callable, CALLABLE)                                                                                    \
	X(Dictionary, DICTIONARY)                                                                                \
	X(Array, ARRAY)                                                                                          \
	X(PackedByteArray, PACKED_BYTE_ARRAY)                                                                    \
	X(PackedInt32Array, PACKED_INT32_ARRAY)                                                                  \
	X(PackedInt64Array, PACKED_INT64_ARRAY)                                                                  \
	X(PackedFloat32Array, PACKED_FLOAT32_ARRAY)                                                              \
	X(PackedFloat64Array, PACKED_FLOAT64_ARRAY)                                                              \
	X(PackedStringArray, PACKED_STRING_ARRAY)                                                                \
	X(PackedVector2Array, PACKED_VECTOR2_ARRAY)                                                              \
	X(PackedVector3Array, PACKED_VECTOR3_ARRAY)

namespace godot::internal {

// The engine's type of T, GDEXTENSION_VARIANT_TYPE_NIL if T is not one of the builtin classes above.
template <typename T> inline constexpr GDExtensionVariantType BUILTIN_TYPE = GDEXTENSION_VARIANT_TYPE_NIL;
#define GODOT_CPP_BUILTIN_TYPE(m_type, m_name)                                                               \
	template <>                                                                                              \
	inline constexpr GDExtensionVariantType BUILTIN_TYPE<m_type> = GDEXTENSION_VARIANT_TYPE_##m_name;
GODOT_CPP_BUILTINS(GODOT_CPP_BUILTIN_TYPE)
#undef GODOT_CPP_BUILTIN_TYPE

template <typename T>
concept Builtin = BUILTIN_TYPE<T>
!= GDEXTENSION_VARIANT_TYPE_NIL;

} // namespace godot::internal
